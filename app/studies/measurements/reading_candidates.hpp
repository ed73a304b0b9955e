// Candidates for the next measurements in a cell: holes and postures that the arm reaches without collision.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/design/next_readings.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Returns the cell's arm and scene, for cells without a sheet too.
[[nodiscard]] planner::Workcell armAndScene(const CellModel& cell);

/// A hole that can be touched, with one of the postures that reach it.
struct ReachedHole {
  int tube = -1;  ///< index in the sheet
  Eigen::VectorXd q;
};

/// Returns the postures that reach these tubes under the cell's load, clear during the whole approach, in the tubes'
/// order: all of each tube, or the first only.
[[nodiscard]] std::vector<ReachedHole> reachHoles(const planner::Workcell& cell, const std::vector<int>& tubes,
                                                  bool all_branches);

/// Function that returns true if a posture under a load [N] may be proposed.
using PostureQuestion = std::function<bool(const Eigen::VectorXd& q, double load)>;

/// Choice of random postures: anywhere within the limits, or with each joint anywhere or near one of its limits, where
/// models differ most.
enum class PostureChoice { kAnywhere, kNearLimits };

/// Returns random postures within the joints' limits (a turn for angles without limits), clear of the scene under each
/// of the loads [N], and allowed by `is_allowed`. There are fewer if hardly any is clear.
[[nodiscard]] std::vector<Eigen::VectorXd> clearPostures(planner::Workcell cell, const std::vector<double>& loads,
                                                         int count, std::uint64_t seed,
                                                         const PostureQuestion& is_allowed = {},
                                                         PostureChoice choice = PostureChoice::kAnywhere);

/// Returns touches of each hole under the cell's load.
[[nodiscard]] std::vector<calibration::ReadingCandidate> holeTouches(const planner::Workcell& cell,
                                                                     const std::vector<ReachedHole>& holes,
                                                                     double sigma);

/// Returns readings of the tip's place at each posture under each load.
[[nodiscard]] std::vector<calibration::ReadingCandidate> positionReadings(const std::vector<Eigen::VectorXd>& postures,
                                                                          const std::vector<double>& loads,
                                                                          double sigma);

/// Returns touches of the place where each posture's tip rests under the first load, under every load (two or more).
/// Places that cannot be reached again under another load, clear, are left out.
[[nodiscard]] std::vector<calibration::ReadingCandidate> pointTouches(planner::Workcell cell,
                                                                      const std::vector<Eigen::VectorXd>& postures,
                                                                      const std::vector<double>& loads, double sigma);

}  // namespace tubeplan::app
