// The keys that work in all views, and the list of all keys.
import {chooseScheme, isDark} from "../drawing/colours";
import {isTyping} from "../drawing/fields";
import {Terms} from "../drawing/panel";
import {selectedReadings} from "../error/linked";
import {dismiss, notices} from "../server/workbench";
import {Dialog} from "./dialog";
import {dialog, view} from "./page_state";
import {save} from "./project";
import {shownViews} from "./shown_views";
import {canRedo, canUndo, redo, undo} from "./undo";

const LIST: Record<string, Record<string, string>> = {
  Everywhere: {
    "1 … 7": "the views, from top to bottom",
    O: "open a cell or readings",
    "Ctrl Z": "undo the last change of the model, the readings or the touches",
    "Ctrl Shift Z, Ctrl Y": "redo",
    "Ctrl S": "save as a project",
    D: "dark or light",
    "?": "this list",
    Esc: "close, dismiss a message, or clear the selection",
  },
  "On a sheet": {
    arrows: "from hole to hole",
    Enter: "pick the hole",
    "Shift arrows, drag": "move the sheet",
    "+  −  wheel, pinch": "larger, smaller",
    // The blank keeps the entry in place: integer keys are sorted first.
    "0 ": "whole sheet",
    "L, Shift drag": "lasso (with Ctrl: add to the selection)",
  },
  "On readings": {
    drag: "a loop in the plot or the places selects readings (with Shift: more)",
    "Ctrl A": "in the table: select all readings that pass the filter",
  },
  "In the bar that plays a plan": {Space: "play or pause", "← →": "a tube back or on", Home: "to the start"},
  Sliders: {"← →": "a small step", "Page up, down": "a large one", "Home, End": "to the limits"},
};

/**
 * Closes an open menu that has lost the focus, such as after one of its buttons was disabled. Returns true if there was
 * such a menu.
 */
function closeMenu(): boolean {
  const menu = document.querySelector<HTMLDetailsElement>("details.menu[open]");
  if (!menu) return false;
  menu.open = false;
  menu.querySelector("summary")?.focus();
  return true;
}

function onKey(event: KeyboardEvent): void {
  if (isTyping(event) || event.defaultPrevented) return;
  const key = event.key.toLowerCase();
  if ((event.ctrlKey || event.metaKey) && (key === "z" || key === "y")) {
    event.preventDefault();
    const isRedo = key === "y" || event.shiftKey;
    if (isRedo && canRedo.value) void redo();
    if (!isRedo && canUndo.value) void undo();
    return;
  }
  if ((event.ctrlKey || event.metaKey) && key === "s") {
    event.preventDefault();
    void save();
    return;
  }
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const chosen = shownViews.value[Number(key) - 1];
  if (chosen) view.value = chosen.name;
  else if (key === "o") dialog.value = "open";
  else if (key === "?") dialog.value = "keys";
  else if (key === "d") chooseScheme(isDark() ? "light" : "dark");
  else if (key === "escape" && dialog.value === "" && closeMenu()) event.stopPropagation();
  else if (key === "escape" && notices.value.length > 0) dismiss(notices.value[notices.value.length - 1].id);
  else if (key === "escape" && dialog.value === "" && selectedReadings.value.size > 0)
    selectedReadings.value = new Set();
  else return;
  event.preventDefault();
}

export function followKeys(): () => void {
  document.addEventListener("keydown", onKey);
  return () => document.removeEventListener("keydown", onKey);
}

export function KeysDialog() {
  return (
    <Dialog name="keys" title="Keys">
      <div class="keys">
        {Object.entries(LIST).map(([title, keys]) => (
          <section>
            <h2>{title}</h2>
            <dl>
              <Terms rows={Object.entries(keys).map(([key, words]) => [<kbd>{key}</kbd>, words] as const)} />
            </dl>
          </section>
        ))}
      </div>
    </Dialog>
  );
}
