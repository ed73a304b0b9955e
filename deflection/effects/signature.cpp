#include "deflection/effects/signature.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::deflection {

namespace {

using Eigen::Index, Eigen::Matrix3Xd, Eigen::Vector3d;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
// Weight of a sweep over a condition or direction, relative to a sweep over the load. It is large because few laws
// depend on conditions or directions.
constexpr double kOfCondition = 5;
constexpr double kOfOwnJoint = 3;  // weight of a sweep over the effect's own joint
constexpr double kOfReach = 1e-9;  // tip shifts up to this fraction of the reach are attributed to rounding
constexpr double kOfRange = 0.05;  // smallest distance from a joint's limits, as a fraction of its range

/// Returns the effect at half of its plausible magnitude. A step in time occurs halfway through the sweep of time.
Effect ofUsualSize(const Arm& arm, Effect effect) {
  const auto& numbers = numbersOf(effect);
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    const auto bounds = numberOf(arm, effect, static_cast<int>(v));
    double value = numbers[v].neutral;
    if (numbers[v].quantity == Quantity::kTime && numbers[v].is_shape)
      value = kindOf(Condition::kTime).sweep.high / 2;
    else if (std::isfinite(numbers[v].plausible))
      value += numbers[v].plausible / 2;
    effect.values[v] = std::clamp(value, bounds.lower, bounds.upper);
  }
  return effect;
}

struct Range {
  double lower, upper;
};

Range rangeOf(const Joint<double>& joint) {
  constexpr double kHalfTurn = std::numbers::pi;
  if (!std::isfinite(joint.lower) || !std::isfinite(joint.upper)) return {-kHalfTurn, kHalfTurn};
  const double kept = kOfRange * (joint.upper - joint.lower);
  return {joint.lower + kept, joint.upper - kept};
}

class Sweeper {
 public:
  Sweeper(const Arm& arm, const Effect& effect, const Vector3d& gravity_B, const SignatureOptions& options)
      : options_(options), without_(arm), with_(arm) {
    with_.effects.push_back(ofUsualSize(arm, effect));
    const Index joints = arm.jointCount();
    middle_.q.resize(joints);
    for (Index j = 0; j < joints; ++j) {
      const Range range = rangeOf(arm.joint(j));
      // Golden ratio: gives irregular fractions of the joint ranges, which avoids symmetric postures.
      constexpr double kGolden = 0.6180339887498949;
      const double share = 0.3 + 0.4 * std::fmod(0.5 + kGolden * static_cast<double>(j), 1);
      middle_.q[j] = range.lower + share * (range.upper - range.lower);
    }
    middle_.gravity_B = gravity_B;
    middle_.load = options.most_load / 2;
    middle_.approach_directions.assign(static_cast<std::size_t>(joints), 1);
    for (const ConditionKind& kind : kConditionKinds)
      middle_.conditions[kind.condition] = arm.reference[kind.condition] + kind.sweep.otherwise;
  }

  Signature best() {
    for (int j = 0; j < without_.jointCount(); ++j) {
      const Range range = rangeOf(without_.joint(j));
      sweep(EffectVariable::kJoint, j, range, [j](Posture& posture, double at) { posture.q[j] = at; });
      sweep(EffectVariable::kDirection, j, {-1, 1}, [j](Posture& posture, double at) {
        posture.approach_directions[static_cast<std::size_t>(j)] = static_cast<int>(at);
      });
    }
    if (options_.most_load > 0)
      sweep(EffectVariable::kLoad, -1, {0, options_.most_load}, [](Posture& posture, double at) { posture.load = at; });
    for (const ConditionKind& kind : kConditionKinds)
      if (kind.sweep.low < kind.sweep.high) sweepCondition(kind);
    return std::move(best_);
  }

 private:
  void sweepCondition(const ConditionKind& kind) {
    const double usual = without_.reference[kind.condition];
    sweep(kind.condition, -1, {usual + kind.sweep.low, usual + kind.sweep.high},
          [&](Posture& posture, double at) { posture.conditions[kind.condition] = at; });
  }

  /// Returns the tip's shift due to the effect [m], in the last row's axes, so that turning the first joint does not
  /// change it.
  [[nodiscard]] Vector3d shiftAt(const Posture& posture) const {
    const auto without = solveFlexibleKinematics(without_, posture), with = solveFlexibleKinematics(with_, posture);
    if (without.status != KinematicsStatus::kConverged || with.status != KinematicsStatus::kConverged)
      return Vector3d::Constant(kNaN);
    return without.X_BD.R.transpose() * (with.X_BD.p - without.X_BD.p);
  }

  template <class Set>
  void sweep(EffectVariable kind, int joint, Range range, Set set) {
    const int steps = kind.is(EffectVariable::kDirection) ? 1 : options_.steps;
    Signature found{kind, joint, {}, {}};
    Matrix3Xd shifts(3, steps + 1);
    for (int k = 0; k <= steps; ++k) {
      Posture posture = middle_;
      found.at.push_back(range.lower + (range.upper - range.lower) * k / steps);
      set(posture, found.at.back());
      shifts.col(k) = shiftAt(posture);
    }
    take(std::move(found), shifts);
  }

  [[nodiscard]] double weightOf(const Signature& found) const {
    if (found.kind->is(EffectVariable::kLoad)) return 1;
    if (!found.kind->is(EffectVariable::kJoint)) return kOfCondition;
    const int row = activeRows(without_)[static_cast<std::size_t>(found.joint)];
    const Place& place = with_.effects.back().place;
    return row == place.row || row == place.other ? kOfOwnJoint : 1;
  }

  /// Keeps a sweep's signature if its weighted change is the largest so far. The reported shift is the component along
  /// the axis on which the shifts change most.
  void take(Signature found, const Matrix3Xd& shifts) {
    Matrix3Xd changes(3, 0);
    for (Index k = 0; k < shifts.cols(); ++k) {
      if (!shifts.col(k).allFinite()) continue;
      changes.conservativeResize(Eigen::NoChange, changes.cols() + 1);
      changes.rightCols<1>() = shifts.col(k);
    }
    if (changes.cols() < 2) return;
    changes.colwise() -= Vector3d(changes.rowwise().mean());
    const double change = changes.colwise().norm().maxCoeff(), weighed = change * weightOf(found);
    if (change <= kOfReach * reachOf(without_) || weighed <= most_change_) return;
    most_change_ = weighed;
    // A fully dynamic matrix is needed: with three fixed rows, Eigen fixes U at 3 x 3, but only two columns are needed.
    const Eigen::JacobiSVD<Eigen::MatrixXd> axes(changes, Eigen::ComputeThinU);
    const Vector3d axis = axes.matrixU().col(0);
    for (Index k = 0; k < shifts.cols(); ++k) found.shift.push_back(axis.dot(shifts.col(k)));
    best_ = std::move(found);
  }

  const SignatureOptions& options_;
  Arm without_, with_;
  Posture middle_;
  Signature best_;
  double most_change_ = 0;
};

}  // namespace

Signature signatureOf(const Arm& arm, const Effect& effect, const Vector3d& gravity_B,
                      const SignatureOptions& options) {
  return Sweeper(arm, effect, gravity_B, options).best();
}

}  // namespace tubeplan::deflection
