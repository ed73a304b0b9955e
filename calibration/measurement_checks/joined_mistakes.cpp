#include "calibration/measurement_checks/joined_mistakes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>
#include <string>

#include "calibration/measurement_checks/golden_section.hpp"
#include "calibration/measurement_checks/joint_order.hpp"
#include "calibration/measurement_checks/joint_scale.hpp"
#include "calibration/measurement_checks/joint_sign.hpp"
#include "calibration/measurement_checks/joint_zero.hpp"
#include "calibration/measurement_checks/quick_alignment.hpp"
#include "calibration/measurement_checks/scales_together.hpp"

namespace tubeplan::calibration {

namespace {

using Eigen::Vector3d;

constexpr std::size_t kMostScored = 20;    // maximum number of measurements in the quick comparison
constexpr std::size_t kMostTogether = 16;  // maximum number of hypotheses that are returned
constexpr int kMostSigns = 8;              // maximum number of joints for which all sets of signs are tried
constexpr int kMostOrdered = 7;            // maximum number of joints for which all orders are tried
constexpr double kNearer = 0.25;           // smallest decrease of the mean log error required of each correction
constexpr double kByWeights = 0.5;         // largest further decrease of the mean log error expected of robust weights
constexpr std::size_t kMostSettled = 100;  // maximum number of hypotheses whose zeros are refined
constexpr double kZeroRange = std::numbers::pi / 12;  // range on either side of a tried zero [rad]
constexpr int kZeroSteps = 10;                        // number of golden-section steps

/// Corrections of one mistake or of a set of joints, with the corrected measurements and their score.
struct TriedQuickly {
  JoinedCorrections corrections;
  std::vector<Measurement> measurements;
  std::vector<Vector3d> tips;
  double score = 0;
  bool turns_joints = false;
};

/// One of the tried corrections alone, or two of them in sequence.
struct Likely {
  const TriedQuickly *first = nullptr, *then = nullptr;
  double score = 0;
  /// The same corrections with refined zeros, which bring the measurements closest to the drawing; empty if the zeros
  /// were not refined.
  JoinedCorrections settled = {};

  [[nodiscard]] JoinedCorrections corrections() const {
    if (!settled.empty()) return settled;
    JoinedCorrections all = first->corrections;
    if (then) all.insert(all.end(), then->corrections.begin(), then->corrections.end());
    return all;
  }
};

bool haveSameJoints(const std::vector<Measurement>& a, const std::vector<Measurement>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const auto& one, const auto& other) {
           return one.id == other.id && one.q == other.q;
         });
}

bool freeBase(const JoinedCorrections& corrections) {
  return std::ranges::any_of(corrections, [](const Correction& correction) { return correction.frees_base; });
}

/// Returns a key that identifies the corrections: "joint-zero=3," for a zero, whose value is refined later, and the
/// full assumption for other corrections.
std::string keyOf(const JoinedCorrections& corrections) {
  std::string key;
  for (const Correction& correction : corrections)
    key += correction.mistake + "=" +
           (correction.zeros_of.empty() ? correction.value : std::to_string(correction.zeros_of.front())) + ",";
  return key;
}

class JoinedSearch {
 public:
  explicit JoinedSearch(const MistakeTrials& trials)
      : trials_(trials), alignment_(trials.checked().start, trials.reach()) {
    const auto& pool = trials.pool();
    for (const auto& measurement : pool.measurements)
      if (statesPlace(measurement) && pool.counted_quickly.contains(measurement.id) && ids_.size() < kMostScored)
        ids_.insert(measurement.id);
    // The neighbours of the compared measurements are kept until the first correction is applied, because it may move
    // measured values between rows.
    for (std::size_t k = 0; k < pool.measurements.size(); ++k) {
      const auto is_scored = [&](std::size_t near) {
        return near < pool.measurements.size() && ids_.contains(pool.measurements[near].id);
      };
      if (is_scored(k - 1) || is_scored(k) || is_scored(k + 1)) near_.push_back(pool.measurements[k]);
    }
  }

  std::vector<JoinedCorrections> find() {
    if (!(as_is_ = scored({})).tips.empty() && std::isfinite(as_is_.score)) {
      lookAlone();
      lookAtPairs();
      lookAtOrders();
      settleZeros();
      lookAtScales();
    }
    std::ranges::stable_sort(found_, {}, &Likely::score);
    std::vector<JoinedCorrections> likely;
    std::set<std::string> keys;
    for (const Likely& likely_mistake : found_) {
      auto corrections = likely_mistake.corrections();
      if (likely.size() < kMostTogether && keys.insert(keyOf(corrections)).second)
        likely.push_back(std::move(corrections));
    }
    return likely;
  }

