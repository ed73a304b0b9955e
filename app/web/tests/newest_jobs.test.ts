import {describe, expect, it} from "vitest";
import type {Job} from "../source/server/documents";
import {newestJobs, withJob} from "../source/server/newest_jobs";

const job = (id: number, moment: number, status: Job["status"] = "running") => ({id, moment, status}) as Job;
const known = (...all: Job[]) => new Map(all.map((one) => [String(one.id), one]));
const statuses = (all: ReadonlyMap<string, Job>) => [...all.values()].map(({id, status}) => `${id} ${status}`).sort();

describe("a job", () => {
  it("that has ended does not run again by an answer that was made before its end", () => {
    const ended = known(job(1, 7, "done"));
    expect(statuses(newestJobs(ended, {moment: 5, jobs: [job(1, 5)]}))).toEqual(["1 done"]);
    expect(statuses(withJob(ended, job(1, 6)))).toEqual(["1 done"]);
  });
  it("that began after an answer was made is not lost by it", () => {
    expect(statuses(newestJobs(known(job(2, 6)), {moment: 5, jobs: [job(1, 4, "done")]}))).toEqual([
      "1 done",
      "2 running",
    ]);
  });
  it("that a newer state has otherwise, or no more, is as it says", () => {
    const before = known(job(1, 3, "done"), job(2, 4));
    expect(statuses(newestJobs(before, {moment: 9, jobs: [job(2, 8, "cancelled")]}))).toEqual(["2 cancelled"]);
    expect(statuses(withJob(before, job(2, 8, "failed")))).toEqual(["1 done", "2 failed"]);
  });
});
