// The arm where it stands, and the numbers of both that a fit may change.
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

/// One base pose: every set-up of a session has its own.
struct BasePose {
  std::string setup;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  bool is_known = false;
};

/// One number that a fit may change: of the arm, or one of the six of a placing (a shift [m] along, then a turn [rad]
/// about, the world's axes, from where the placing started). Stiffnesses change by their compliance, to which readings
/// are all but linear up to the rigid axis itself; its bound keeps them positive.
struct Unknown {
  enum class Owner { kArm, kBase };
  std::string name;  ///< "tool.joint_stiffness.z", "base.shift.x", "base.turn.z@SETUP"
  deflection::Quantity quantity = deflection::Quantity::kNone;
  Owner owner = Owner::kArm;
  deflection::ParameterPath path;
  int base_pose = -1, component = -1;
  enum class Scale { kLinear, kCompliance };
  Scale scale = Scale::kLinear;
  bool is_geometry = false;     ///< freed by `geometry`
  double typical = 1;           ///< how far the variable may well be from its start: the unit that solvers work in
  double prior_sigma = 10;      ///< standard deviation of the variable's normal prior; infinite: none
  double prior_mean = 0;        ///< the variable's value by the drawing (0 but where the unknown was rebased); of an
                                ///< effect's size that of none
  double start = 0;             ///< of the parameter
  double lower = 0, upper = 0;  ///< of the variable x (0 at the start)
};

/// The prior of an effect's size, whose typical size is the largest that real machines have: none, give or take that.
void takeSizePrior(const deflection::EffectParameter& parameter, Unknown& unknown);

/// The variables at their start.
[[nodiscard]] inline Eigen::VectorXd zerosOf(const std::vector<Unknown>& unknowns) {
  return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns.size()));
}

/// What is known of the numbers beforehand, as standard deviations about the values of the arm's file: a drawing is
/// knowledge. Lengths and angles of frames, joint offsets, the tip and the tool's turn have a prior of their own; sizes
/// of effects are none, give or take the largest that real machines have; all others have a weak prior, a multiple of
/// what a number may well be off by (Unknown::typical), which data soon outweigh.
struct Priors {
  double length = 0.005;                ///< m
  double angle = 0.02;                  ///< rad
  double tip = 0.05;                    ///< m, of the tool's tip, which is mounted and measured by hand
  double turn = 0.1;                    ///< rad, of the tool's frame, which is mounted by hand too
  double weak = 10;                     ///< of the typical size of all others
  std::map<std::string, double> named;  ///< of single numbers, in internal units; stiffnesses by their compliance
};

struct PlacedArm {
  deflection::Arm arm;
  std::vector<BasePose> base_poses;
  Priors priors = {};            ///< of the choice of numbers that was made last: those freed beside them have the same
  bool shows_tool_turn = false;  ///< whether the tool's turn reaches a reading: without, its numbers are no geometry
};

/// Index of the placing a reading was made at; the set-up must be one of them.
[[nodiscard]] int basePoseOf(const PlacedArm& placed, const Measurement& reading);

/// Why the names cannot be freed; empty where they can.
struct FreeProblem {
  std::string name, found, expected;
};

struct FreeChoice {
  std::vector<std::string> names;  ///< as namesBehind() has them
  bool base = true;                ///< also every base pose that is not known
  Priors priors = {};
};

/// The unknowns of a choice: base poses first, then names in their order, `geometry` last. Axes that are rigid and
/// named become finite in `placed`. Every variable is 0 at the start.
struct Unknowns {
  std::vector<FreeProblem> problems;
  std::vector<Unknown> list;
};
[[nodiscard]] Unknowns chooseUnknowns(PlacedArm& placed, const FreeChoice& choice);

/// The dotted names that `name` stands for: itself, all below it ("tool.tip", "forearm.origin.rpy", "forearm.dh"), or
/// every number that says where things are ("geometry", of which independentGeometry() are freed).
[[nodiscard]] std::vector<std::string> namesBehind(const deflection::Arm& arm, const std::string& name);

/// Every name that may be freed: "geometry", the arm's numbers, and what they stand below.
[[nodiscard]] std::vector<std::string> freeableNames(const deflection::Arm& arm);

/// The placed arm with these variables applied to its start.
[[nodiscard]] PlacedArm applied(const PlacedArm& start, const std::vector<Unknown>& unknowns, const Eigen::VectorXd& x);

/// The same into a copy of the start that had these unknowns applied before.
void apply(const PlacedArm& start, const std::vector<Unknown>& unknowns, const Eigen::VectorXd& x, PlacedArm& placed);

/// The same unknown with its variable 0 where the parameter has this value (a base component: where it stands now).
[[nodiscard]] Unknown rebased(Unknown unknown, double value);

/// The value of a parameter for its variable, and the slope between them.
[[nodiscard]] double valueAt(const Unknown& unknown, double x);
[[nodiscard]] double slopeAt(const Unknown& unknown, double x);

/// The other way round of valueAt().
[[nodiscard]] double variableAt(const Unknown& unknown, double value);

/// The values, least first, between two variables: a stiffness whose compliance may be none has no upper end.
[[nodiscard]] std::pair<double, double> valuesBetween(const Unknown& unknown, double lower, double upper);

}  // namespace tubeplan::calibration
