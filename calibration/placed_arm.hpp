// An arm with its base poses, and the parameters of both that a fit may change.
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

/// Returns the names of the components of a base step: "base.shift.x", ..., "base.turn.z".
[[nodiscard]] const std::array<std::string, 6>& baseStepNames();

/// Pose of the base in one set-up, that is, while the base is not moved.
struct BasePose {
  std::string setup;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  bool is_known = false;
};

/// A variable that a fit may change: a parameter of the arm or one of the six components of a base pose (a shift [m]
/// along or a rotation [rad] about a world axis, relative to the start). The variable of a stiffness is the change of
/// its inverse, the compliance: measurements depend almost linearly on it, even for a rigid axis, where it is zero. The
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
  bool is_geometry = false;  ///< true if freed because the choice of parameters names `geometry`
  double typical = 1;        ///< expected magnitude of the variable's change; solvers divide the variable by it
  double prior_sigma = 10;   ///< standard deviation of the variable's normal prior; infinite if there is no prior
  /// Mean of the variable's prior. It corresponds to the value in the arm's file (0 unless the unknown was rebased) or,
  /// for the magnitude of an effect, to the value at which the effect vanishes.
  double prior_mean = 0;
  double start = 0;             ///< value of the parameter at the start
  double lower = 0, upper = 0;  ///< bounds of the variable, which is 0 at the start
};

/// Sets the prior of a parameter that is an effect's magnitude. The mean is the value at which the effect vanishes; the
/// standard deviation is the largest magnitude that real machines have.
void takeSizePrior(const deflection::EffectParameter& parameter, Unknown& unknown);

/// Returns the start values of the variables: a vector of zeros, one per unknown.
[[nodiscard]] inline Eigen::VectorXd zerosOf(const std::vector<Unknown>& unknowns) {
  return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns.size()));
}

/// Returns the typical size of each unknown (Unknown::typical).
[[nodiscard]] inline Eigen::VectorXd typicalsOf(const std::vector<Unknown>& unknowns) {
  Eigen::VectorXd typicals = zerosOf(unknowns);
  for (std::size_t k = 0; k < unknowns.size(); ++k) typicals[static_cast<Eigen::Index>(k)] = unknowns[k].typical;
  return typicals;
}

/// Prior standard deviations of the parameters about their values in the arm's file. The first four members apply to
/// geometric parameters, and takeSizePrior() to magnitudes of effects. All other parameters have a weak prior, which a
/// few measurements outweigh.
struct Priors {
  double length = 0.005;  ///< lengths of frames, and offsets of prismatic joints [m]
  double angle = 0.02;    ///< angles of frames, and offsets of revolute joints [rad]
  double tip = 0.05;      ///< coordinates of the tool's tip, which is mounted and measured by hand [m]
  double turn = 0.1;      ///< rotation of the tool frame, which is also mounted by hand [rad]
  double weak = 10;       ///< all other parameters, as a multiple of Unknown::typical
  /// Standard deviations of individual parameters, keyed by name, in internal units; for a stiffness, the standard
  /// deviation of its compliance. They replace the values above.
  std::map<std::string, double> named;
};

struct PlacedArm {
  deflection::Arm arm;
  std::vector<BasePose> base_poses;
  Priors priors = {};  ///< priors last given to chooseUnknowns(); they also apply to parameters freed later
  /// True if any measurement depends on the rotation of the tool frame. If false, the parameters of that rotation are
  /// not treated as geometry.
  bool shows_tool_turn = false;
};

/// Returns the index of the base pose of a measurement's set-up, which must be one of `placed.base_poses`.
[[nodiscard]] int basePoseOf(const PlacedArm& placed, const Measurement& measurement);

/// Returns the base pose X_WB at which a measurement was taken.
[[nodiscard]] const Eigen::Isometry3d& basePoseAt(const PlacedArm& placed, const Measurement& measurement);

/// Reason why a parameter name in a FreeChoice cannot be freed.
struct FreeProblem {
  std::string name;
  std::string what;         ///< the reason, as a sentence
  std::string advice;       ///< advice to the user
  bool is_unknown = false;  ///< true if the arm has no parameter of that name
};

struct FreeChoice {
  std::vector<std::string> names;  ///< names to free, each expanded by namesBehind()
  bool base = true;                ///< true if every unknown base pose is freed too
  Priors priors = {};
};

/// Unknowns that result from a FreeChoice: base poses first, then named parameters in the order of the names, then the
/// parameters of `geometry`. In `placed`, chooseUnknowns() gives each named rigid joint axis a finite stiffness. Every
/// variable is 0 at the start.
struct Unknowns {
  std::vector<FreeProblem> problems;
  std::vector<Unknown> list;
};
[[nodiscard]] Unknowns chooseUnknowns(PlacedArm& placed, const FreeChoice& choice);

/// Returns the parameter names to which `name` expands: those with the prefix `name` ("tool.tip", "forearm.origin.rpy",
/// "forearm.dh"); for "geometry", all geometric parameters, from which independentGeometry() selects those to free;
/// otherwise `name` itself.
[[nodiscard]] std::vector<std::string> namesBehind(const deflection::Arm& arm, const std::string& name);

/// Returns the names of everything that can be a free parameter of a fit: "geometry", the arm's parameters, and groups
/// of parameters.
[[nodiscard]] std::vector<std::string> freeableNames(const deflection::Arm& arm);

/// Returns a copy of `start` with the variables `x` applied to the unknowns.
[[nodiscard]] PlacedArm applied(const PlacedArm& start, const std::vector<Unknown>& unknowns, const Eigen::VectorXd& x);

/// Applies the variables `x` to `placed`, a copy of `start` that differs from `start` only in these unknowns.
void apply(const PlacedArm& start, const std::vector<Unknown>& unknowns, const Eigen::VectorXd& x, PlacedArm& placed);

/// Returns the unknown with its variable shifted such that the variable is 0 at the parameter value `value`. An unknown
/// of a base is returned unchanged.
[[nodiscard]] Unknown rebased(Unknown unknown, double value);

/// Return the parameter value that belongs to the variable `x`, and the derivative of this value with respect to `x`.
[[nodiscard]] double valueAt(const Unknown& unknown, double x);
[[nodiscard]] double slopeAt(const Unknown& unknown, double x);

/// Returns the variable that belongs to a parameter value: the inverse of valueAt().
[[nodiscard]] double variableAt(const Unknown& unknown, double value);

/// Returns the smallest and the largest parameter value while the variable goes from `lower` to `upper`. If the range
/// reaches the lower bound of a compliance, the largest stiffness is infinite.
[[nodiscard]] std::pair<double, double> valuesBetween(const Unknown& unknown, double lower, double upper);

}  // namespace tubeplan::calibration
