// Proved bound on the motion of a point of the arm by deflection while the joints move, for all postures together.
//
// A joint that turns by dq turns the loads beyond it, and gravity in the frames of the elements beyond it; every
// element's moment changes by no more than first moments allow, and each element's turning changes the moments of the
// others again. With x_e the rotation that element e gains per dq, C_e its compliance, m the first moment of the loads
// beyond a place and W their weight,
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
  std::string reason;  ///< reason if not proved
  /// motion per rad (or m) of each joint, beyond that of the arm frozen in its bent shape; includes changes of the
  /// members' bow [m]
  Eigen::VectorXd per_joint;
  double jump = 0;     ///< motion independent of any travel, when clearances of joints snap over [m]
  double stretch = 1;  ///< factor on all rigid lengths, because chords of bent members may be longer than the members
};

/// Returns the distance that a point can jump when clearances of joints snap over [m]: every gap times the reach beyond
/// it. It is subtracted from the margin of every posture. `body_reach`: greatest distance of a body point from each
/// row's frame [m].
[[nodiscard]] double gapJumpOf(const Workcell& cell, const std::vector<double>& body_reach);

/// Computes the bound, with the same `body_reach`. It is not proved for an arm with effects, with slides without
/// limits, or so compliant that members bend by more than 0.1 rad.
[[nodiscard]] DeflectionTravel deflectionTravelOf(const Workcell& cell, const std::vector<double>& body_reach);

}  // namespace tubeplan::planner
