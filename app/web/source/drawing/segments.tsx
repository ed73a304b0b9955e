// A row of exclusive choices: a single tab stop, with arrow keys to move between choices.

export interface Choice<T> {
  value: T;
  words: string;
  hint?: string;
}

/**
 * Returns a key handler that moves the focus between the buttons of an element and chooses each focused button. With
 * `isRound`, the focus wraps around at the ends.
 */
export function roving(keys: Record<string, 1 | -1>, isRound = true) {
  return (event: KeyboardEvent) => {
    const by = keys[event.key];
    if (by === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const within = event.currentTarget as HTMLElement;
    const buttons = [...within.querySelectorAll<HTMLButtonElement>("button:not(:disabled)")];
    const at = buttons.indexOf(document.activeElement as HTMLButtonElement) + by,
      last = buttons.length - 1;
    const next = buttons[isRound ? (at + last + 1) % (last + 1) : Math.max(0, Math.min(last, at))];
    next?.focus();
    next?.click();
  };
}

export const rove = roving({ArrowRight: 1, ArrowLeft: -1});

interface SegmentsProps<T> {
  label: string;
  choices: readonly Choice<T>[];
  value: T | undefined;
  onChoose: (value: T) => void;
}

/** Buttons in a row, one of them chosen. Without a value (`undefined`) the buttons are commands. */
export function Segments<T extends string | number>({label, choices, value, onChoose}: SegmentsProps<T>) {
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

/** Returns pairs of a value and its text as choices. */
export function choicesOf<T>(pairs: readonly (readonly [T, string])[]): Choice<T>[] {
  return pairs.map(([value, words]) => ({value, words}));
}
