// State of the desk: the job's record, the person, the part of the job, and what the record says.
import {effect, signal} from "@preact/signals";
import {answerTo} from "../server/answers";
import {get, post} from "../server/requests";
import {attempt, state} from "../server/workbench";
import {keep, keptObject} from "../shell/kept";

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
  shifts: {date: string; shift: string; done: number}[];
  plugged_at_one_end: string[];
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
effect(() => {
  const names = records.value.document?.records ?? [];
  if (names.length > 0 && !names.includes(record.peek())) record.value = names[0];
});

export const totals = signal<Totals | null>(null);
export const next = signal<NextTube | null>(null);
export const events = signal<JobEvent[]>([]);
/** The last confirmation of the tube that is next; null before it. */
export const finding = signal<Finding | null>(null);

/** Asks the program for everything that the view shows. */
export async function refresh(): Promise<void> {
  if (record.value === "") return;
  const file = `file=${encodeURIComponent(record.value)}`;
  const [sg, leg] = place.value.split("/");
  const part = place.value === "" ? "" : `&sg=${encodeURIComponent(sg)}&leg=${leg}`;
  await attempt("The record cannot be read", async () => {
    const [counted, found, log] = await Promise.all([
      get<Totals>(`/api/outage/totals?${file}`),
      get<NextTube>(`/api/outage/next?${file}${part}`),
      get<{events: JobEvent[]}>(`/api/outage/log?${file}`),
    ]);
    totals.value = counted;
    events.value = log.events;
    if (found.tube !== next.peek()?.tube) finding.value = null;
    next.value = found;
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
