// The server's state as signals, received from /api/events and equal in every browser. Results are fetched when they
// change.
import {batch, computed, effect, signal, type ReadonlySignal} from "@preact/signals";
import type {Job, LiveNews, Model, Problem, SceneDocument, SheetDocument, Units, WorkbenchState} from "./documents";
import {answerTo, type Loaded} from "./answers";
import {chooseUnits, inChosenUnits} from "./chosen_units";
import {asProblem, get, post} from "./requests";
import {newestJobs, withJob} from "./newest_jobs";
import {sharing} from "./sharing";
import type {UnitTable} from "./unit_table";

export const state = signal<WorkbenchState | null>(null);
export const connection = signal<"connecting" | "live" | "lost">("connecting");
export const jobs = signal<ReadonlyMap<string, Job>>(new Map());

/** Newest data of a running arm; null until data arrive. */
export const liveNews = signal<LiveNews | null>(null);

export const cell = computed(() => state.value?.cell ?? null);
export const units = computed<Units>(() => cell.value?.units ?? {length: "", angle: "", force: ""});
export const unitTable = computed<UnitTable>(() => state.value?.unit_table ?? {length: [], angle: []});
export const runningJobs = computed(() => [...jobs.value.values()].filter((job) => job.status === "running"));
export const currentModel = computed<Model | null>(
  () => state.value?.models.find((model) => model.id === state.value?.model) ?? null,
);

/** True if the present model was made from another one. */
export const hasModelBefore = computed(
  () => (state.value?.models.findIndex(({id}) => id === state.value?.model) ?? 0) > 0,
);

/** Returns the label of the model for which a result was computed, if it is not the present model; otherwise "". */
export function otherModelOf(name: string): string {
  const id = state.value?.results[name]?.model;
  if (id === undefined || id === state.value?.model) return "";
  return state.value?.models.find((model) => model.id === id)?.label ?? "a model that no longer exists";
}

/** Returns the running job of one of the given kinds; null if there is none. */
export function runningJob(...kinds: string[]): Job | null {
  return runningJobs.value.find((job) => kinds.includes(job.kind)) ?? null;
}

// ---- events

function noteJob(job: Job): void {
  jobs.value = withJob(jobs.value, job);
}

/** True until the first state after a new connection, because a restarted program counts changes from the beginning. */
let isNewConnection = true;

/** Time without data after which the server is treated as not responding [ms]. It sends data at least every 10 s. */
const LONGEST_SILENCE = 25_000;
let heard = 0;

function hear(): void {
  heard = Date.now();
  connection.value = "live";
}

setInterval(() => {
  if (connection.peek() === "live" && Date.now() - heard > LONGEST_SILENCE) connection.value = "lost";
}, 1000);

export function takeState(next: WorkbenchState): void {
  if (!isNewConnection && state.value !== null && next.moment < state.value.moment) return;
  const known = isNewConnection ? new Map<string, Job>() : jobs.value;
  isNewConnection = false;
  batch(() => {
    state.value = sharing(state.value, next);
    jobs.value = newestJobs(known, next);
  });
}

/** Removes the token from the address bar, because the server keeps it in a cookie. */
export function dropTokenFromAddress(): void {
  const address = new URL(location.href);
  if (!address.searchParams.has("token")) return;
  address.searchParams.delete("token");
  history.replaceState(null, "", address);
}

/** Takes back the chosen units if the program does not know them: they were chosen from another version's table. */
async function dropUnknownUnits(): Promise<void> {
  try {
    await get("/api/state");
  } catch (error) {
    if (asProblem(error).where === "units") chooseUnits({length: "", angle: ""});
  }
}

/**
 * Follows the server's events. The browser reconnects automatically, and every connection begins with the whole state.
 */
export function followServer(): void {
  const events = new EventSource(inChosenUnits("/api/events"));
  for (const name of ["open", "state", "job", "live", "alive"]) events.addEventListener(name, hear);
  events.addEventListener("open", () => {
    isNewConnection = true;
    notices.value = []; // these notices concern earlier requests
  });
  events.addEventListener("state", (event) => {
    takeState(JSON.parse(event.data) as WorkbenchState);
  });
  events.addEventListener("job", (event) => noteJob(JSON.parse(event.data) as Job));
  events.addEventListener("live", (event) => {
    liveNews.value = JSON.parse(event.data) as LiveNews;
  });
  events.addEventListener("error", () => {
    connection.value = "lost";
    if (events.readyState !== EventSource.CLOSED) return;
    void dropUnknownUnits();
    setTimeout(followServer, 2000);
  });
}

// ---- results

const results = new Map<string, ReadonlySignal<Loaded<unknown>>>();

/** Returns the named result document, fetched again whenever the state reports a change of it. */
export function result<T>(name: string): ReadonlySignal<Loaded<T>> {
  const known =
    results.get(name) ?? answerTo<unknown>({key: () => markOf(name), path: () => `/api/results/${name}`, keeps: true});
  results.set(name, known);
  return known as ReadonlySignal<Loaded<T>>;
}

function markOf(name: string): string {
  const entry = state.value?.results[name];
  return entry ? `${entry.model}:${entry.revision}` : "";
}

