// A dialog over the page: the browser's own, which keeps focus inside and closes on Escape.
import type {ComponentChildren} from "preact";
import {useEffect, useRef} from "preact/hooks";
import {Icon} from "../drawing/icons";
import {Notices} from "./notices";

export function Dialog({
  isOpen,
  title,
  onClose,
  children,
}: {
  isOpen: boolean;
  title: string;
  onClose: () => void;
  children: ComponentChildren;
}) {
  const element = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    const dialog = element.current;
    if (!dialog || dialog.open === isOpen) return;
    if (isOpen) dialog.showModal();
    else dialog.close();
  }, [isOpen]);
  return (
    <dialog
      ref={element}
      class="dialog"
      aria-label={title}
      onClose={onClose}
      onClick={(event) => {
        if (event.target === element.current) onClose();
      }}
    >
      {isOpen && (
        <div class="dialog-body">
          <header>
            <h1>{title}</h1>
            <button class="tool" title="Close (Esc)" onClick={onClose}>
              <Icon name="close" />
            </button>
          </header>
          {children}
          <Notices />
        </div>
      )}
    </dialog>
  );
}
