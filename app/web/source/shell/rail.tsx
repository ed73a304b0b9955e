// The way from view to view: one tab stop, arrow keys within.
import {Icon, type IconName} from "../drawing/icons";
import {view, VIEWS, type ViewName} from "./page_state";

const WORDS: Record<ViewName, string> = {
  sheet: "Sheet",
  arm: "Arm",
  error: "Error",
  plan: "Plan",
  calibrate: "Calibrate",
  effects: "Effects",
};

function step(event: KeyboardEvent): void {
  const by =
    event.key === "ArrowDown" || event.key === "ArrowRight"
      ? 1
      : event.key === "ArrowUp" || event.key === "ArrowLeft"
        ? -1
        : 0;
  if (by === 0) return;
  event.preventDefault();
  view.value = VIEWS[(VIEWS.indexOf(view.value) + by + VIEWS.length) % VIEWS.length];
  const rail = event.currentTarget as HTMLElement;
  requestAnimationFrame(() => rail.querySelector<HTMLElement>("[aria-current=page]")?.focus());
}

export function Rail() {
  return (
    <nav class="rail" aria-label="Views" onKeyDown={step}>
      {VIEWS.map((name, index) => (
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
