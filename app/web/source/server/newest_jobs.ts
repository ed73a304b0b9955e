// Jobs come by events, by states and by answers, each on a way of its own: the newest word of each is kept, whichever
// came last.
import type {Job, WorkbenchState} from "./documents";

type Jobs = ReadonlyMap<string, Job>;

export function withJob(known: Jobs, job: Job): Jobs {
  const id = String(job.id),
    before = known.get(id);
  return before && before.moment > job.moment ? known : new Map(known).set(id, job);
}

/** Those of a state; of each that has changed since, what came, also of one that the state does not have yet. */
export function newestJobs(known: Jobs, {jobs, moment}: Pick<WorkbenchState, "jobs" | "moment">): Jobs {
  const later = [...known.values()].filter((job) => job.moment > moment);
  return later.reduce(withJob, new Map(jobs.map((job) => [String(job.id), job])));
}
