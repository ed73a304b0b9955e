// An arm whose joints and elements rotate about one axis each, as plain numbers: the input of the kernels.
//
// Every turn is a rotation about the z axis of its frame. A translation, a twist about x and the turn lead from the
// frame before to the turn's frame, as modified Denavit-Hartenberg parameters do. A joint, a spring and the far end of
// a beam that share an axis are merged into one turn. The turn's body is the rigid part between it and the next turn.
//
// Included by source files that are compiled for different processors, so nothing here may generate code.
#pragma once

namespace tubeplan::deflection::simd {

inline constexpr int kMaxTurns = 48;     ///< longer arms are solved without a kernel
inline constexpr int kMaxUnknowns = 48;  ///< largest number of compliant turns and beams, for derivatives
inline constexpr int kMaxJoints = 8;
inline constexpr int kGravityTurns = 3;  ///< number of rotations of gravity, about the base's axes

enum Twisted { kStraight, kQuarter, kOblique };

struct Turn {
  /// Translation from the frame before, in that frame's axes [m]; for a beam the undeflected vector, with p[2] = 0.
  double p[3];
  double cos_twist, sin_twist;  ///< twist about x, after the translation
  double cos_rest, sin_rest;    ///< constant rotation of a turn without a joint
  double offset;                ///< offset of the joint's reading [rad]
  double compliance;            ///< sum of the compliances about the turn's axis [rad/(N m)]
  double weight, moment[3];     ///< weight of the body [N], and first moment about the turn's origin [N m]
  double beam_compliance;       ///< bending compliance of the beam that leads to the turn [rad/(N m)]
  double beam_weight;           ///< weight along the beam [N]
  int joint;                    ///< index of the joint reading; -1 if none
  int twist;                    ///< a value of Twisted
  bool shifted[3], is_compliant, is_beam, has_moment;
};

struct RevoluteArm {
  const Turn* turns;
  int count, joints;
  double reach;               ///< length that scales tolerances [m]
  double tip_R[9], tip_p[3];  ///< pose of the tip in the last turn's frame; columns one after the other
  bool tip_turned;            ///< true if tip_R is not the identity
  bool is_compliant;          ///< true if at least one turn is compliant
};

/// Postures side by side: entry l of each array belongs to lane l; arrays of one kind are `stride` apart.
struct Postures {
  const double* q;        ///< readings, joint by joint [rad]
  const double* load;     ///< load at the tip [N]
  const double* gravity;  ///< direction of gravity in the base, x, y, z
  long stride;
  double tolerance;  ///< tolerance of the tip [m]
  int max_iterations;
};

/// Solved shapes of several postures, side by side. Arrays whose pointer is null are not filled.
struct Shapes {
  double* pose;      ///< 12 values: p_BD, then the columns of R_BD
  double* jacobian;  ///< 6 values for each joint: d p_BD, then the rotation vector, in base axes
  double* sweeps;    ///< number of sweeps; negative if the shape does not converge
  /// 4 values for each turn: moment about its axis [N m], deflection [rad], lambda and kappa of the beam that leads to
  /// it.
  double* element_states;
  long stride;                   ///< stride of all arrays except the derivatives
  long derivative_stride;        ///< stride of the jacobian, by_gravity and by_compliance
  double* by_gravity = nullptr;  ///< 6 values for each rotation of gravity about a base axis
  /// 6 values for all springs of each turn together [per rad/(N m)], then 6 for the beam that leads to the turn; only
  /// existing springs and beams are written.
  double* by_compliance = nullptr;
  double* turns = nullptr;  ///< 12 values for each turn: its frame in the base, laid out as `pose`
};

/// Solves as many postures at once as the kernel has lanes.
using SolveShapes = void (*)(const RevoluteArm&, const Postures&, const Shapes&);

/// Directions on a four-joint arm that Newton's method aligns with the directions of the goals.
struct Tool {
  double axis[3];       ///< tool axis in the tip's frame
  int hand;             ///< index of the turn that carries the last joint's axis
  double hand_axis[3];  ///< the last joint's axis in that turn's frame
};

/// Goals side by side, each with start readings.
struct Goals {
  double p_BT[3][8], axis_B[3][8], start[4][8], load[8], gravity_B[3][8];
  double tolerance;                            ///< tolerance of shapes, at the tip [m]
  double position_tolerance, pitch_tolerance;  ///< tolerances of the tip's position [m] and pitch [rad]
  int max_sweeps;                              ///< largest number of pairs of sweeps for one shape
  int max_steps;
  bool damped;  ///< true if steps are halved until they reduce the residual
};

/// Results of Newton's method, side by side.
struct Reached {
  double q[4][8];
  double done[8];  ///< 1: the goal is met; 2: damped steps ended before the goal was met; 0: abandoned
  double steps[8];
  double position_error[8];  ///< distance of the tip from the goal [m]
  double tilt_sine[8], tilt_cosine[8];
  double smallest_singular_value[8];  ///< smallest singular value of the Jacobian scaled by the reach
};

/// Applies Newton's method to as many goals at once as the kernel has lanes.
using MeetGoals = void (*)(const RevoluteArm&, const Tool&, const Goals&, Reached&);

}  // namespace tubeplan::deflection::simd
