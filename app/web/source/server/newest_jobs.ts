// Merging of jobs received in events, in states and in answers over different connections: the newest status of each
// job is kept, regardless of the order of arrival.
import type {Job, WorkbenchState} from "./documents";

type Jobs = ReadonlyMap<string, Job>;

export function withJob(known: Jobs, job: Job): Jobs {
  const id = String(job.id),
    before = known.get(id);
  return before && before.moment > job.moment ? known : new Map(known).set(id, job);
}

/**
 * Returns the jobs of a state, each replaced by its later known status, and newer jobs that the state does not contain
 * yet.
 */
export function newestJobs(known: Jobs, {jobs, moment}: Pick<WorkbenchState, "jobs" | "moment">): Jobs {
  const later = [...known.values()].filter((job) => job.moment > moment);
  return later.reduce(withJob, new Map(jobs.map((job) => [String(job.id), job])));
}
