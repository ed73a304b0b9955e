// What could be measured next in a cell: holes and postures that the arm reaches without touching anything.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/design/next_readings.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// The cell as far as arm and scene go, for cells without a sheet too.
[[nodiscard]] planner::Workcell armAndScene(const CellModel& cell);

/// A hole that can be touched, with one of the postures that reach it.
struct ReachedHole {
  int tube = -1;  ///< index in the sheet
  Eigen::VectorXd q;
};

/// The postures that reach these tubes under the cell's load, clear all the way up, in the tubes' order: all of each
/// tube, or the first only.
[[nodiscard]] std::vector<ReachedHole> reachHoles(const planner::Workcell& cell, const std::vector<int>& tubes,
                                                  bool all_branches);

/// Whether a posture under a load [N] may be proposed.
using PostureQuestion = std::function<bool(const Eigen::VectorXd& q, double load)>;

/// Anywhere within the limits; or each joint anywhere or near one of its limits, where models differ most.
enum class PostureChoice { kAnywhere, kNearLimits };

/// Random postures within the joints' limits (a turn where an angle has none), clear of the scene under each of the
/// loads [N], and allowed where that is asked. Fewer where hardly any is clear.
[[nodiscard]] std::vector<Eigen::VectorXd> clearPostures(planner::Workcell cell, const std::vector<double>& loads,
                                                         int count, std::uint64_t seed,
                                                         const PostureQuestion& is_allowed = {},
                                                         PostureChoice choice = PostureChoice::kAnywhere);

/// The tip touched to each hole under the cell's load.
[[nodiscard]] std::vector<calibration::ReadingCandidate> holeTouches(const planner::Workcell& cell,
                                                                     const std::vector<ReachedHole>& holes,
                                                                     double sigma);

/// The tip's place measured at each posture under each load.
[[nodiscard]] std::vector<calibration::ReadingCandidate> positionReadings(const std::vector<Eigen::VectorXd>& postures,
                                                                          const std::vector<double>& loads,
                                                                          double sigma);

/// The place where each posture's tip rests under the first load, touched under every load (two or more). Places that
/// cannot be reached again under another load, clear, are left out.
[[nodiscard]] std::vector<calibration::ReadingCandidate> pointTouches(planner::Workcell cell,
                                                                      const std::vector<Eigen::VectorXd>& postures,
                                                                      const std::vector<double>& loads, double sigma);

}  // namespace tubeplan::app
