// A serial arm as data: rows of geometry, joints, stiffnesses and weights.
//
// Internal units of the whole program, stated here once: metre, newton, radian, second, kelvin. Files state their own
// units, and the file readers convert them. Weights are forces (N), not masses. An infinite stiffness means a rigid
// axis.
//
// Frames: B is the arm's base, L1..Ln are the rows' frames (L0 = B), T is the tool frame at the tip, D the deflected
// tool frame. Row i leads from frame L(i-1) to Li. Its member (the link's body) runs from Li to L(i+1), or to the tip
// in the last row. The member of a prismatic row is its sliding bar, from the bearing (Li at zero joint value) to Li,
// with the joint's value as its length.
#pragma once

#include <array>
#include <cassert>
#include <limits>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "deflection/conditions.hpp"
#include "deflection/effects/placed_effect.hpp"
#include "deflection/scalar.hpp"

namespace tubeplan::deflection {

inline constexpr double kRigid = std::numeric_limits<double>::infinity();

/// Modified (Craig) Denavit-Hartenberg parameters [rad, m] with Hayati's beta and a shift b: RotX(alpha) TransX(a)
/// TransY(b) RotY(beta) RotZ(theta) TransZ(d). If an axis is nearly parallel to the previous row's axis, measurements
/// determine beta but not d. Only the first row needs b, to place its axis relative to a known base. In other rows, b
/// is redundant with the joint offset and d of the previous row.
template <class S>
struct DenavitHartenberg {
  S alpha{0}, a{0}, d{0}, theta{0}, beta{0}, b{0};
};

/// Placement of a row as in URDF: translation [m], then fixed-axis roll, pitch and yaw [rad], then a rotation beta
/// [rad] about the row's y axis. The separate beta keeps that rotation expressible at a pitch of 90 degrees, where roll
/// and yaw are degenerate.
template <class S>
struct Origin {
  Vector3<S> position = Vector3<S>::Zero();
  Vector3<S> rpy = Vector3<S>::Zero();
  S beta{0};
};

enum class JointType { kPassive, kRevolute, kPrismatic };

/// A joint that drives another joint, and the transmission ratio: rotation of the driven joint (without its own offset)
/// per rotation of the driving joint (including its offset).
struct FollowedJoint {
  int row = -1;
  double ratio = 0;
};

/// Joint of a row. Angles in rad (lengths in m if prismatic). Limits, speed and acceleration are infinite if not
/// stated.
template <class S>
struct Joint {
  std::string name;
  JointType type = JointType::kPassive;
  S offset{0};
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double max_speed = std::numeric_limits<double>::infinity();
  double max_acceleration = std::numeric_limits<double>::infinity();
  double encoder_sigma = 0;  ///< standard deviation of an encoder reading [rad, m]
  /// Gear ratio: input turns of the drive per turn of the joint; 0 means that it was not stated.
  double gear_ratio = 0;
  /// Joints that drive this joint, for example through a parallel linkage or a belt. A driven joint has no reading of
  /// its own: its passive row rotates about z by its offset plus the sum of ratio times angle over all drivers. Drivers
  /// are revolute and active.
  std::vector<FollowedJoint> follows = {};
};

/// Returns true if a row rotates about its z axis, driven by its own reading or by other joints.
template <class S>
bool turns(const Joint<S>& joint) {
  return joint.type == JointType::kRevolute || !joint.follows.empty();
}

/// Returns true if a row moves, driven by its own reading or by other joints.
template <class S>
bool moves(const Joint<S>& joint) {
  return joint.type != JointType::kPassive || !joint.follows.empty();
}

/// A uniform straight member. E and G in Pa; I (about the row's x, y and z axes) and J in m^4. The member is rigid in
/// bending about an axis with infinite I, and rigid in torsion if G J is infinite. The member is divided into
/// `segments` equal elements.
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
  S weight{0};                         ///< [N]
  Vector3<S> at = Vector3<S>::Zero();  ///< position in the row's frame [m]
};

/// Weight of a row: distributed along the member [N/m], concentrated at the member's end [N], and as lumps anywhere in
/// the row's frame.
template <class S>
struct Weight {
  S distributed{0};
  S end{0};
  std::vector<Lump<S>> lumps;
};