 private:
  /// Applies the corrections to the measurements and all their neighbours, and scores the compared measurements.
  TriedQuickly scored(JoinedCorrections corrections) {
    TriedQuickly tried{std::move(corrections), near_, {}, 0, false};
    for (const Correction& correction : tried.corrections) correction.change(tried.measurements);
    std::erase_if(tried.measurements, [&](const Measurement& measurement) { return !ids_.contains(measurement.id); });
    tried.tips = alignment_.tips(tried.measurements);
    tried.score = alignment_.score(tried.measurements, tried.tips, {.frees_base = freeBase(tried.corrections)});
    tried.turns_joints = !haveSameJoints(tried.measurements, as_is_.measurements);
    return tried;
  }

  void lookAlone() {
    const CheckedMeasurements& checked = trials_.checked();
    for (const auto& kind : mistakeKinds())
      for (const auto& value : (kind.values_with_others ? kind.values_with_others : kind.values)(checked)) {
        throwIfStopped(trials_.options().stop);
        auto correction = kind.correction(checked, value);
        if (!correction || correction->parts_setups) continue;
        alone_.push_back(scored({std::move(*correction)}));
        if (alone_.back().measurements.empty()) alone_.pop_back();
      }
    lookAtSigns();
  }

  /// Tries all sets of two or more joints with reversed signs.
  void lookAtSigns() {
    const CheckedMeasurements& checked = trials_.checked();
    const auto joints = mistakes::joint_sign::values(checked);
    if (joints.size() > kMostSigns) return;
    for (unsigned set = 1; set < 1U << joints.size(); ++set) {
      JoinedCorrections corrections;
      for (std::size_t j = 0; j < joints.size(); ++j)
        if (set >> j & 1) corrections.push_back(*mistakes::joint_sign::correction(checked, joints[j]));
      if (corrections.size() > 1) sets_of_signs_.push_back(scored(std::move(corrections)));
    }
    for (const TriedQuickly& signs : sets_of_signs_) found_.push_back({&signs, nullptr, signs.score});
  }

  /// Tries scales for all joints whose readings exceed the range of any real joint, if there are at least two such
  /// joints.
  void lookAtScales() {
    const CheckedMeasurements& checked = trials_.checked();
    const auto joints = mistakes::joint_scale::jointsBeyondTurns(checked);
    if (joints.size() < 2) return;
    for (const auto& values : likelyScales(checked, joints)) {
      JoinedCorrections corrections;
      for (const auto& value : values) corrections.push_back(*mistakes::joint_scale::kind().correction(checked, value));
      scales_.push_back(scored(std::move(corrections)));
    }
    for (const TriedQuickly& scales : scales_) found_.push_back({&scales, nullptr, scales.score});
  }

  /// Tries all permutations of the columns of joints of the same type. An exchange of only two columns is excluded,
  /// because it is a single mistake.
  void lookAtOrders() {
    const CheckedMeasurements& checked = trials_.checked();
    const auto& arm = checked.start.arm;
    if (arm.jointCount() > kMostOrdered) return;
    std::vector<int> order(static_cast<std::size_t>(arm.jointCount()));
    std::iota(order.begin(), order.end(), 0);
    while (std::ranges::next_permutation(order).found) {
      throwIfStopped(trials_.options().stop);
      std::size_t moved = 0;
      bool are_alike = true;
      for (std::size_t j = 0; j < order.size(); ++j) {
        moved += order[j] != static_cast<int>(j) ? 1 : 0;
        are_alike = are_alike && arm.joint(order[j]).type == arm.joint(static_cast<int>(j)).type;
      }
      if (moved <= 2 || !are_alike) continue;
      auto tried = scored(mistakes::joint_order::ringsOf(checked, order));
      if (tried.score < as_is_.score - kNearer) orders_.push_back(std::move(tried));
      if (orders_.size() >= 2 * kMostTogether) keepBestOrders();
    }
    keepBestOrders();
    for (const TriedQuickly& tried : orders_) found_.push_back({&tried, nullptr, tried.score});
  }

  void keepBestOrders() {
    std::ranges::stable_sort(orders_, {}, &TriedQuickly::score);
    if (orders_.size() > kMostTogether) orders_.erase(orders_.begin() + kMostTogether, orders_.end());
  }

