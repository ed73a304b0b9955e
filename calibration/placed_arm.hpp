// The arm on its base, and the numbers of both that a fit may change.
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

/// A small change of the base pose: translation of its origin [m], then a rotation vector [rad], both in world axes;
/// X_WB becomes (exp(rotation) R, p + translation). The order of every 6 x 6 covariance of a base.
using BaseStep = Eigen::Matrix<double, 6, 1>;
[[nodiscard]] Eigen::Isometry3d moved(const Eigen::Isometry3d& X_WB, const BaseStep& step);

/// Returns "base.shift.x", ..., "base.turn.z": the names of a base step's components.
[[nodiscard]] const std::array<std::string, 6>& baseStepNames();

/// A base pose: every set-up of a session has its own.
struct BasePose {
  std::string setup;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  bool is_known = false;
};

/// A number that a fit may change: of the arm, or one of the six of a base pose (a shift [m] along, then a rotation
/// [rad] about, the world's axes, from the start). Stiffnesses vary by their compliance, in which readings are nearly
/// linear up to the rigid axis itself; its bound keeps them positive.
struct Unknown {
  enum class Owner { kArm, kBase };
  std::string name;  ///< "tool.joint_stiffness.z", "base.shift.x", "base.turn.z@SETUP"
  deflection::Quantity quantity = deflection::Quantity::kNone;
  Owner owner = Owner::kArm;
  deflection::ParameterPath path;
  int base_pose = -1, component = -1;
  enum class Scale { kLinear, kCompliance };
  Scale scale = Scale::kLinear;
  bool is_geometry = false;  ///< true: freed by `geometry`
  double typical = 1;        ///< likely distance of the variable from its start: the unit of the solvers
  double prior_sigma = 10;   ///< standard deviation of the variable's normal prior; infinite: none
  /// The variable's value in the file (0 unless the unknown was rebased); for an effect's size, its neutral value.
  double prior_mean = 0;
  double start = 0;             ///< start value of the parameter
  double lower = 0, upper = 0;  ///< bounds of the variable x (0 at the start)
};

/// Sets the prior of an effect's size: neutral, with the largest size on real machines as its standard deviation.
void takeSizePrior(const deflection::EffectParameter& parameter, Unknown& unknown);

/// Returns the variables at their start.
[[nodiscard]] inline Eigen::VectorXd zerosOf(const std::vector<Unknown>& unknowns) {
  return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns.size()));
}

/// Returns what the variables may well be off by: Unknown::typical.
[[nodiscard]] inline Eigen::VectorXd typicalsOf(const std::vector<Unknown>& unknowns) {
  Eigen::VectorXd typicals = zerosOf(unknowns);
  for (std::size_t k = 0; k < unknowns.size(); ++k) typicals[static_cast<Eigen::Index>(k)] = unknowns[k].typical;
  return typicals;
}

/// Prior standard deviations of the numbers about the values of the arm's file. Lengths and angles of frames, joint
/// offsets, the tip and the tool's rotation each have one. An effect's size has the prior mean zero and the largest
/// size of real machines as standard deviation. All others have a weak prior, a multiple of the usual error
/// (Unknown::typical), which data soon outweigh.
struct Priors {
  double length = 0.005;  ///< [m]
  double angle = 0.02;    ///< [rad]
  double tip = 0.05;      ///< of the tool's tip, which is mounted and measured by hand [m]
  double turn = 0.1;      ///< of the tool's frame, which is mounted by hand too [rad]
  double weak = 10;       ///< for all others, as a multiple of the typical size
  /// Priors of single numbers, in internal units; for stiffnesses of their compliance.
  std::map<std::string, double> named;
};

struct PlacedArm {
  deflection::Arm arm;
  std::vector<BasePose> base_poses;
  Priors priors = {};  ///< priors of the last choice of numbers, which also hold for numbers freed with them
  /// True: a reading depends on the tool's rotation; otherwise its numbers are no geometry.
  bool shows_tool_turn = false;
};

/// Returns the index of the base pose of a reading, whose set-up must be one of them.
[[nodiscard]] int basePoseOf(const PlacedArm& placed, const Measurement& reading);

/// Returns the pose X_WB of the base that a reading was made from.
[[nodiscard]] const Eigen::Isometry3d& basePoseAt(const PlacedArm& placed, const Measurement& reading);

/// Reason why a name cannot be freed.
struct FreeProblem {
  std::string name;
  std::string what;         ///< sentence of the reason
  std::string advice;       ///< what to do
  bool is_unknown = false;  ///< true: the arm has no such number
};

struct FreeChoice {
  std::vector<std::string> names;  ///< names with the meaning of namesBehind()
  bool base = true;                ///< true: also every unknown base pose
  Priors priors = {};
};

/// The unknowns of a choice: base poses first, then names in their order, `geometry` last. Named rigid axes become
/// finite in `placed`. Every variable is 0 at the start.
struct Unknowns {
  std::vector<FreeProblem> problems;
  std::vector<Unknown> list;
};
[[nodiscard]] Unknowns chooseUnknowns(PlacedArm& placed, const FreeChoice& choice);

/// Returns the dotted names that `name` means: itself, all below it ("tool.tip", "forearm.origin.rpy", "forearm.dh"),
/// or every geometric number ("geometry", of which independentGeometry() are freed).
[[nodiscard]] std::vector<std::string> namesBehind(const deflection::Arm& arm, const std::string& name);

/// Returns every name that may be freed: "geometry", the arm's numbers, and the names above them.
[[nodiscard]] std::vector<std::string> freeableNames(const deflection::Arm& arm);

/// Returns the placed arm with these variables applied to its start.
[[nodiscard]] PlacedArm applied(const PlacedArm& start, const std::vector<Unknown>& unknowns, const Eigen::VectorXd& x);

/// Applies the variables to a copy of the start that had these unknowns applied before.
void apply(const PlacedArm& start, const std::vector<Unknown>& unknowns, const Eigen::VectorXd& x, PlacedArm& placed);

/// Returns the unknown with its variable 0 at this value of the parameter (for a base component, at its present place).
[[nodiscard]] Unknown rebased(Unknown unknown, double value);

/// Return the value of a parameter for its variable, and the slope between them.
[[nodiscard]] double valueAt(const Unknown& unknown, double x);
[[nodiscard]] double slopeAt(const Unknown& unknown, double x);

/// Returns the variable for a value, the inverse of valueAt().
[[nodiscard]] double variableAt(const Unknown& unknown, double value);

/// Returns the range of values, smallest first, between two variables: a stiffness whose compliance may be zero has no
/// upper limit.
[[nodiscard]] std::pair<double, double> valuesBetween(const Unknown& unknown, double lower, double upper);

}  // namespace tubeplan::calibration
