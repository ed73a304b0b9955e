// Which arm works in which leg, and when: legs are shared out among arms so that the last one ends as early as
// possible.
#pragma once

#include <vector>

namespace tubeplan::app {

/// Work in one leg: an arm is mounted there once and does all packages of the leg, one after the other.
struct LegWork {
  double duration = 0;  ///< [s]
};

/// One leg in the schedule.
struct ScheduledLeg {
  int leg = 0;                ///< index of the leg
  int arm = 0;                ///< index of the arm
  double start = 0, end = 0;  ///< [s]
};

enum class ScheduleStatus { kNotRun, kOptimal, kFeasible };

struct Schedule {
  ScheduleStatus status = ScheduleStatus::kNotRun;
  std::vector<ScheduledLeg> legs;  ///< in the order of the given legs
  double end = 0;                  ///< end of the last leg [s]
  double lower_bound = 0;          ///< no schedule ends before this time [s]
};

/// Shares out the legs among `arms` arms (identical machines without precedence). The result is proved optimal for up
/// to 16 legs, by branch and bound from the longest leg down (Graham 1969 gives the first solution); for more legs it
/// is the first solution, whose end is at most 4/3 of the least.
[[nodiscard]] Schedule scheduleLegs(const std::vector<LegWork>& legs, int arms);

}  // namespace tubeplan::app
