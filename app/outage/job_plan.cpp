#include "app/outage/job_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "app/documents/plan_text.hpp"
#include "app/jobs/plan.hpp"
#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

using planner::SegmentKind, planner::VisitPlanStatus;

Cell cellOfLeg(const JobSheet& sheet) {
  Cell cell = readCellOf(sheet.leg);
  if (requireSheet(cell, "plan an outage").fingerprint() != sheet.fingerprint)
    throw InputError::problem(sheet.leg.cell, "its tube sheet is no longer the one that the job was made with",
                              "restore the cell's sheet, or make another job");
  return cell;
}

/// Returns the time of the tool's travel in one tube [s]: to the end of the extent and back.
double timeInTube(const WorkPackage& package, const JobTool& tool) {
  return tool.speed > 0 ? 2 * package.length / tool.speed : 0;
}

PlanRequest requestFor(const std::vector<JobItem>& items, const WorkPackage& package, const JobFile& job,
                       const Cell& cell, const JobPlanRequest& job_request) {
  std::vector<std::string> tubes;
  for (const JobItem& item : items) tubes.push_back(tubesheets::tubeName(item.tube.row, item.tube.column));
  PlanRequest request;
  request.tubes = fmt::format("{}", fmt::join(tubes, ","));
  request.load = job.toolOf(package).load / cell.units.factor(dimension::kForce);
  request.conditions.dwell = package.dwell + timeInTube(package, job.toolOf(package));
  request.conditions.start = job_request.start;
  request.seed = job_request.seed;
  request.has_least_standoff = true;
  return request;
}

void addTimes(const PlanOutcome& outcome, const WorkPackage& package, const JobTool& tool, PackagePlan& plan) {
  double dwell_times = 0;  // dwell times of the planner: the tool's travel in the tubes, and the package's dwell times
  for (const auto& visit : outcome.plan.visits) dwell_times += visit.dwell;
  plan.travel = outcome.plan.travel_time;
  plan.in_tubes = timeInTube(package, tool) * static_cast<double>(outcome.plan.visits.size());
  plan.dwell = dwell_times - plan.in_tubes;
  plan.approaches = outcome.plan.total_time - plan.travel - dwell_times;
}

/// Records the visiting order and the tubes out of reach.
void record(JobStore& store, const std::vector<JobItem>& items, const PlanOutcome& outcome, PackagePlan& plan) {
  std::map<std::pair<int, int>, const JobItem*> by_tube;
  for (const JobItem& item : items) by_tube[{item.tube.row, item.tube.column}] = &item;
  const auto itemAt = [&](int tube) {
    const auto& at = outcome.model.sheet.tubes[static_cast<std::size_t>(tube)];
    return by_tube.at({at.row, at.column});
  };
  store.transact([&] {
    std::vector<std::int64_t> order;
    for (const auto& visit : outcome.plan.visits) {
      order.push_back(itemAt(visit.tube)->id);
      store.setUnreachable(order.back(), "");
    }
    store.setPlaces(order);
    for (const auto& missed : outcome.plan.unreachable) {
      store.setUnreachable(itemAt(missed.tube)->id, missed.reason);
      plan.unreachable.emplace_back(itemAt(missed.tube)->tube, missed.reason);
    }
  });
}

/// Returns the results of an earlier plan of a package, kept in `folder`; none if the package was not planned.
PlanCheckpoint earlierPlan(const JobPlanRequest& job_request, const std::string& folder) {
  const std::filesystem::path earlier_folder = job_request.earlier / folder;
  std::error_code error;
  const bool is_there = !job_request.earlier.empty() && std::filesystem::exists(earlier_folder / kCacheFile, error);
  return {"", false, is_there ? earlier_folder.string() : ""};
}

