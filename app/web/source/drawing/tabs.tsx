// Tabs above a panel: a single tab stop, with arrow keys to move between tabs.
import {rove, type Choice} from "./segments";

interface TabsProps<T> {
  label: string;
  tabs: readonly Choice<T>[];
  value: T;
  onChoose: (value: T) => void;
}

export function Tabs<T extends string>({label, tabs, value, onChoose}: TabsProps<T>) {
  return (
    <div class="tabs" role="tablist" aria-label={label} onKeyDown={rove}>
      {tabs.map((tab) => (
        <button
          key={tab.value}
          type="button"
          role="tab"
          title={tab.hint}
          aria-selected={tab.value === value}
          tabIndex={tab.value === value ? 0 : -1}
          onClick={() => onChoose(tab.value)}
        >
          {tab.words}
        </button>
      ))}
    </div>
  );
}
