// Choice of base positions for a list of tubes: which tubes the arm reaches from each candidate, and which candidates
// together reach most of them.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "calibration/hooks.hpp"
#include "planner/positions/base_cover.hpp"
#include "planner/reach/tube_reach.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// A row of positions along one axis of the world, or of turns about the vertical through the base.
struct BaseAxis {
  int axis = 0;             ///< 0 to 2 for x, y, z of the base; 3 for the rotation about z
  double from = 0, to = 0;  ///< first and last value [m or rad]
  int count = 1;            ///< number of values, evenly spaced
};

struct BaseChoiceOptions {
  std::vector<BaseAxis> axes;  ///< the candidates are all combinations; other coordinates are taken from the cell
  /// Axes (0 for x, 1 for y) along which the candidates are mirrored. For each axis, the mirror images of all
  /// candidates so far, in the plane where that coordinate is zero, are added.
  std::vector<int> mirrored;
  std::vector<std::string> moving;  ///< names of obstacles that move with the base, and are not checked
  planner::BaseCoverOptions cover;
  planner::TubeReachOptions reach;
};

struct BaseChoice {
  std::vector<Eigen::Isometry3d> bases;    ///< candidates; the cell's own base is the first
  std::vector<std::vector<bool>> reaches;  ///< reaches[c][t]: candidate c reaches the t-th tube
  planner::BaseCover cover;
  bool is_stopped = false;  ///< true if the search was stopped on request and made no choice
};

/// Returns all candidates, the cell's own base first.
[[nodiscard]] std::vector<Eigen::Isometry3d> baseCandidates(const Eigen::Isometry3d& X_WB,
                                                            const BaseChoiceOptions& options);

/// Finds which of the tubes (indices in the sheet) the arm reaches from each candidate, free of collision from standoff
/// to hole, and chooses among the candidates. Paths between tubes are not checked.
[[nodiscard]] BaseChoice chooseBases(const planner::Workcell& cell, const std::vector<int>& tubes,
                                     const BaseChoiceOptions& options, const calibration::WorkHooks& hooks = {});

}  // namespace tubeplan::app
