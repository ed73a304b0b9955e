// Page of a shift: the next tube, its confirmation, marks with one key each, totals and the log.
import {useEffect} from "preact/hooks";
import {useSignal} from "@preact/signals";
import {Select} from "../drawing/fields";
import {Panel} from "../drawing/panel";
import {Waiting} from "../shell/states";
import {plural} from "../../../drawing/numbers.js";
import {
  chooseRecord,
  type JobEvent,
  events,
  next,
  person,
  place,
  plan,
  record,
  records,
  refresh,
  reportAddress,
  totals,
  undo,
} from "./desk";
import {Gantt} from "./gantt";
import {NextPanel} from "./next_panel";
import {TimeShares} from "./time_shares";
import {TotalsTable} from "./totals_table";

/** Polling interval of the record, which other desks may change [ms]. */
const PAUSE = 5000;

export function OutageView() {
  useEffect(() => {
    void refresh();
    const timer = setInterval(() => void refresh(), PAUSE);
    return () => clearInterval(timer);
  }, [record.value, place.value]);
  if (!totals.value || !next.value)
    return (
      <>
        <div class="desk-bar">
          <RecordChoice />
        </div>
        <Waiting words="Reading the job's record" isBusy />
      </>
    );
  return (
    <div class="desk">
      <Bar />
      <NextPanel tube={next.value} />
      <Panel title="Totals" kind="desk-totals">
        <TotalsTable totals={totals.value} />
        <Warnings />
      </Panel>
      <Log />
      <PlanPanel />
    </div>
  );
}

function RecordChoice() {
  const names = records.value.document?.records ?? [];
  return (
    <Select
      label="Record of the job"
      value={record.value}
      choices={names.map((name) => ({value: name, words: name}))}
      onChoose={chooseRecord}
    />
  );
}

function Bar() {
  const legs = [...new Set(totals.value!.packages.map((of) => `${of.steam_generator}/${of.leg}`))];
  return (
    <div class="desk-bar">
      <h1>{totals.value!.job}</h1>
      <RecordChoice />
      <Select
        label="Leg"
        value={place.value}
        choices={[{value: "", words: "every leg"}, ...legs.map((leg) => ({value: leg, words: leg}))]}
        onChoose={(leg) => (place.value = leg)}
      />
      <HandOver />
      <label>
        Who marks{" "}
        <input
          value={person.value}
          spellcheck={false}
          placeholder="name"
          onInput={(event) => (person.value = event.currentTarget.value)}
        />
      </label>
    </div>
  );
}

/** Button for the hand-over of a shift: the latest shift, or a shift in which items were finished. */
function HandOver() {
  const shift = useSignal("");
  const shifts = totals.value!.shifts.map(({date, shift: name}) => `${date} ${name}`.trim());
  return (
    <>
      <Select
        label="Shift of the hand-over"
        value={shift.value}
        choices={[{value: "", words: "latest shift"}, ...shifts.map((of) => ({value: of, words: of}))]}
        onChoose={(of) => (shift.value = of)}
      />
      <a class="button" href={reportAddress(shift.value)} download="handover.html">
        Hand-over report
      </a>
    </>
  );
}

function PlanPanel() {
  if (!plan.value) return null;
  return (
    <Panel title="Plan of the job" kind="desk-plan">
      <Gantt plan={plan.value} />
      <h3>Time by activity</h3>
      <TimeShares plan={plan.value} />
    </Panel>
  );
}

function Warnings() {
  const {plugged_at_one_end: plugged, plugged_in_the_meantime: meantime, wrong_tubes: wrong} = totals.value!;
  return (
    <>
      {wrong.map(({tube, found, who}) => (
        <p class="desk-warning" key={tube}>
          ✕ At {tube} {who} found {found}: confirm the tube again before any tool enters.
        </p>
      ))}
      {plugged.map((tube) => (
        <p class="desk-warning" key={tube}>
          ▲ {tube} is plugged at this end only: plug the other end too, or check which tube it is.
        </p>
      ))}
      {meantime.map(({tube, package: of}) => (
        <p class="desk-warning" key={tube + of}>
          ▲ {tube} is plugged, but {of} still plans to visit it: mark it excluded there.
        </p>
      ))}
    </>
  );
}

const SHOWN_EVENTS = 200;

function Log() {
  const latest = events.value.slice(-SHOWN_EVENTS).reverse();
  return (
    <Panel title={`Log, ${plural(events.value.length, "event")}`} kind="desk-log" body="desk-events">
      {latest.length === 0 ? <p class="muted">Nothing has been recorded yet.</p> : null}
      {latest.map((event) => (
        <div class={`desk-event ${event.undone ? "undone" : ""}`} key={event.event}>
          <span class="number">{event.event}</span>
          <span>{event.at.replace("T", " ").replace("Z", "")}</span>
          <span>{event.who}</span>
          <b>{event.tube}</b>
          <span>
            {wordsOf(event)}
            {event.reason ? <i class="muted"> {event.reason}</i> : null}
          </span>
          {event.kind === "mark" && !event.undone ? (
            <button class="button" onClick={() => confirmUndo(event.event)}>
              Undo
            </button>
          ) : (
            <span />
          )}
        </div>
      ))}
    </Panel>
  );
}

function wordsOf({kind, value}: JobEvent): string {
  if (kind === "confirm") return value === "same" ? "✓ confirmed" : `✕ found ${value}`;
  return kind === "mark" ? value : `${kind}: ${value}`;
}

/** Undoes a mark for a reason that the person gives; does nothing without a reason. */
function confirmUndo(event: number): void {
  const reason = window.prompt(`Why is event ${event} undone?`);
  if (reason) void undo(event, reason);
}
