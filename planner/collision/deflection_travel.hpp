// How far deflection can move a point of the arm while the joints move: proved, for every posture at once.
//
// A joint that turns by dq turns the loads beyond it, and gravity as the elements beyond it see it; every element's
// moment changes by no more than first moments allow, and each element's turning changes the moments of the others
// again. With x_e the rotation that element e gains per dq, C_e its compliance, m the first moment of the loads beyond
// a place and W their weight,
//      x_e <= C_e ( m_joint or m_e  +  sum over elements beyond (m x + W y)  +  m_e sum over elements before (x)
//                   + W_e y_e ),
// where y <= l x (1 + 2 theta) is the displacement at the end of a member of length l that bends by theta at most. All
// factors are positive and small: the inequalities are solved by summing the series that they stand for.
//
// A joint that slides by ds takes all beyond it further out. Elements before it gain C_e (W + w r_e) at first, W the
// weight on the bar and w that of a metre of it, r_e its end's distance; the bar itself, whose compliance grows with
// its length l, C_e m_e / l. All else is taken with every slide drawn out to its limit.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "planner/workcell.hpp"

namespace tubeplan::planner {

struct DeflectionTravel {
  bool is_proved = false;
  std::string reason;  ///< why not
  /// m per rad (or m) of each joint, beyond what the joint's own motion gives with the arm's bent shape frozen; with
  /// what the bow of the members changes.
  Eigen::VectorXd per_joint;
  double jump = 0;     ///< m, beyond any travel: gaps of joints that snap over
  double stretch = 1;  ///< factor on all rigid lengths: chords of bent members may be longer than the members
};

/// How far a point can jump where clearances of joints snap over [m]: every gap times the reach beyond it. It comes off
/// the margin of every posture. `body_reach`: greatest distance of a body point from each row's frame [m].
[[nodiscard]] double gapJumpOf(const Workcell& cell, const std::vector<double>& body_reach);

/// With the same `body_reach`. Not proved for an arm with effects, with slides without limits, or so soft that members
/// bend by more than 0.1 rad.
[[nodiscard]] DeflectionTravel deflectionTravelOf(const Workcell& cell, const std::vector<double>& body_reach);

}  // namespace tubeplan::planner
