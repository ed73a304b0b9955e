// Navigation between views: a single tab stop, with arrow keys to move between views.
import {Icon} from "../drawing/icons";
import {roving} from "../drawing/segments";
import {view} from "./page_state";
import {shownViews} from "./shown_views";

const step = roving({ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1});

export function Rail() {
  const shown = shownViews.value;
  const stop = shown.find(({name}) => name === view.value) ?? shown[0];
  return (
    <nav class="rail" aria-label="Views" onKeyDown={step}>
      {shown.map(({name, words}, index) => (
        <button
          key={name}
          class="rail-entry"
          aria-current={view.value === name ? "page" : undefined}
          tabIndex={name === stop.name ? 0 : -1}
          title={`${words} (${index + 1})`}
          onClick={() => (view.value = name)}
        >
          <Icon name={name} size={22} />
          <span>{words}</span>
        </button>
      ))}
    </nav>
  );
}
