// State of the desk: the job's record, its contents, the person, and the selected part of the job.
import {batch, effect, signal} from "@preact/signals";
import {answerTo} from "../server/answers";
import {get, post} from "../server/requests";
import {attempt, state} from "../server/workbench";
import {keep, keptObject} from "../shell/kept";
import type {JobPlan} from "./job_plan";

export interface MarkKind {
  name: string;
  key: string;
  words: string;
  standing: string;
  needs_tool: boolean;
  needs_reason: boolean;
}

export interface Counts {
  planned: number;
  done: number;
  excluded: number;
  unresolved: number;
  open: number;
  queued: number;
  held: number;
  percent: number;
}

export interface PackageCounts extends Counts {
  package: string;
  steam_generator: string;
  leg: string;
}

export interface Totals {
  job: string;
  packages: PackageCounts[];
  total: Counts;
  shifts: {date: string; shift: string; done: number; reopened: number}[];
  plugged_at_one_end: string[];
  plugged_in_the_meantime: {tube: string; package: string}[];
  wrong_tubes: {tube: string; found: string; who: string; at: string}[];
}

export interface JobEvent {
  event: number;
  at: string;
  who: string;
  kind: string;
  package: string;
  tube: string;
  value: string;
  method: string;
  reason: string;
  undoes: number | null;
  undone: boolean;
}

export interface NextTube {
  tube: string | null;
  left: number;
  package: string;
  steam_generator: string;
  leg: string;
  row: number;
  column: number;
  x: number;
  y: number;
  tool: string;
  extent: string;
  confirm: string;
  standing: string;
  last_event: number;
  history: JobEvent[];
  units: {length: string};
}

/** Result of an independent confirmation of a tube. */
export interface Finding {
  tube: string;
  found: string;
  same: boolean;
  reason: string;
}

export const records = answerTo<{records: string[]; marks: MarkKind[]}>({
  key: () => (state.value ? "records" : null),
  path: () => "/api/outage",
});

const KEPT = "tubeplan.desk";
const kept = keptObject<string>(KEPT);

export const record = signal(kept.record ?? "");
export const person = signal(kept.person ?? "");
/** Leg shown by the desk, such as "A/hot"; empty for all legs. */
export const place = signal(kept.place ?? "");

effect(() => keep(KEPT, {record: record.value, person: person.value, place: place.value}));

export const totals = signal<Totals | null>(null);
export const next = signal<NextTube | null>(null);
export const events = signal<JobEvent[]>([]);
export const plan = signal<JobPlan | null>(null);
/** Latest confirmation of the next tube; null if there is none. */
export const finding = signal<Finding | null>(null);

const inFile = () => `file=${encodeURIComponent(record.value)}`;

/** Returns the URL of a shift's hand-over, such as "2025-04-02 day"; of the latest shift for an empty text. */
export function reportAddress(shift: string): string {
  const [date, name = ""] = shift.split(" ");
  return `/api/outage/report?${inFile()}${shift === "" ? "" : `&date=${date}&shift=${encodeURIComponent(name)}`}`;
}

/** Record and part of the job to which the signals refer, and the time of the displayed plan. */
let shownPart = "",
  shownRecord = "",
  plannedAt = "";

/** Opens another record and clears the page, so that no mark of the previous record enters the new one. */
export function chooseRecord(name: string): void {
  shownRecord = shownPart = "";
  batch(() => {
    [record.value, place.value] = [name, ""];
    totals.value = next.value = plan.value = finding.value = null;
    events.value = [];
  });
}

effect(() => {
  const names = records.value.document?.records ?? [];
  if (names.length > 0 && !names.includes(record.peek())) chooseRecord(names[0]);
});

/** Adds the events that are new, and marks those that they undo. */
function addEvents(fresh: readonly JobEvent[]): void {
  const undone = new Set(fresh.map(({undoes}) => undoes));
  events.value = [
    ...events.value.map((event) => (undone.has(event.event) ? {...event, undone: true} : event)),
    ...fresh,
  ];
}

/** Requests the events since the last request, and totals and next tube if they may have changed. */
export async function refresh(): Promise<void> {
  if (record.value === "") return;
  const [sg, leg] = place.value.split("/");
  const part = place.value === "" ? "" : `&sg=${encodeURIComponent(sg)}&leg=${leg}`;
  const wanted = record.value,
    wantedPart = inFile() + part;
  await attempt("The record cannot be read", async () => {
    const isOther = shownRecord !== wanted,
      known = isOther ? 0 : (events.peek().at(-1)?.event ?? 0);
    const log = await get<{events: JobEvent[]; planned_at: string}>(`/api/outage/log?${inFile()}&after=${known}`);
    const isPlanned = isOther || log.planned_at !== plannedAt;
    if (log.events.length === 0 && !isPlanned && shownPart === wantedPart) return;
    const [counted, found, planned] = await Promise.all([
      get<Totals>(`/api/outage/totals?${inFile()}`),
      get<NextTube>(`/api/outage/next?${wantedPart}`),
      isPlanned ? get<{plan: JobPlan | null}>(`/api/outage/plan?${inFile()}`) : null,
    ]);
    if (record.peek() !== wanted) return; // another record was chosen in the meantime
    if (isOther) events.value = [];
    addEvents(log.events.filter(({event}) => event > (events.peek().at(-1)?.event ?? 0)));
    totals.value = counted;
    if (found.tube !== next.peek()?.tube) finding.value = null;
    next.value = found;
    if (planned) plan.value = planned.plan;
    [shownRecord, shownPart, plannedAt] = [wanted, wantedPart, log.planned_at];
  });
}

const common = () => ({file: record.value, tube: next.value?.tube, package: next.value?.package});

/** Records a confirmation by the person `by`, and shows its result. */
export function confirm(by: string, evidence: {read_back: string} | {position: [number, number]}): Promise<boolean> {
  return attempt("The tube is not confirmed", async () => {
    finding.value = await post<Finding>("/api/outage/confirm", {...common(), by, ...evidence});
    await refresh();
  });
}

/** Records the outcome of the visit, unless another person has changed the tube in the meantime. */
export function mark(kind: MarkKind, reason: string): Promise<boolean> {
  return attempt(`${next.value?.tube} is not marked`, async () => {
    const after = next.value?.last_event;
    await post("/api/outage/mark", {...common(), as: kind.name, by: person.value, reason, after});
    finding.value = null;
    await refresh();
  });
}

export function undo(event: number, reason: string): Promise<boolean> {
  return attempt("The mark stays", async () => {
    await post("/api/outage/undo", {file: record.value, event, by: person.value, reason});
    await refresh();
  });
}
