// A modal dialog: the browser's own dialog element, which keeps the focus inside and closes on Escape.
import type {ComponentChildren} from "preact";
import {useLayoutEffect, useRef} from "preact/hooks";
import {Icon} from "../drawing/icons";
import {closeDialog, dialog, type DialogName} from "./page_state";
import {Notices} from "./notices";

interface DialogProps {
  name: DialogName;
  title: string;
  children: ComponentChildren;
}

export function Dialog({name, title, children}: DialogProps) {
  const isOpen = dialog.value === name,
    onClose = () => closeDialog(name);
  const element = useRef<HTMLDialogElement>(null);
  // Close events arrive late, when the dialog may be open again, so close events caused by the page itself are ignored.
  const ownClosings = useRef(0);
  useLayoutEffect(() => {
    const own = element.current;
    if (!own || own.open === isOpen) return;
    if (isOpen) own.showModal();
    else {
      ++ownClosings.current;
      own.close();
    }
  }, [isOpen]);
  const onClosed = () => {
    if (ownClosings.current > 0) --ownClosings.current;
    else onClose();
  };
  return (
    <dialog
      ref={element}
      class="dialog"
      aria-label={title}
      onClose={onClosed}
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