PackagePlan planPackage(JobStore& store, const Cell& cell, const std::vector<JobItem>& items,
                        const JobPlanRequest& job_request, const planner::PlanHooks& hooks,
                        const KeepPackagePlan& keep) {
  const JobFile& job = store.job();
  const JobItem& first = items.front();
  const WorkPackage& package = job.packageOf(first.package);
  PackagePlan plan{first.package, first.tube.generator, first.tube.leg};
  plan.folder = fmt::format("{}-{}-{}", plan.generator, tubesheets::legName(plan.leg), plan.package);
  const PlanRequest request = requestFor(items, package, job, cell, job_request);
  PlanCheckpoint checkpoint = earlierPlan(job_request, plan.folder);
  const PlanOutcome outcome = planCell(cell, request, hooks, &checkpoint);
  plan.status = outcome.plan.status;
  plan.reason = outcome.plan.reason;
  if (plan.status == VisitPlanStatus::kStopped) return plan;
  record(store, items, outcome, plan);
  if (plan.status != VisitPlanStatus::kPlanned) return plan;
  plan.visits = static_cast<int>(outcome.plan.visits.size());
  plan.change = job.toolOf(package).change;
  addTimes(outcome, package, job.toolOf(package), plan);
  if (!checkpoint.fromFingerprint().empty()) plan.reused = reusedText(outcome);
  keep(plan.folder, request, outcome, checkpoint);
  return plan;
}

/// Returns the open and queued items of one leg, one list for each package, in the order of the packages.
std::vector<std::vector<JobItem>> itemsToPlan(const std::vector<JobItem>& items, const JobSheet& sheet,
                                              const JobFile& job, const JobPart& part) {
  const std::set<TubeAddress> plugged = pluggedEnds(items);
  std::vector<std::vector<JobItem>> by_package;
  for (const WorkPackage& package : job.packages) {
    std::vector<JobItem> of;
    for (const JobItem& item : items) {
      const bool is_to_do = item.isDue() || (!item.mark && !item.unreachable.empty());
      if (is_to_do && part.has(item) && !plugged.contains(item.tube) && item.package == package.name &&
          item.tube.generator == sheet.generator && item.tube.leg == sheet.leg.leg)
        of.push_back(item);
    }
    if (!of.empty()) by_package.push_back(std::move(of));
  }
  return by_package;
}

/// Sets the schedule of the planned legs.
void schedule(JobPlan& plan, const JobFile& job) {
  std::vector<LegWork> work;
  for (const LegPlan& leg : plan.legs) work.push_back({leg.total()});
  std::vector<ExclusiveLegs> exclusive_legs;
  for (const auto& names : job.exclusive_legs) {
    ExclusiveLegs group;
    for (std::size_t k = 0; k < plan.legs.size(); ++k)
      if (std::ranges::find(names, LegName{plan.legs[k].generator, plan.legs[k].leg}) != names.end())
        group.push_back(static_cast<int>(k));
    if (group.size() > 1) exclusive_legs.push_back(std::move(group));
  }
  plan.schedule = scheduleLegs(work, job.arms, exclusive_legs);
}

}  // namespace

double LegPlan::total() const {
  double sum = packages.empty() ? 0 : mount;
  for (const PackagePlan& package : packages) sum += package.total();
  return sum;
}

JobPlan planJob(JobStore& store, const JobPlanRequest& request, const planner::PlanHooks& hooks,
                const KeepPackagePlan& keep) {
  if (!request.start.empty() && (request.part.generator.empty() || !request.part.leg))
    throw InputError::problem("--start", "the arm can start under one leg only, but several are planned",
                              "name the leg with --sg and --leg");
  JobPlan plan;
  const std::vector<JobItem> items = store.items();
  for (const JobSheet& sheet : store.sheets()) {
    const auto to_plan = itemsToPlan(items, sheet, store.job(), request.part);
    if (to_plan.empty()) continue;
    const Cell cell = cellOfLeg(sheet);
    LegPlan& leg = plan.legs.emplace_back(LegPlan{sheet.generator, sheet.leg.leg, {}, store.job().mount});
    JobPlanRequest leg_request = request;
    std::string mounted;  // tool on the arm; empty when the arm enters the leg
    for (const auto& of_package : to_plan) {
      leg.packages.push_back(planPackage(store, cell, of_package, leg_request, hooks, keep));
      const std::string& tool = store.job().packageOf(of_package.front().package).tool;
      if (tool == mounted) leg.packages.back().change = 0;
      mounted = tool;
      leg_request.start.clear();  // the start position applies only to the first package
      if (leg.packages.back().status == VisitPlanStatus::kStopped) {
        leg.packages.pop_back();
        plan.is_stopped = true;
        return plan;
      }
    }
  }
  schedule(plan, store.job());
  return plan;
}

}  // namespace tubeplan::app
