// Navigation between views: a single tab stop, with arrow keys to move between views.
import {Icon, type IconName} from "../drawing/icons";
import {roving} from "../drawing/segments";
import {records} from "../outage/desk";
import {view, VIEWS, type ViewName} from "./page_state";

const WORDS: Record<ViewName, string> = {
  sheet: "Sheet",
  arm: "Arm",
  error: "Error",
  plan: "Plan",
  calibrate: "Calibrate",
  effects: "Effects",
  outage: "Outage",
};

const step = roving({ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1});

export function Rail() {
  const hasRecords = (records.value.document?.records.length ?? 0) > 0;
  return (
    <nav class="rail" aria-label="Views" onKeyDown={step}>
      {VIEWS.filter((name) => name !== "outage" || hasRecords).map((name, index) => (
        <button
          key={name}
          class="rail-entry"
          aria-current={view.value === name ? "page" : undefined}
          tabIndex={view.value === name ? 0 : -1}
          title={`${WORDS[name]} (${index + 1})`}
          onClick={() => (view.value = name)}
        >
          <Icon name={name as IconName} size={22} />
          <span>{WORDS[name]}</span>
        </button>
      ))}
    </nav>
  );
}
