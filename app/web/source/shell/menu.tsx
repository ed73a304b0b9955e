// A menu that unfolds from its button. It closes on Escape or when the focus leaves it.
import type {ComponentChildren} from "preact";
import {useEffect, useRef} from "preact/hooks";

interface MenuProps {
  /** CSS classes of the menu, and of the button that unfolds it. */
  kind?: string;
  buttonKind?: string;
  title?: string;
  /** True if the menu has no content now. */
  isOff?: boolean;
  button: ComponentChildren;
  children: ComponentChildren;
}

export function Menu({kind = "", buttonKind, title, isOff = false, button, children}: MenuProps) {
  const menu = useRef<HTMLDetailsElement>(null);
  const closeUnlessAt = (target: EventTarget | null) => {
    if (menu.current && !menu.current.contains(target as Node | null)) menu.current.open = false;
  };
  useEffect(() => {
    const away = (event: PointerEvent) => closeUnlessAt(event.target);
    document.addEventListener("pointerdown", away);
    return () => document.removeEventListener("pointerdown", away);
  }, []);
  return (
    <details
      class={`menu ${kind}`}
      ref={menu}
      onKeyDown={(event) => {
        if (event.key !== "Escape" || !menu.current?.open) return;
        menu.current.open = false;
        menu.current.querySelector("summary")?.focus();
        event.preventDefault();
        event.stopPropagation();
      }}
      onFocusOut={(event) => {
        // Clicks on elements that cannot take the focus are handled by the pointer handler.
        if (event.relatedTarget) closeUnlessAt(event.relatedTarget);
      }}
    >
      <summary class={buttonKind} title={title} aria-disabled={isOff || undefined}>
        {button}
      </summary>
      {children}
    </details>
  );
}
