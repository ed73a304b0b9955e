// A serial arm as data: rows of geometry, joints, stiffnesses and weights.
//
// Internal units of the whole program, stated here once: metre, newton, radian, second, kelvin. Files carry their own
// units; the readers convert. Weights are forces (N), not masses. A stiffness of infinity is a rigid axis.
//
// Frames: B is the arm's base, L1..Ln the rows' frames (L0 = B), T the tool frame at the tip, D the same frame
// deflected. Row i takes frame L(i-1) to Li. Its member (the link's body) runs from Li to L(i+1), the last one to the
// tip; the member of a prismatic row is its sliding bar, from the bearing (Li at zero slide) to Li, as long as the
// joint says.
#pragma once

#include <array>
#include <cassert>
#include <limits>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "deflection/conditions.hpp"
#include "deflection/effects/placed_effect.hpp"
#include "deflection/scalar.hpp"

namespace tubeplan::deflection {

inline constexpr double kRigid = std::numeric_limits<double>::infinity();

/// Modified (Craig) Denavit-Hartenberg numbers with Hayati's lean and a shift: RotX(alpha) TransX(a) TransY(b)
/// RotY(beta) RotZ(theta) TransZ(d). rad, m. Of an axis that is all but parallel to the one before it, beta is
/// determined and d is not. The first row needs b for its axis to be anywhere beside a base that is known; in others
/// the joint before and d do what b does.
template <class S>
struct DenavitHartenberg {
  S alpha{0}, a{0}, d{0}, theta{0}, beta{0}, b{0};
};

/// A row placed as URDF does: translation [m], then fixed-axis roll, pitch, yaw [rad], then the lean beta [rad] about
/// the row's own y, which a pitch of a right angle leaves without a number of its own.
template <class S>
struct Origin {
  Vector3<S> position = Vector3<S>::Zero();
  Vector3<S> rpy = Vector3<S>::Zero();
  S beta{0};
};

enum class JointType { kPassive, kRevolute, kPrismatic };

/// A joint that another one takes along, and how far: so many times that joint's angle, its offset included.
struct FollowedJoint {
  int row = -1;
  double ratio = 0;
};

/// Angles in rad (lengths in m for a prismatic joint). Limits, speed and acceleration are infinite where not stated.
template <class S>
struct Joint {
  std::string name;
  JointType type = JointType::kPassive;
  S offset{0};
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double max_speed = std::numeric_limits<double>::infinity();
  double max_acceleration = std::numeric_limits<double>::infinity();
  double encoder_sigma = 0;  ///< one standard deviation of a reading
  double gear_ratio = 0;     ///< turns of the drive's input for one of the joint; 0: not stated
  /// Of a joint without a reading of its own (a parallel linkage, a belt): a passive row turns about its z by their sum
  /// and its offset. All of them are revolute and active.
  std::vector<FollowedJoint> follows = {};
};

/// Whether a row turns about its z, by a reading of its own or with others.
template <class S>
bool turns(const Joint<S>& joint) {
  return joint.type == JointType::kRevolute || !joint.follows.empty();
}

/// Whether a row moves at all, by a reading of its own or with others.
template <class S>
bool moves(const Joint<S>& joint) {
  return joint.type != JointType::kPassive || !joint.follows.empty();
}

/// A uniform straight member. E, G [Pa]; I (about the row's x, y, z axis), J [m^4]. An I of infinity does not bend;
/// G J of infinity does not twist. `segments` splits it into equal elements.
template <class S>
struct Beam {
  S E{kRigid};
  Vector3<S> I = Vector3<S>::Constant(S(kRigid));
  S G{kRigid};
  S J{kRigid};
  int segments = 1;
};

template <class S>
struct Lump {
  S weight{0};                         ///< N
  Vector3<S> at = Vector3<S>::Zero();  ///< m, in the row's frame
};

/// Distributed along the member [N/m], at its end [N], or lumped anywhere in the row's frame.
template <class S>
struct Weight {
  S distributed{0};
  S end{0};
  std::vector<Lump<S>> lumps;
};

/// What effects add to a row while a shape is solved; no file has such numbers. What is there at all
/// (`joint_is_compliant`, `member_is_compliant`, `bends`, `has_gap`) is structure: it is the same whatever the values
/// are, zero included.
template <class S>
struct EffectTerms {
  bool joint_is_compliant = false, member_is_compliant = false;
  std::array<bool, 3> bends{}, has_gap{};
  Vector3<S> compliance = Vector3<S>::Zero();          ///< rad/(N m), at the origin, about the row's axes
  Vector3<S> softness = Vector3<S>::Zero();            ///< see elements/joint_stiffness.hpp ...
  Vector3<S> knee = Vector3<S>::Zero();                ///< ... up to this moment [N m]
  Vector3<S> gap = Vector3<S>::Zero();                 ///< clearance [rad], see elements/clearance.hpp
  Vector3<S> bending_compliance = Vector3<S>::Zero();  ///< 1/(N m^2), of the member, about the row's axes
  S torsion_compliance{0};                             ///< 1/(N m^2), of the member
  Vector3<S> pull = Vector3<S>::Zero();                ///< N, at the member's end, in base axes
  std::vector<Lump<S>> hung;                           ///< at the row's origin, whatever its member does
};

template <class S>
struct Row {
  std::string name;
  std::variant<DenavitHartenberg<S>, Origin<S>> placement;
  Joint<S> joint;
  Vector3<S> joint_stiffness = Vector3<S>::Constant(S(kRigid));  ///< N m/rad about the row's axes, acting at its origin
  std::optional<Beam<S>> beam;
  Weight<S> weight;
  std::optional<EffectTerms<S>> effect_terms;
  /// The row that has this one's alpha, a and beta in its file and in fits, where that is another: by the standard
  /// convention the one before. Empty: none has, and they are no parameters.
  std::optional<std::string> placed_by;
  bool is_written =
      true;  ///< whether the file has a row of that name: not of the end of a last link by that convention
};

/// Rows that hang from a row without leading to the tip: see side_chains.hpp. The first is placed in that row's axes.
/// They are rigid.
template <class S>
struct SideChain {
  int row = -1;
  std::vector<Row<S>> rows;
};

/// What effects do to the loads at the tip while a shape is solved; no file has such numbers.
template <class S>
struct TipLoad {
  Vector3<S> payload_offset = Vector3<S>::Zero();  ///< where the hung load acts [m], in the deflected tool frame
  S contact_force{0};                              ///< at the tip, against gravity [N]
  Vector3<S> force = Vector3<S>::Zero();           ///< N, at the tip, in base axes
  Vector3<S> moment = Vector3<S>::Zero();          ///< N m, of a direction that never changes, in base axes
};

/// Rows that are rigid in one set-up of the base: an arm that is taken off its flexible mounting and bolted to a bench.
struct RigidMounting {
  std::string setup;
  std::vector<int> rows;
};

template <class S>
struct ArmOf {
  std::string name;
  Vector3<S> gravity_W = -Vector3<S>::UnitZ();  ///< direction, unit length, in the world frame
  std::vector<Row<S>> rows;
  Vector3<S> p_LT = Vector3<S>::Zero();          ///< the tip in the last row's frame
  Vector3<S> tool_axis_L = Vector3<S>::UnitZ();  ///< the direction the tool enters a hole, in the last row's frame
  Eigen::Matrix3d R_LT = Eigen::Matrix3d::Identity();  ///< the tool frame's axes there as drawn: see toolFrame()
  Vector3<S> tool_turn_L = Vector3<S>::Zero();         ///< rotation vector from those to the true ones [rad], there too
  ConditionValues reference = usualConditions();       ///< under which it is as drawn, and taken where none are stated
  std::vector<EffectOf<S>> effects;                    ///< what the arm does beyond the model above
  std::vector<SideChain<S>> side_chains;               ///< what only weighs
  std::vector<RigidMounting> mountings;                ///< one for each set-up that has rigid rows
  std::optional<TipLoad<S>> tip_load;

