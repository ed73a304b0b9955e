// Form fields: a list of choices, a check box and a text field. The input is stored in a signal or passed to a
// callback.
import type {Signal} from "@preact/signals";
import type {ComponentChildren, ComponentProps} from "preact";
import type {Choice} from "./segments";

interface SelectProps<T> {
  label?: string;
  choices: readonly Choice<T>[];
  value: T;
  onChoose: (value: T) => void;
  /** Called before the list of choices opens. */
  onOpen?: () => void;
}

export function Select<T extends string | number>({label, choices, value, onChoose, onOpen}: SelectProps<T>) {
  return (
    <select
      aria-label={label}
      value={value}
      onFocus={onOpen}
      onPointerDown={onOpen}
      onChange={(event) => onChoose(choices[event.currentTarget.selectedIndex].value)}
    >
      {choices.map(({value: own, words}) => (
        <option value={own}>{words}</option>
      ))}
    </select>
  );
}

interface CheckProps {
  of: Signal<boolean>;
  title?: string;
  kind?: string;
  children: ComponentChildren;
}

export function Check({of, title, kind = "check", children}: CheckProps) {
  return (
    <label class={kind} title={title}>
      <input type="checkbox" checked={of.value} onChange={(event) => (of.value = event.currentTarget.checked)} />{" "}
      {children}
    </label>
  );
}

interface TextProps extends Omit<ComponentProps<"input">, "value" | "onInput"> {
  of: Signal<string>;
  /** Called after every change of the text. */
  onEdit?: () => void;
}

export function TextInput({of, onEdit, ...others}: TextProps) {
  const edit = (text: string) => {
    of.value = text;
    onEdit?.();
  };
  return <input {...others} value={of.value} spellcheck={false} onInput={(event) => edit(event.currentTarget.value)} />;
}

/** Returns a copy of the set with the entry added, or removed if it was present. */
export function toggled<T>(set: ReadonlySet<T>, entry: T): ReadonlySet<T> {
  const next = new Set(set);
  if (!next.delete(entry)) next.add(entry);
  return next;
}

/** Returns a submit handler that runs `act` instead of the browser's own submission. */
export function submitting(act: (form: HTMLFormElement) => unknown) {
  return (event: SubmitEvent & {currentTarget: HTMLFormElement}) => {
    event.preventDefault();
    void act(event.currentTarget);
  };
}

/** Returns a typed number with a decimal point in place of a decimal comma. */
export function withPoint(text: string): string {
  return text.trim().replace("−", "-").replace(",", ".");
}

/** Returns true if a key press is input to a field and therefore not a command. */
export function isTyping(event: KeyboardEvent): boolean {
  const target = event.target as HTMLElement | null;
  return (
    target !== null &&
    (target.matches("input:not([type=range]):not([type=checkbox]), textarea, select") || target.isContentEditable)
  );
}
