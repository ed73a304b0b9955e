// The report page of a job's plan.
import {duration, plural, whole} from "../../../../drawing/numbers.js";
import {Gantt} from "../../outage/gantt";
import {hours, type JobPlan, legName} from "../../outage/job_plan";
import {TimeShares} from "../../outage/time_shares";
import type {PageKind} from "../page";
import {Card, Lead, Missing, type OfReport, TableCard} from "../parts";
import {object, type Report} from "../values";
import {GroupedTubes} from "./grouped_tubes";

/** Returns the plan in a report; null if there is none. */
export function planOf(report: Report): JobPlan | null {
  const plan = object(report.plan);
  return plan && Array.isArray(plan.legs) ? (plan as unknown as JobPlan) : null;
}

export const JOB_PLAN_PAGE: PageKind = {
  title: "Plan of a job",
  Head,
  sections: [
    {id: "schedule", title: "Schedule of the arms", Content: ScheduleSection},
    {id: "packages", title: "Every package on every leg", Content: PackagesSection},
    {id: "reach", title: "Out of reach", Content: ReachSection},
  ],
  facts: ({version}) => [["tubeplan", version]],
};

function Head({report}: OfReport) {
  const plan = planOf(report);
  if (!plan) return <Missing what="The plan" />;
  return (
    <p class="sentence">
      {plural(plan.visits, "visit")} on {plural(plan.legs.length, "leg")} by {plural(plan.arms, "arm")}, in{" "}
      {duration(plan.end_s)}; {whole(plan.unreachable)} out of reach.
    </p>
  );
}

/** Chart of the arms and bars of the time; used in the hand-over too. */
export function ScheduleSection({report}: OfReport) {
  const plan = planOf(report);
  if (!plan) return <p class="missing">No plan is recorded yet: tubeplan job plan makes one.</p>;
  if (plan.legs.length === 0) return <p class="good">Nothing was left to plan.</p>;
  return (
    <>
      <Lead>Hours count from the beginning of the work, with all arms ready. Each leg has one arm at a time.</Lead>
      <Card>
        <Gantt plan={plan} />
      </Card>
      <Card title="Time by activity">
        <TimeShares plan={plan} />
      </Card>
    </>
  );
}

function PackagesSection({report}: OfReport) {
  const plan = planOf(report);
  if (!plan) return <Missing what="The plan" />;
  const rows = plan.legs.flatMap((leg) =>
    leg.packages.map((of) => [
      legName(leg),
      of.visits > 0 ? <a href={`${encodeURIComponent(of.folder)}/report.html`}>{of.package}</a> : of.package,
      whole(of.visits),
      whole(of.unreachable.length),
      `${hours(of.total_s).toFixed(2)} h`,
      of.reason,
    ]),
  );
  return (
    <TableCard
      what="Packages"
      heads={["leg", "package", "visits", "out of reach", "time", ""]}
      rows={rows}
      text={[0, 1, 5]}
    />
  );
}

function ReachSection({report}: OfReport) {
  const reasons = new Map<string, string[]>();
  for (const leg of planOf(report)?.legs ?? [])
    for (const of of leg.packages)
      for (const {tube, reason} of of.unreachable)
        reasons.set(reason, [...(reasons.get(reason) ?? []), `${tube} ${of.package}`]);
  const groups = [...reasons].map(([reason, tubes]) => ({reason, tubes}));
  if (groups.length === 0) return <p class="good">Every tube is reached.</p>;
  return (
    <Card>
      <GroupedTubes groups={groups.sort((a, b) => b.tubes.length - a.tubes.length)} />
    </Card>
  );
}
