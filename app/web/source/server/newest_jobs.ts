// Merging of jobs that arrive by events, by states and by answers over different connections: the newest state of each
// job is kept, whichever arrived last.
import type {Job, WorkbenchState} from "./documents";

type Jobs = ReadonlyMap<string, Job>;

export function withJob(known: Jobs, job: Job): Jobs {
  const id = String(job.id),
    before = known.get(id);
  return before && before.moment > job.moment ? known : new Map(known).set(id, job);
}

/** Returns the jobs of a state, with later news of each, including jobs that the state does not have yet. */
export function newestJobs(known: Jobs, {jobs, moment}: Pick<WorkbenchState, "jobs" | "moment">): Jobs {
  const later = [...known.values()].filter((job) => job.moment > moment);
  return later.reduce(withJob, new Map(jobs.map((job) => [String(job.id), job])));
}