  /// The joints with readings of their own, revolute and prismatic, in order: the order of every joint vector.
  [[nodiscard]] auto joints() const {
    return rows | std::views::filter([](const Row<S>& row) { return row.joint.type != JointType::kPassive; }) |
           std::views::transform(&Row<S>::joint);
  }
  [[nodiscard]] Eigen::Index jointCount() const { return std::ranges::distance(joints()); }
  /// The k-th of them; one past the last is our own bug.
  [[nodiscard]] const Joint<S>& joint(Eigen::Index k) const {
    for (const Joint<S>& joint : joints())
      if (k-- == 0) return joint;
    assert(false);
    return rows.front().joint;
  }
};

using Arm = ArmOf<double>;

/// The tool frame's axes in the last row's, in which readings state turns: as drawn, then turned. The tool's own axis
/// does not follow it.
Eigen::Matrix3d toolFrame(const Arm& arm);

/// Indices of the rows of `joints()`.
std::vector<int> activeRows(const Arm& arm);

/// The rows that turn when an active row's joint does, and how far: itself, and those that follow it.
std::vector<FollowedJoint> turnedWith(const Arm& arm, int active_row);

/// Whether a row's axis is parallel to that of the row before, or opposed to it, within 30 degrees.
bool isNearlyParallel(const Row<double>& row);

/// The names of its joints and of its rows, in order, and the row of a name.
std::vector<std::string> jointNames(const Arm& arm);
std::vector<std::string> rowNames(const Arm& arm);
std::optional<int> findRow(const Arm& arm, std::string_view name);

/// Whether any row's joint follows others.
bool hasFollowers(const Arm& arm);

/// Whether the solver is given other numbers from posture to posture: by effects, by what side chains weigh, or by rows
/// that are rigid in a set-up.
template <class S>
bool dependsOnPosture(const ArmOf<S>& arm) {
  return !arm.effects.empty() || !arm.mountings.empty() || !arm.side_chains.empty();
}

/// The same arm without any flexibility, that of its effects included.
Arm rigidCopy(const Arm& arm);

/// From a row's origin, or the end of its slide, to the next row's origin or the tip: in its axes [m], undeflected.
Eigen::Vector3d memberOf(const Arm& arm, int row);

/// What of a row bends: its member; of a prismatic row the direction of its bar, a unit vector.
Eigen::Vector3d undeflectedMember(const Arm& arm, int row);

/// The greatest length of a slide [m], infinite without limits; 0 of any other joint.
double slideLength(const Joint<double>& joint);

/// No less than the largest distance that the tip can have from the base [m]: the shortest way along the joints' axes,
/// slides at their longest, however the rows are written. The yardstick of tolerances, so slides without limits count
/// as nothing.
double reachOf(const Arm& arm);

/// What makes an arm unusable. `path` is the dotted name in the arm file (`tool.joint_stiffness.z`).
struct ArmProblem {
  std::string path;
  std::string found;
  std::string expected;
};

/// Every problem of an arm, in file order: no rows, double names, a negative or zero stiffness, a flexible beam of no
/// length, limits the wrong way round, numbers that are not finite, effects where they cannot be. Empty means usable.
std::vector<ArmProblem> findProblems(const Arm& arm);

}  // namespace tubeplan::deflection
