// A row of choices of which one holds: one tab stop, arrow keys within.

export interface Choice<T> {
  value: T;
  words: string;
  hint?: string;
}

export function rove(event: KeyboardEvent): void {
  const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
  if (by === 0) return;
  event.preventDefault();
  event.stopPropagation();
  const buttons = [
    ...(event.currentTarget as HTMLElement).querySelectorAll<HTMLButtonElement>("button:not(:disabled)"),
  ];
  const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
  const next = buttons[(at + by + buttons.length) % buttons.length];
  next?.focus();
  next?.click();
}

/** Without a value (`undefined`) the buttons are commands side by side. */
export function Segments<T extends string | number>({
  label,
  choices,
  value,
  onChoose,
}: {
  label: string;
  choices: readonly Choice<T>[];
  value: T | undefined;
  onChoose: (value: T) => void;
}) {
  const hasValue = choices.some((choice) => choice.value === value);
  return (
    <div class="segments" role="group" aria-label={label} onKeyDown={rove}>
      {choices.map((choice, index) => (
        <button
          key={choice.value}
          type="button"
          title={choice.hint}
          aria-pressed={value === undefined ? undefined : choice.value === value}
          tabIndex={choice.value === value || (!hasValue && index === 0) ? 0 : -1}
          onClick={() => onChoose(choice.value)}
        >
          {choice.words}
        </button>
      ))}
    </div>
  );
}

/** Pairs of value and words as choices. */
export function choicesOf<T>(pairs: readonly (readonly [T, string])[]): Choice<T>[] {
  return pairs.map(([value, words]) => ({value, words}));
}
