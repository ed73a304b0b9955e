// Plan of a whole job: the proved plan of every package on every leg, and the duration of the outage.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/documents/plan_outcome.hpp"
#include "app/formats/checkpoint/plan_checkpoint.hpp"
#include "app/outage/job_desk.hpp"
#include "app/outage/job_schedule.hpp"
#include "app/outage/job_store.hpp"

namespace tubeplan::app {

/// Plan of one package on one leg.
struct PackagePlan {
  std::string package, generator;
  tubesheets::Leg leg = tubesheets::Leg::kHot;
  planner::VisitPlanStatus status = planner::VisitPlanStatus::kNotRun;
  std::string reason = {};  ///< reason why there is no plan; empty if there is one
  std::string folder = {};  ///< name of the folder with the plan's files
  std::string reused = {};  ///< results reused from the package's earlier plan; empty if there was none
  int visits = 0;
  std::vector<std::pair<TubeAddress, std::string>> unreachable = {};  ///< tubes out of reach, with reasons
  double travel = 0;                                                  ///< time between tubes [s]
  double approaches = 0;                                              ///< time of approaches and retreats [s]
  double in_tubes = 0;                                                ///< time of the tool's travel in the tubes [s]
  double dwell = 0;                                                   ///< dwell time at the tubes [s]
  double change = 0;                                                  ///< time to mount the tool [s]

  [[nodiscard]] double total() const { return travel + approaches + in_tubes + dwell + change; }
};

/// The work on one leg, with the mounting of the arm.
struct LegPlan {
  std::string generator;
  tubesheets::Leg leg = tubesheets::Leg::kHot;
  std::vector<PackagePlan> packages;
  double mount = 0;  ///< time to mount the arm and calibrate its base [s]

  [[nodiscard]] double total() const;
};

struct JobPlan {
  std::vector<LegPlan> legs;
  Schedule schedule;  ///< schedule of `legs`
  bool is_stopped = false;
};

struct JobPlanRequest {
  std::uint64_t seed = 1;
  JobPart part = {};       ///< part to plan; all other items keep their place in the visiting order
  std::string start = {};  ///< start posture of the arm, as ConditionsRequest::start; empty for any posture
  std::filesystem::path earlier =
      {};  ///< folder with the folders of an earlier plan of the job; empty if there is none
};

/// Writes the files of one package's plan; called as soon as the package is planned. `checkpoint` has the results
/// that the next plan of the package can reuse.
using KeepPackagePlan = std::function<void(const std::string& folder, const PlanRequest&, const PlanOutcome&,
                                           const PlanCheckpoint& checkpoint)>;

/// Plans the open and queued items of every package on every leg, in the order of the packages, and records their
/// visiting order and the tubes out of reach. The first package begins at the arm's position. Packages planned before a
/// stop remain recorded. Throws InputError if a cell's sheet has changed since the job was created, and for a
/// start in a part with several legs.
[[nodiscard]] JobPlan planJob(JobStore& store, const JobPlanRequest& request, const planner::PlanHooks& hooks,
                              const KeepPackagePlan& keep);

}  // namespace tubeplan::app