/// Terms that effects add to a row while the deflected shape is solved; arm files contain none of them. The flags
/// (`joint_is_compliant`, `member_is_compliant`, `bends`, `has_gap`) depend on which effects act on the row, not on the
/// values of their terms, which may be zero.
template <class S>
struct EffectTerms {
  bool joint_is_compliant = false, member_is_compliant = false;
  std::array<bool, 3> bends{}, has_gap{};
  Vector3<S> compliance = Vector3<S>::Zero();  ///< compliance at the origin, about the row's axes [rad/(N m)]
  /// Additional softness below the knee moment [1]; see elements/joint_stiffness.hpp.
  Vector3<S> softness = Vector3<S>::Zero();
  Vector3<S> soft_compliance = Vector3<S>::Zero();  ///< additional compliance below the knee moment [rad/(N m)]
  Vector3<S> knee = Vector3<S>::Zero();             ///< knee moment [N m]
  Vector3<S> gap = Vector3<S>::Zero();              ///< clearance [rad], see elements/clearance.hpp
  /// Bending compliance of the member about the row's axes [1/(N m^2)].
  Vector3<S> bending_compliance = Vector3<S>::Zero();
  S torsion_compliance{0};  ///< torsion compliance of the member [1/(N m^2)]
  /// Force at the member's end, such as the pull of a hose, in base axes [N].
  Vector3<S> end_force = Vector3<S>::Zero();
  std::vector<Lump<S>> attached_weights;  ///< weights that move with the row's origin, even if the member bends
};

template <class S>
struct Row {
  std::string name;
  std::variant<DenavitHartenberg<S>, Origin<S>> placement;
  Joint<S> joint;
  /// Torsional stiffness about the row's axes, at the row's origin [N m/rad].
  Vector3<S> joint_stiffness = Vector3<S>::Constant(S(kRigid));
  std::optional<Beam<S>> beam;
  Weight<S> weight;
  std::optional<EffectTerms<S>> effect_terms;
  /// Name of the arm-file entry that holds this row's alpha, a, beta and b; unset if that is the row's own `dh`. Fits
  /// use the same name. In the standard convention, the entry is "NAME.dh" of the previous row, or "NAME.axis" for the
  /// first row. An empty string means that no entry holds them, so they are not parameters.
  std::optional<std::string> placed_by;
  /// False for a row that the arm file does not contain: the end row added after the last link in the standard
  /// convention.
  bool is_written = true;
};

/// Rigid rows that branch off a row of the arm and do not lead to the tip: see side_chains.hpp. The first of them is
/// placed in the axes of the row that carries the chain.
template <class S>
struct SideChain {
  int row = -1;
  std::vector<Row<S>> rows;
};

/// Loads that effects add at the tip while the deflected shape is solved; arm files contain none of them.
template <class S>
struct TipLoad {
  /// Point of action of the hung load relative to the deflected tip, in the last row's axes [m].
  Vector3<S> payload_offset = Vector3<S>::Zero();
  S contact_force{0};                      ///< force at the tip against gravity [N]
  Vector3<S> force = Vector3<S>::Zero();   ///< force at the tip in base axes [N]
  Vector3<S> moment = Vector3<S>::Zero();  ///< moment of constant direction in base axes [N m]
};

/// Rows that are rigid in one set-up of the base, for example because the arm is bolted to a bench instead of its
/// flexible mounting.
struct RigidMounting {
  std::string setup;
  std::vector<int> rows;
};

template <class S>
struct ArmOf {
  std::string name;
  Vector3<S> gravity_W = -Vector3<S>::UnitZ();  ///< direction of gravity in the world frame, unit length
  std::vector<Row<S>> rows;
  Vector3<S> p_LT = Vector3<S>::Zero();          ///< tip in the last row's frame [m]
  Vector3<S> tool_axis_L = Vector3<S>::UnitZ();  ///< direction in which the tool enters a hole, in the last row's frame
  /// Nominal axes of the tool frame, in the last row's frame: see toolFrame().
  Eigen::Matrix3d R_LT = Eigen::Matrix3d::Identity();
  /// Rotation vector from the nominal to the true axes of the tool frame, in the last row's frame [rad].
  Vector3<S> tool_turn_L = Vector3<S>::Zero();
  /// Conditions at which the nominal parameters apply. They are also assumed if a posture does not state its
  /// conditions.
  ConditionValues reference = usualConditions();
  std::vector<EffectOf<S>> effects;       ///< physical effects beyond the data of rows, tip and tool
  std::vector<SideChain<S>> side_chains;  ///< rigid rows that only add weight
  std::vector<RigidMounting> mountings;   ///< one entry for each set-up with rigid rows
  std::optional<TipLoad<S>> tip_load;

