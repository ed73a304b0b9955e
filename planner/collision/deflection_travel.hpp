// Proved bound on how far a point of the arm moves because deflections change while joints move. It is valid in every
// posture.
//
// A joint that turns by dq turns the loads beyond it, and turns gravity in the frames of the elements beyond it. The
// moment on each element changes by at most dq times a first moment of loads, and the rotation of each element changes
// the moments on the other elements again. Let x_e be the rotation that element e gains per dq, C_e the compliance of
// e, m the first moment of the loads beyond an element, and W the weight of these loads. Then
//      x_e <= C_e ( m_joint or m_e  +  sum over elements beyond (m x + W y)  +  m_e sum over elements before (x)
//                   + W_e y_e ),
// where y <= l x (1 + 2 theta) is the displacement at the end of a member of length l that bends by at most theta. All
// factors are positive and small, so that a Neumann series solves the inequalities.
//
// A prismatic joint that extends by ds moves everything beyond it further out. Elements before it first gain C_e (W + w
// r_e), where W is the weight on its bar, w the weight of the bar per metre, and r_e the distance of the bar's end from
// e. The bar itself gains C_e m_e / l, because its compliance grows with its length l. All other terms are taken with
// every prismatic joint fully extended.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "planner/workcell.hpp"

namespace tubeplan::planner {

struct DeflectionTravel {
  bool is_proved = false;
  std::string reason;  ///< reason why the bound is not proved; empty if the bound is proved
  /// motion per rad (or m) of each joint [m], in addition to the motion of the arm frozen in its bent shape; includes
  /// changes of the members' bow
  Eigen::VectorXd per_joint;
  double jump = 0;  ///< jump when joint play snaps over, independent of how far the joints move [m]
  /// Factor on all rigid lengths, because the chord of a bent member may be longer than the member.
  double stretch = 1;
};

/// Returns the distance that a point can jump when the mechanical play of joints snaps over [m]: the sum over all
/// joints of the play times the reach beyond the joint. This distance is subtracted from the margin of every posture.
/// `body_reach`: largest distance of a body point from each row's frame [m].
[[nodiscard]] double gapJumpOf(const Workcell& cell, const std::vector<double>& body_reach);

/// Returns the bound; `body_reach` as for gapJumpOf(). The bound is not proved for an arm with effects, with prismatic
/// joints without limits, or so compliant that members may bend by more than 0.1 rad.
[[nodiscard]] DeflectionTravel deflectionTravelOf(const Workcell& cell, const std::vector<double>& body_reach);

}  // namespace tubeplan::planner
