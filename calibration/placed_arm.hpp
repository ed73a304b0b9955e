// The arm on its base, and the parameters of arm and base that a fit may change.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "calibration/measurement.hpp"
#include "deflection/effects/effect.hpp"
#include "deflection/parameters.hpp"

namespace tubeplan::calibration {

/// A small change of a base pose: translation of the base's origin [m], then a rotation vector [rad], both in world
/// axes. X_WB becomes (exp(rotation) R, p + translation). Every 6 x 6 covariance of a base pose has this order.
using BaseStep = Eigen::Matrix<double, 6, 1>;
[[nodiscard]] Eigen::Isometry3d moved(const Eigen::Isometry3d& X_WB, const BaseStep& step);

/// Returns "base.shift.x", ..., "base.turn.z": the names of a base step's components.
[[nodiscard]] const std::array<std::string, 6>& baseStepNames();

/// Pose of the base in one set-up of a session.
struct BasePose {
  std::string setup;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  bool is_known = false;
};

/// A variable that a fit may change: a parameter of the arm or one of the six components of a base pose (a shift [m]
/// along or a rotation [rad] about a world axis, relative to the start). The variable of a stiffness is the change of
/// its inverse, the compliance: readings depend almost linearly on it, even for a rigid axis, where it is zero. The
/// variable's bounds keep stiffnesses positive.
struct Unknown {
  enum class Owner { kArm, kBase };
  std::string name;  ///< dotted name, such as "tool.joint_stiffness.z", "base.shift.x" or "base.turn.z@SETUP"
  deflection::Quantity quantity = deflection::Quantity::kNone;
  Owner owner = Owner::kArm;
  deflection::ParameterPath path;
  int base_pose = -1, component = -1;
  enum class Scale { kLinear, kCompliance };
  Scale scale = Scale::kLinear;
  bool is_geometry = false;  ///< true: freed through the name `geometry`
  double typical = 1;        ///< likely distance of the variable from its start, by which solvers scale the variable
  double prior_sigma = 10;   ///< standard deviation of the variable's normal prior; infinite: no prior
  /// Mean of the variable's prior: the value in the file (0 unless the unknown was rebased), or the neutral value of an
  /// effect's size.
  double prior_mean = 0;
  double start = 0;             ///< start value of the parameter
  double lower = 0, upper = 0;  ///< bounds of the variable, which is 0 at the start
};

/// Sets the prior of an effect's size: its mean is the neutral value, its standard deviation the largest size on real
/// machines.
void takeSizePrior(const deflection::EffectParameter& parameter, Unknown& unknown);

/// Returns the variables at their start: zeros, one per unknown.
[[nodiscard]] inline Eigen::VectorXd zerosOf(const std::vector<Unknown>& unknowns) {
  return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns.size()));
}

/// Returns Unknown::typical of every unknown.
[[nodiscard]] inline Eigen::VectorXd typicalsOf(const std::vector<Unknown>& unknowns) {
  Eigen::VectorXd typicals = zerosOf(unknowns);
  for (std::size_t k = 0; k < unknowns.size(); ++k) typicals[static_cast<Eigen::Index>(k)] = unknowns[k].typical;
  return typicals;
}

/// Prior standard deviations of the parameters about their values in the arm's file. Lengths and angles of frames,
/// joint offsets, the tip and the tool's rotation each have one. The prior of an effect's size has the neutral value as
/// mean and the largest size on real machines as standard deviation. All other parameters have a weak prior, whose
/// standard deviation is a multiple of Unknown::typical; a few readings outweigh it.
struct Priors {
  double length = 0.005;  ///< lengths of frames, and offsets of prismatic joints [m]
  double angle = 0.02;    ///< angles of frames, and offsets of revolute joints [rad]
  double tip = 0.05;      ///< coordinates of the tool's tip, which is mounted and measured by hand [m]
  double turn = 0.1;      ///< rotation of the tool frame, which is mounted by hand too [rad]
  double weak = 10;       ///< all other parameters, as a multiple of Unknown::typical
  /// Standard deviations of individual parameters, keyed by name, in internal units; of a stiffness, that of its
  /// compliance.
  std::map<std::string, double> named;
};

struct PlacedArm {
  deflection::Arm arm;
  std::vector<BasePose> base_poses;
  Priors priors = {};  ///< priors of the latest choice of unknowns, also used for parameters freed later
  /// True: some reading depends on the tool's rotation. False: the parameters of that rotation do not count as
  /// geometry.
  bool shows_tool_turn = false;
};

/// Returns the index of the base pose of a reading's set-up, which must be one of `placed.base_poses`.
[[nodiscard]] int basePoseOf(const PlacedArm& placed, const Measurement& reading);

/// Returns the base pose X_WB at which a reading was taken.
[[nodiscard]] const Eigen::Isometry3d& basePoseAt(const PlacedArm& placed, const Measurement& reading);

/// Reason why a name cannot be freed.
struct FreeProblem {
  std::string name;
  std::string what;         ///< the reason, as a sentence
  std::string advice;       ///< advice to the user
  bool is_unknown = false;  ///< true: the arm has no parameter of that name
};

struct FreeChoice {
  std::vector<std::string> names;  ///< names to free, each expanded by namesBehind()
  bool base = true;                ///< true: every unknown base pose is freed too
  Priors priors = {};
};

/// The unknowns of a choice: base poses first, then named parameters in the order of the names, then `geometry`.
/// chooseUnknowns() makes named rigid axes finite in `placed`. Every variable is 0 at the start.
struct Unknowns {
  std::vector<FreeProblem> problems;
  std::vector<Unknown> list;
};
[[nodiscard]] Unknowns chooseUnknowns(PlacedArm& placed, const FreeChoice& choice);

/// Returns the parameter names that `name` stands for: itself, everything below it ("tool.tip", "forearm.origin.rpy",
/// "forearm.dh"), or every geometric parameter ("geometry", of which independentGeometry() selects those to free).
[[nodiscard]] std::vector<std::string> namesBehind(const deflection::Arm& arm, const std::string& name);

/// Returns every name that may be freed: "geometry", the arm's parameters, and the names of groups of parameters.
[[nodiscard]] std::vector<std::string> freeableNames(const deflection::Arm& arm);

/// Returns a copy of `start` with the variables `x` applied to the unknowns.
[[nodiscard]] PlacedArm applied(const PlacedArm& start, const std::vector<Unknown>& unknowns, const Eigen::VectorXd& x);

/// Applies the variables `x` to `placed`, a copy of `start` that differs from `start` only in these unknowns.
void apply(const PlacedArm& start, const std::vector<Unknown>& unknowns, const Eigen::VectorXd& x, PlacedArm& placed);

/// Returns the unknown with its variable shifted to be 0 at this parameter value; an unknown of a base is returned
/// unchanged.
[[nodiscard]] Unknown rebased(Unknown unknown, double value);

/// Return the parameter value at the variable `x`, and the derivative of the value with respect to `x`.
[[nodiscard]] double valueAt(const Unknown& unknown, double x);
[[nodiscard]] double slopeAt(const Unknown& unknown, double x);

/// Returns the variable at a parameter value: the inverse of valueAt().
[[nodiscard]] double variableAt(const Unknown& unknown, double value);

/// Returns the smallest and the largest parameter value between two values of the variable. If the compliance may be
/// zero, the largest stiffness is infinite.
[[nodiscard]] std::pair<double, double> valuesBetween(const Unknown& unknown, double lower, double upper);

}  // namespace tubeplan::calibration
