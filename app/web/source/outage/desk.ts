// State of the desk: the job's record, the person, the part of the job, and what the record says.
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

/** What an independent confirmation of a tube found. */
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
/** Leg that the desk works in, "A/hot"; empty: every leg. */
export const place = signal(kept.place ?? "");

effect(() => keep(KEPT, {record: record.value, person: person.value, place: place.value}));

export const totals = signal<Totals | null>(null);
export const next = signal<NextTube | null>(null);
export const events = signal<JobEvent[]>([]);
export const plan = signal<JobPlan | null>(null);
/** The last confirmation of the tube that is next; null before it. */
export const finding = signal<Finding | null>(null);

const inFile = () => `file=${encodeURIComponent(record.value)}`;

/** Returns the address of the hand-over of a shift, "2027-04-02 day"; of the latest one for an empty text. */
export function reportAddress(shift: string): string {
  const [date, name = ""] = shift.split(" ");
  return `/api/outage/report?${inFile()}${shift === "" ? "" : `&date=${date}&shift=${encodeURIComponent(name)}`}`;
}

/** Record and part of the job that the signals are about, and the time of the plan that is shown. */
let shownPart = "",
  shownRecord = "",
  plannedAt = "";

/** Opens another record. Nothing of the last one stays on the page, so that no mark of its tubes enters the other. */
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

/** Asks the program for what has been recorded since the last time, and for totals and the next tube if they may differ. */
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

/** Records a confirmation by `by`, and shows what it found. */
export function confirm(by: string, evidence: {read_back: string} | {position: [number, number]}): Promise<boolean> {
  return attempt("The tube is not confirmed", async () => {
    finding.value = await post<Finding>("/api/outage/confirm", {...common(), by, ...evidence});
    await refresh();
  });
}

/** Records what became of the visit, unless somebody else has changed the tube in the meantime. */
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