  static bool canJoin(const Correction& first, const Correction& then) {
    if (first.mistake != then.mistake) return true;
    return findMistakeKind(first.mistake)->joins_itself && (first.zeros_of.empty() || first.zeros_of != then.zeros_of);
  }

  void lookAtPairs() {
    for (std::size_t a = 0; a < alone_.size(); ++a) {
      throwIfStopped(trials_.options().stop);
      for (std::size_t b = a + 1; b < alone_.size(); ++b)
        if (canJoin(alone_[a].corrections.front(), alone_[b].corrections.front())) lookAtPair(alone_[a], alone_[b]);
      if (!alone_[a].turns_joints)
        for (const auto& signs : sets_of_signs_) lookAtPair(alone_[a], signs);
    }
  }

  void lookAtPair(const TriedQuickly& first, const TriedQuickly& then) {
    auto measurements = first.measurements;
    for (const Correction& correction : then.corrections) correction.change(measurements);
    const bool is_new = first.turns_joints && then.turns_joints;
    const auto tips = is_new ? alignment_.tips(measurements) : std::vector<Vector3d>{};
    const auto& of_pair = is_new ? tips : then.turns_joints ? then.tips : first.tips;
    if (measurements.size() != of_pair.size()) return;
    const double least = std::min({first.score, then.score, as_is_.score}) - kNearer;
    const double promising = std::min(least, worst_kept_) + kByWeights;
    const double score = alignment_.score(
        measurements, of_pair,
        {.frees_base = freeBase(first.corrections) || freeBase(then.corrections), .promising = promising});
    if (score > std::min(least, worst_kept_)) return;
    found_.push_back({&first, &then, score});
    if (found_.size() < 2 * kKept) return;
    std::ranges::nth_element(found_, found_.begin() + kKept, {}, &Likely::score);
    worst_kept_ = found_[kKept].score;
    found_.resize(kKept);
  }

  /// Refines the zeros of the most promising hypotheses to the values that bring the measurements closest to the
  /// drawing, because tried zeros are widely spaced.
  void settleZeros() {
    std::ranges::stable_sort(found_, {}, &Likely::score);
    std::set<std::string> keys;
    for (Likely& likely : found_) {
      throwIfStopped(trials_.options().stop);
      const auto corrections = likely.corrections();
      const auto isOfZero = [](const Correction& correction) { return !correction.zeros_of.empty(); };
      if (keys.size() < kMostSettled && std::ranges::any_of(corrections, isOfZero) &&
          keys.insert(keyOf(corrections)).second)
        settle(likely);
    }
  }

  void settle(Likely& likely) {
    TriedQuickly tried = scored(likely.corrections());
    for (Correction& correction : tried.corrections) {
      if (correction.zeros_of.empty()) continue;
      const int joint = correction.zeros_of.front();
      const double shift = bestShift(tried, joint);
      const double zero = mistakes::joint_zero::zeroOf(trials_.checked(), correction.value) + shift;
      correction = *mistakes::joint_zero::correction(trials_.checked(),
                                                     mistakes::joint_zero::textOf(trials_.checked(), joint, zero));
      for (Measurement& measurement : tried.measurements) measurement.q[joint] += shift;
    }
    likely.score = std::min(likely.score, scoreOf(tried));
    likely.settled = std::move(tried.corrections);
  }

  [[nodiscard]] double scoreOf(const TriedQuickly& tried) {
    return alignment_.score(tried.measurements, alignment_.tips(tried.measurements),
                            {.frees_base = freeBase(tried.corrections)});
  }

  /// Returns the additional offset of a joint's zero that gives the best score [rad], by golden-section search.
  double bestShift(const TriedQuickly& tried, int joint) {
    const auto scoreAt = [&](double shift) {
      TriedQuickly shifted = tried;
      for (Measurement& measurement : shifted.measurements) measurement.q[joint] += shift;
      return scoreOf(shifted);
    };
    return leastOf(scoreAt, -kZeroRange, kZeroRange, kZeroSteps);
  }

  static constexpr std::size_t kKept = 200;

  const MistakeTrials& trials_;
  QuickAlignment alignment_;
  std::set<std::string> ids_;
  std::vector<Measurement> near_;
  TriedQuickly as_is_;
  std::vector<TriedQuickly> alone_, sets_of_signs_, orders_, scales_;
  std::vector<Likely> found_;
  double worst_kept_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::vector<JoinedCorrections> likelyTogether(const MistakeTrials& trials) { return JoinedSearch(trials).find(); }

}  // namespace tubeplan::calibration
