// The log of a shift, a line for each visit: its confirmation and its mark.
import {plural} from "../../../../drawing/numbers.js";
import {Lead, type OfReport} from "../parts";
import {list, type Report, textOf} from "../values";

interface LogLine {
  event: Report;
  /** Confirmation on which the mark relies; null if there is none. */
  confirmation: Report | null;
  /** True if the confirmation is shown with its mark. */
  isJoined: boolean;
}

/** Returns the events with each confirmation of the right tube joined to the mark that follows it. */
export function logLines(events: readonly Report[]): LogLine[] {
  const lines: LogLine[] = [],
    open = new Map<string, LogLine>();
  for (const event of events) {
    const key = `${event.tube} ${event.package}`,
      line: LogLine = {event, confirmation: null, isJoined: false};
    if (event.kind === "mark" && open.has(key)) {
      const confirmed = open.get(key)!;
      line.confirmation = confirmed.event;
      confirmed.isJoined = true;
      open.delete(key);
    }
    if (event.kind === "confirm" && event.value === "same") open.set(key, line);
    lines.push(line);
  }
  return lines.filter(({isJoined}) => !isJoined);
}

export function LogSection({report}: OfReport) {
  const events = list(report.events);
  if (events.length === 0) return <p class="note">Nothing was recorded in this shift.</p>;
  return (
    <>
      <Lead>
        {plural(events.length, "event")}. A visit is one line, with who confirmed the tube; times are in UTC. What was
        undone later is struck out.
      </Lead>
      <ol class="shift-log">
        {logLines(events).map(({event, confirmation}) => (
          <li class={event.undone ? "undone" : ""}>
            <span>{textOf(event.at).slice(11, 16)}</span> <b>{textOf(event.tube)}</b> {textOf(event.package)}{" "}
            <b>{doneWords(event)}</b> {textOf(event.who)}
            {confirmation ? `, confirmed by ${textOf(confirmation.who)}` : ""}
            {textOf(event.reason, "") ? <i> {textOf(event.reason)}</i> : null}
          </li>
        ))}
      </ol>
    </>
  );
}

function doneWords({kind, value, undoes}: Report): string {
  if (kind === "confirm") return value === "same" ? "confirmed" : `\u2715 found ${textOf(value)}`;
  return kind === "undo" ? `undoes ${textOf(value)} (event ${textOf(undoes)})` : textOf(value);
}