  /// Returns the joints that have encoder readings, revolute and prismatic, in the order of joint vectors.
  [[nodiscard]] auto joints() const {
    return rows | std::views::filter([](const Row<S>& row) { return row.joint.type != JointType::kPassive; }) |
           std::views::transform(&Row<S>::joint);
  }
  [[nodiscard]] Eigen::Index jointCount() const { return std::ranges::distance(joints()); }
  /// Returns the k-th joint of joints(); `k` must be in range.
  [[nodiscard]] const Joint<S>& joint(Eigen::Index k) const {
    for (const Joint<S>& joint : joints())
      if (k-- == 0) return joint;
    assert(false);
    return rows.front().joint;
  }
};

using Arm = ArmOf<double>;

/// Returns the axes of the tool frame in the last row's frame, in which measured rotations are stated: the nominal
/// axes, rotated by `tool_turn_L`. The direction `tool_axis_L` is not affected.
Eigen::Matrix3d toolFrame(const Arm& arm);

/// Returns the row index of each joint of joints().
std::vector<int> activeRows(const Arm& arm);

/// Returns the rows that rotate with an active row's joint, and their ratios: the row itself and the rows that follow
/// it.
std::vector<FollowedJoint> turnedWith(const Arm& arm, int active_row);

/// Returns true if a row's axis is within 30 degrees of parallel or antiparallel to the previous row's axis.
bool isNearlyParallel(const Row<double>& row);

/// Return the names of all joints, the names of all rows, and the index of the row `name` (nothing if there is none).
std::vector<std::string> jointNames(const Arm& arm);
std::vector<std::string> rowNames(const Arm& arm);
std::optional<int> findRow(const Arm& arm, std::string_view name);

/// Returns true if any joint of the arm follows other joints.
bool hasFollowers(const Arm& arm);

/// Returns true if the parameters used by the solver depend on the posture, because of effects, side chains or set-ups
/// with rigid rows.
template <class S>
bool dependsOnPosture(const ArmOf<S>& arm) {
  return !arm.effects.empty() || !arm.mountings.empty() || !arm.side_chains.empty();
}

/// Returns true if a row has a beam or a finite joint stiffness.
bool isCompliant(const Row<double>& row);

/// Returns a rigid copy of the arm, without the effects that add flexibility.
Arm rigidCopy(const Arm& arm);

/// Returns the undeflected vector from a row's origin to the next row's origin or the tip, in the row's axes [m]. For a
/// prismatic row, the vector starts at the end of the bar.
Eigen::Vector3d memberOf(const Arm& arm, int row);

/// Returns the undeflected vector along the part of a row that can bend: its member [m] or, for a prismatic row, the
/// unit vector along its bar.
Eigen::Vector3d undeflectedMember(const Arm& arm, int row);

/// Returns the largest length of a prismatic joint's bar within the limits [m]: infinite without limits, 0 if the joint
/// is not prismatic.
double slideLength(const Joint<double>& joint);

/// Returns an upper bound on the distance of the tip from the base [m], used to scale tolerances: the length of the
/// shortest path from base to tip that touches every rotation axis in order, plus the largest length of each prismatic
/// joint (zero without limits). The bound does not depend on the convention in which the rows are written.
double reachOf(const Arm& arm);

/// Returns the limits of one of the arm's joints [rad or m]. A missing limit is replaced by half a turn from zero or,
/// for a prismatic joint, by the arm's reach.
std::pair<double, double> rangeOf(const Arm& arm, const Joint<double>& joint);

/// A problem with an arm. `path` is the dotted name of the entry in the arm file (`tool.joint_stiffness.z`).
struct ArmProblem {
  std::string path;
  std::string found;          ///< value found, or a sentence that states the problem if no value is expected
  std::string expected = {};  ///< value expected; empty unless a value is wrong
};

/// Returns every problem of an arm, in file order: no rows, repeated names, a negative or zero stiffness, a flexible
/// beam of zero length, reversed limits, numbers that are not finite, effects at impossible places. If the result is
/// empty, the arm is usable.
std::vector<ArmProblem> findProblems(const Arm& arm);

}  // namespace tubeplan::deflection
