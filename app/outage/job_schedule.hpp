// Schedule of the arms: legs are assigned to arms so that the last leg ends as early as possible (minimum makespan).
#pragma once

#include <vector>

namespace tubeplan::app {

/// Work in one leg: an arm is mounted there once and does all packages of the leg, one after the other.
struct LegWork {
  double duration = 0;  ///< [s]
};

/// Indices of mutually exclusive legs: at most one of them has an arm at any time.
using ExclusiveLegs = std::vector<int>;

/// Reason why a leg does not begin at time zero.
enum class WaitReason {
  kNone,       ///< no wait: the leg begins at time zero
  kArm,        ///< its arm is in another leg
  kExclusive,  ///< another leg, which excludes this one, has an arm
};

/// One leg in the schedule.
struct ScheduledLeg {
  int leg = 0;                ///< index of the leg
  int arm = 0;                ///< index of the arm
  double start = 0, end = 0;  ///< [s]
  WaitReason wait = WaitReason::kNone;
  int waits_for = -1;  ///< index of the leg at whose end this leg begins; -1 if it begins at time zero
  double idle = 0;     ///< idle time of the arm before this leg [s]
};

enum class ScheduleStatus { kNotRun, kOptimal, kFeasible };

struct Schedule {
  ScheduleStatus status = ScheduleStatus::kNotRun;
  std::vector<ScheduledLeg> legs;  ///< scheduled legs, in input order
  double end = 0;                  ///< end of the last leg [s]
  double lower_bound = 0;          ///< lower bound of the end of every schedule [s]
};

/// Assigns the legs to `arms` arms (identical machines without precedence; legs that are apart exclude each
/// other). The result is proved optimal for up to 16 legs, by branch and bound from the longest leg down (Graham 1969
/// gives the first solution), and for up to 12 legs of which some are apart, by branch and bound over the order in
/// which they begin. For more legs it is the first solution, which is optimal if it ends at the lower bound. Without
/// legs that are apart, its end is at most 4/3 of the least.
[[nodiscard]] Schedule scheduleLegs(const std::vector<LegWork>& legs, int arms,
                                    const std::vector<ExclusiveLegs>& exclusive_legs = {});

}  // namespace tubeplan::app
