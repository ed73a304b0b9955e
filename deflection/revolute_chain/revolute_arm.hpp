// An arm all of whose joints and elements turn about one axis each, as plain numbers: what the kernels are given.
//
// Every turn is about the z axis of its frame. From the frame before, a translation, a twist about x and the turn lead
// to it, as modified Denavit-Hartenberg numbers do. Joint, spring and the far end of a beam that share an axis are one
// turn. What is rigid beyond a turn, up to the next one, is its body.
//
// Included by sources that are compiled for different processors: nothing here may have code of its own.
#pragma once

namespace tubeplan::deflection::simd {

inline constexpr int kMaxTurns = 48;     ///< an arm with more is solved without a kernel
inline constexpr int kMaxUnknowns = 48;  ///< turns that give and beams, for derivatives
inline constexpr int kMaxJoints = 8;
inline constexpr int kGravityTurns = 3;  ///< of gravity about the base's axes

enum Twisted { kStraight, kQuarter, kAskew };

struct Turn {
  double p[3];                  ///< from the frame before, in its axes [m]; of a beam undeflected, p[2] = 0
  double cos_twist, sin_twist;  ///< about x, after the translation
  double cos_rest, sin_rest;    ///< of the turn where there is no joint
  double offset;                ///< of the joint's reading [rad]
  double compliance;            ///< of all that gives about this axis [rad/(N m)]
  double weight, moment[3];     ///< of the body [N], and its first moment about the origin [N m]
  double beam_compliance;       ///< that of the beam which leads here, bending about this axis [rad/(N m)]
  double beam_weight;           ///< along it [N]
  int joint;                    ///< index of the reading, or -1
  int twist;                    ///< which kind: a value of Twisted
  bool shifted[3], is_compliant, is_beam, has_moment;
};

struct RevoluteArm {
  const Turn* turns;
  int count, joints;
  double reach;               ///< yardstick of tolerances [m]
  double tip_R[9], tip_p[3];  ///< the tip's frame in the last turn's; columns one after the other
  bool tip_turned;            ///< tip_R is not the identity
  bool is_compliant;          ///< any of the turns does
};

/// Postures side by side: entry l of each array belongs to lane l, arrays of the same kind `stride` apart.
struct Postures {
  const double* q;        ///< readings, joint by joint [rad]
  const double* load;     ///< at the tip [N]
  const double* gravity;  ///< direction of gravity in the base, x, y, z
  long stride;
  double tolerance;  ///< of the tip [m]
  int max_iterations;
};

/// Shapes side by side. What is null is not asked for.
struct Shapes {
  double* pose;            ///< 12: p_BD, then the columns of R_BD
  double* jacobian;        ///< 6 for each joint: d p_BD, then the rotation vector, base axes
  double* sweeps;          ///< that it took; negative where the shape does not converge
  double* element_states;  ///< 4 for each turn: moment about its axis [N m]; its angle [rad]; of a beam lambda, kappa
  long stride;             ///< of what is above, but for the jacobian
  long derivative_stride;  ///< of the jacobian, and of what is asked for with it:
  double* by_gravity = nullptr;     ///< 6 for each turn of gravity's direction about an axis of the base
  double* by_compliance = nullptr;  ///< 6 for all of each turn's springs [per rad/(N m)], then 6 for the beam that
                                    ///< leads to it; written only of what there is
  double* turns = nullptr;          ///< 12 for each turn: its frame in the base, as the pose
};

/// Solves as many postures as the kernel has lanes.
using SolveShapes = void (*)(const RevoluteArm&, const Postures&, const Shapes&);

/// What an arm of four joints holds to its goals.
struct Tool {
  double axis[3];       ///< the tool's, in the tip's frame
  int hand;             ///< the turn that carries the last joint's axis ...
  double hand_axis[3];  ///< ... and that axis in its frame
};

/// Goals side by side, each with readings to start from.
struct Goals {
  double p_BT[3][8], axis_B[3][8], start[4][8], load[8], gravity_B[3][8];
  double tolerance;                            ///< of shapes, at the tip [m]
  double position_tolerance, pitch_tolerance;  ///< m, rad
  int max_sweeps;                              ///< pairs of them, in one shape
  int max_steps;
  bool damped;  ///< steps are halved until they bring a lane nearer
};

/// Where the steps have led.
struct Reached {
  double q[4][8];
  double done[8];  ///< 1 where the goal is met, 2 where damped steps end before, 0 where given up
  double steps[8];
  double position_error[8];  ///< m
  double tilt_sine[8], tilt_cosine[8];
  double smallest_singular_value[8];  ///< of the Jacobian scaled by the reach
};

/// Newton's method for as many goals as the kernel has lanes.
using MeetGoals = void (*)(const RevoluteArm&, const Tool&, const Goals&, Reached&);

}  // namespace tubeplan::deflection::simd