/** Returns a document that depends only on the cell, requested once for each cell. */
function perCell<T>(path: string, isThere: () => boolean): ReadonlySignal<Loaded<T>> {
  const key = () => (cell.value && isThere() ? `${state.value?.folder} ${cell.value.file} ${cell.value.name}` : "");
  return answerTo<T>({key, path: () => path});
}

export const sheetDocument = perCell<SheetDocument>("/api/sheet", () => cell.value?.has_sheet === true);
export const sceneDocument = perCell<SceneDocument>("/api/scene", () => true);

// ---- notices, shown until they are dismissed, or until the same is tried again

export interface Notice {
  id: number;
  /** Action that failed: a further attempt replaces the notice, and success removes it. */
  about: string;
  title: string;
  problem: Problem;
  /** True for words on an action that succeeded. */
  isNote: boolean;
}

export const notices = signal<Notice[]>([]);
let nextNotice = 1;

function show(notice: Omit<Notice, "id">): void {
  forget(notice.about);
  notices.value = [...notices.peek().slice(-2), {id: nextNotice++, ...notice}]; // peek() does not add a dependency
}

/** Shows a failure of an action. */
export function report(title: string, error: unknown, about = title): void {
  show({about, title, problem: error instanceof Error ? asProblem(error) : (error as Problem), isNote: false});
}

/** Shows words on an action that succeeded. */
export function inform(title: string, message: string, about = title): void {
  show({about, title, problem: {message}, isNote: true});
}

/** Removes the notices about earlier attempts of the same action. */
export function forget(about: string): void {
  if (notices.peek().some((notice) => notice.about === about))
    notices.value = notices.peek().filter((notice) => notice.about !== about);
}

/** Returns a callback that reports a failure under a title, and removes the notice on success, which is null. */
export function reporting(title: string): (error: unknown) => void {
  return (error) => (error === null ? forget(title) : report(title, error));
}

export function dismiss(id: number): void {
  notices.value = notices.value.filter((notice) => notice.id !== id);
}

/** Sends a request and shows the reason if it is refused. Returns true if it was accepted. */
export function order(title: string, path: string, body: unknown = {}): Promise<boolean> {
  return attempt(title, () => post(path, body));
}

/** Runs an action and shows the reason if it is refused. Returns true if it succeeded. */
export async function attempt(title: string, act: () => Promise<unknown>, about = title): Promise<boolean> {
  forget(about);
  try {
    await act();
    return true;
  } catch (error) {
    report(title, error, about);
    return false;
  }
}

/** Paths of requests for jobs whose answer from the program is pending. */
const starting = signal<readonly string[]>([]);

/** Returns true if the job requested at this path is starting or running already, such as after a double click. */
function isUnderWay(path: string): boolean {
  return starting.peek().includes(path) || runningJob(path.slice(path.lastIndexOf("/") + 1)) !== null;
}

/**
 * Starts a job and waits for its end, which events report. Returns false if the job failed, was stopped, or was running
 * already.
 */
export async function runJob(title: string, path: string, body: unknown = {}): Promise<boolean> {
  if (isUnderWay(path)) return false;
  forget(title);
  try {
    return await ended(String((await startJob(path, body)).id));
  } catch (error) {
    report(title, error);
    return false;
  }
}

/** Requests a job, and adds the job to the known jobs once the program has accepted it. */
export async function startJob(path: string, body: unknown): Promise<Job> {
  starting.value = [...starting.peek(), path];
  try {
    const job = await post<Job>(path, body);
    noteJob(job);
    return job;
  } finally {
    starting.value = starting.peek().toSpliced(starting.peek().indexOf(path), 1);
  }
}

function until(holds: () => boolean): Promise<void> {
  return new Promise((resolve) => {
    const stop = effect(() => {
      if (!holds()) return;
      queueMicrotask(() => {
        stop();
        resolve();
      });
    });
  });
}

async function ended(id: string): Promise<boolean> {
  let wasSeen = false;
  await until(() => {
    const job = jobs.value.get(id);
    if (job) wasSeen = true;
    return job ? job.status !== "running" : wasSeen;
  });
  const job = jobs.peek().get(id);
  return job === undefined || job.status === "done";
}

/** Stops the running and starting jobs of the given kinds, and waits until they have ended. */
export async function stopJobs(...kinds: string[]): Promise<void> {
  await until(() => starting.value.length === 0);
  const stopped = runningJobs.peek().filter((job) => kinds.includes(job.kind));
  await Promise.all(
    stopped.map(async ({id}) => (await order("Stop", `/api/jobs/${id}/cancel`)) && (await ended(String(id)))),
  );
}

// Failures of jobs are reported in every browser, regardless of where the job was started.
const reported = new Set<string>();
let isFirst = true;
effect(() => {
  for (const job of jobs.value.values()) {
    const id = String(job.id);
    if (job.status === "running" || reported.has(id)) continue;
    reported.add(id);
    if (job.status === "done") forget(job.kind);
    if (job.status === "failed" && !isFirst && job.error)
      report(`${job.label || job.kind} failed`, job.error, job.kind);
  }
  if (state.value !== null) isFirst = false;
});

// Faulty data from a running arm are reported once, in any view.
effect(() => {
  const {problem, source} = liveNews.value ?? {};
  if (problem) report(`${source}: not taken`, problem);
  else if (source) forget(`${source}: not taken`);
});
