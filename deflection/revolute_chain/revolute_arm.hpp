// An arm all of whose joints and elements turn about one axis each, as plain numbers: the input of the kernels.
//
// Every turn is about the z axis of its frame. From the frame before, a translation, a twist about x and the turn lead
// to it, as modified Denavit-Hartenberg numbers do. Joint, spring and the far end of a beam that share an axis are one
// turn. The rigid part beyond a turn, up to the next one, is its body.
//
// Included by sources that are compiled for different processors: nothing here may have code of its own.
#pragma once

namespace tubeplan::deflection::simd {

inline constexpr int kMaxTurns = 48;     ///< longer arms are solved without a kernel
inline constexpr int kMaxUnknowns = 48;  ///< compliant turns and beams, for derivatives
inline constexpr int kMaxJoints = 8;
inline constexpr int kGravityTurns = 3;  ///< rotations of gravity about the base's axes

enum Twisted { kStraight, kQuarter, kAskew };

struct Turn {
  double p[3];  ///< translation from the frame before, in its axes [m]; for a beam undeflected, with p[2] = 0
  double cos_twist, sin_twist;  ///< twist about x, after the translation
  double cos_rest, sin_rest;    ///< constant rotation of a turn without a joint
  double offset;                ///< offset of the joint's reading [rad]
  double compliance;            ///< sum of the compliances about this axis [rad/(N m)]
  double weight, moment[3];     ///< weight of the body [N], and its first moment about the origin [N m]
  double beam_compliance;       ///< bending compliance about this axis of the beam that leads here [rad/(N m)]
  double beam_weight;           ///< weight along the beam [N]
  int joint;                    ///< index of the reading, or -1
  int twist;                    ///< a value of Twisted
  bool shifted[3], is_compliant, is_beam, has_moment;
};

struct RevoluteArm {
  const Turn* turns;
  int count, joints;
  double reach;               ///< scale of tolerances [m]
  double tip_R[9], tip_p[3];  ///< tip's frame in the last turn's; columns one after the other
  bool tip_turned;            ///< true: tip_R is not the identity
  bool is_compliant;          ///< true: any of the turns is compliant
};

/// Postures side by side: entry l of each array belongs to lane l, arrays of the same kind are `stride` apart.
struct Postures {
  const double* q;        ///< readings, joint by joint [rad]
  const double* load;     ///< load at the tip [N]
  const double* gravity;  ///< direction of gravity in the base, x, y, z
  long stride;
  double tolerance;  ///< tolerance of the tip [m]
  int max_iterations;
};

/// Shapes side by side. Null pointers are not filled.
struct Shapes {
  double* pose;      ///< 12: p_BD, then the columns of R_BD
  double* jacobian;  ///< 6 for each joint: d p_BD, then the rotation vector, base axes
  double* sweeps;    ///< number of sweeps; negative if the shape does not converge
  /// 4 for each turn: moment about its axis [N m]; deflection [rad]; lambda and kappa of its beam.
  double* element_states;
  long stride;                   ///< stride of all but the derivatives
  long derivative_stride;        ///< stride of the jacobian, by_gravity and by_compliance
  double* by_gravity = nullptr;  ///< 6 for each rotation of gravity's direction about an axis of the base
  /// 6 for the springs of each turn together [per rad/(N m)], then 6 for the beam that leads to it; only existing ones
  /// are written.
  double* by_compliance = nullptr;
  double* turns = nullptr;  ///< 12 for each turn: its frame in the base, laid out as `pose`
};

/// Solves as many postures as the kernel has lanes.
using SolveShapes = void (*)(const RevoluteArm&, const Postures&, const Shapes&);

/// The directions on an arm of four joints that are compared with goals.
struct Tool {
  double axis[3];       ///< tool axis in the tip's frame
  int hand;             ///< turn that carries the last joint's axis
  double hand_axis[3];  ///< the last joint's axis in that turn's frame
};

/// Goals side by side, each with start readings.
struct Goals {
  double p_BT[3][8], axis_B[3][8], start[4][8], load[8], gravity_B[3][8];
  double tolerance;                            ///< tolerance of shapes, at the tip [m]
  double position_tolerance, pitch_tolerance;  ///< [m], [rad]
  int max_sweeps;                              ///< largest number of pairs of sweeps in one shape
  int max_steps;
  bool damped;  ///< true: steps are halved until they reduce the residual
};

/// Results of the iteration.
struct Reached {
  double q[4][8];
  double done[8];  ///< 1 if the goal is met, 2 if damped steps end before, 0 if abandoned
  double steps[8];
  double position_error[8];  ///< [m]
  double tilt_sine[8], tilt_cosine[8];
  double smallest_singular_value[8];  ///< least singular value of the Jacobian scaled by the reach
};

/// Applies Newton's method to as many goals as the kernel has lanes.
using MeetGoals = void (*)(const RevoluteArm&, const Tool&, const Goals&, Reached&);

}  // namespace tubeplan::deflection::simd
