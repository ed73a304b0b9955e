#include "app/outage/job_schedule.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "app/outage/start_order.hpp"

namespace tubeplan::app {

namespace {

constexpr std::size_t kMostExact = 16;  // largest number of legs for which the search is exhaustive

/// Search over assignments of legs, the longest first, to arms.
class ArmSearch {
 public:
  ArmSearch(const std::vector<LegWork>& legs, int arms)
      : legs_(legs), loads_(static_cast<std::size_t>(arms), 0), arm_of_(legs.size(), 0), order_(legs.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    std::ranges::stable_sort(order_, std::ranges::greater(), [&](std::size_t k) { return legs_[k].duration; });
    double sum = 0, longest = 0;
    for (const LegWork& leg : legs_) {
      sum += leg.duration;
      longest = std::max(longest, leg.duration);
    }
    lower_bound_ = std::max(sum / arms, longest);
    takeLongestFirst();
  }

  Schedule solve() {
    const bool is_exact = legs_.size() <= kMostExact;
    if (is_exact) {
      std::ranges::fill(loads_, 0);
      branch(0);
    }
    Schedule schedule = scheduled();
    schedule.lower_bound = is_exact ? best_ : lower_bound_;
    schedule.status = is_exact ? ScheduleStatus::kOptimal : ScheduleStatus::kFeasible;
    return schedule;
  }

 private:
  /// Assigns each leg, the longest first, to the arm that is available first.
  void takeLongestFirst() {
    for (const std::size_t leg : order_) {
      const auto free = std::ranges::min_element(loads_);
      *free += legs_[leg].duration;
      arm_of_[leg] = static_cast<int>(free - loads_.begin());
    }
    best_ = *std::ranges::max_element(loads_);
    best_arm_of_ = arm_of_;
  }

  void branch(std::size_t depth) {
    if (best_ <= lower_bound_) return;
    if (depth == order_.size()) {
      best_ = *std::ranges::max_element(loads_);
      best_arm_of_ = arm_of_;
      return;
    }
    const std::size_t leg = order_[depth];
    for (std::size_t arm = 0; arm < loads_.size(); ++arm) {
      const double before = loads_[arm];
      const bool is_like_earlier = std::find(loads_.begin(), loads_.begin() + static_cast<std::ptrdiff_t>(arm),
                                             before) != loads_.begin() + static_cast<std::ptrdiff_t>(arm);
      if (is_like_earlier || before + legs_[leg].duration >= best_) continue;
      loads_[arm] += legs_[leg].duration;
      arm_of_[leg] = static_cast<int>(arm);
      branch(depth + 1);
      loads_[arm] = before;
    }
  }

  [[nodiscard]] Schedule scheduled() const {
    Schedule schedule;
    std::vector<double> free(loads_.size(), 0);
    for (std::size_t leg = 0; leg < legs_.size(); ++leg) {
      double& at = free[static_cast<std::size_t>(best_arm_of_[leg])];
      ScheduledLeg& scheduled = schedule.legs.emplace_back();
      scheduled.leg = static_cast<int>(leg);
      scheduled.arm = best_arm_of_[leg];
      scheduled.start = at;
      scheduled.end = at + legs_[leg].duration;
      at += legs_[leg].duration;
      schedule.end = std::max(schedule.end, at);
    }
    return schedule;
  }

  const std::vector<LegWork>& legs_;
  std::vector<double> loads_;
  std::vector<int> arm_of_, best_arm_of_;
  std::vector<std::size_t> order_;
  double lower_bound_ = 0, best_ = 0;
};

/// Returns a lower bound of every schedule's end [s]: that without exclusions, or the total work of a
/// group.
double lowerBound(const Schedule& without, const std::vector<LegWork>& legs,
                  const std::vector<ExclusiveLegs>& exclusive_legs) {
  double bound = without.lower_bound;
  for (const ExclusiveLegs& group : exclusive_legs) {
    double sum = 0;
    for (const int leg : group) sum += legs[static_cast<std::size_t>(leg)].duration;
    bound = std::max(bound, sum);
  }
  return bound;
}

Schedule withExclusions(const Schedule& without, const std::vector<LegWork>& legs, int arms,
                        const std::vector<ExclusiveLegs>& exclusive_legs) {
  Schedule schedule;
  schedule.lower_bound = lowerBound(without, legs, exclusive_legs);
  const StartOrder order = bestStartOrder(legs, arms, exclusive_legs, schedule.lower_bound);
  schedule.legs = order.legs;
  std::ranges::sort(schedule.legs, {}, &ScheduledLeg::leg);
  schedule.end = order.end;
  if (order.is_optimal) schedule.lower_bound = order.end;
  schedule.status = order.is_optimal ? ScheduleStatus::kOptimal : ScheduleStatus::kFeasible;
  return schedule;
}

/// Sets the predecessor of each leg: the leg that ends when it begins, of the same arm or otherwise of the same group.
void nameWaits(Schedule& schedule, const std::vector<ExclusiveLegs>& exclusive_legs) {
  const auto areExclusive = [&](int one, int other) {
    return std::ranges::any_of(exclusive_legs, [&](const ExclusiveLegs& group) {
      return std::ranges::count(group, one) > 0 && std::ranges::count(group, other) > 0;
    });
  };
  for (ScheduledLeg& leg : schedule.legs)
    for (const ScheduledLeg& other : schedule.legs) {
      if (other.leg == leg.leg || other.end != leg.start || leg.start == 0) continue;
      const bool is_arm = other.arm == leg.arm;
      if (!is_arm && (leg.wait == WaitReason::kArm || !areExclusive(leg.leg, other.leg))) continue;
      leg.wait = is_arm ? WaitReason::kArm : WaitReason::kExclusive;
      leg.waits_for = other.leg;
    }
}

}  // namespace

Schedule scheduleLegs(const std::vector<LegWork>& legs, int arms, const std::vector<ExclusiveLegs>& exclusive_legs) {
  assert(arms > 0);
  if (legs.empty()) return {ScheduleStatus::kOptimal, {}, 0, 0};
  Schedule schedule = ArmSearch(legs, arms).solve();
  if (!exclusive_legs.empty()) schedule = withExclusions(schedule, legs, arms, exclusive_legs);
  nameWaits(schedule, exclusive_legs);
  return schedule;
}

}  // namespace tubeplan::app
