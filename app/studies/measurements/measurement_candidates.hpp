// Candidates for further measurements: holes and postures that the arm reaches without collision.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/design/next_measurements.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Returns a workcell with the cell's arm, base and scene. Cells without a tube sheet are allowed.
[[nodiscard]] planner::Workcell armAndScene(const CellModel& cell);

/// A hole that can be touched, with a posture that reaches it.
struct ReachedHole {
  int tube = -1;  ///< index in the tube sheet
  Eigen::VectorXd q;
};

/// Returns postures that reach the given tubes under the cell's load, without collision during the whole approach. The
/// postures are in the order of the tubes: the postures of all branches that reach a tube, or only of the first branch
/// found.
[[nodiscard]] std::vector<ReachedHole> reachHoles(const planner::Workcell& cell, const std::vector<int>& tubes,
                                                  bool all_branches);

/// Function that returns true if a posture `q` under a load [N] may be proposed.
using PostureQuestion = std::function<bool(const Eigen::VectorXd& q, double load)>;

/// Distribution of random postures. kAnywhere draws each joint uniformly within its limits. kNearLimits puts about two
/// thirds of the joints near a limit, where models differ most.
enum class PostureChoice { kAnywhere, kNearLimits };

/// Returns random postures within the joint limits (a full turn for joints without limits). The postures are clear of
/// the scene under each of the loads [N] and allowed by `is_allowed`. There are fewer than `count` if the random search
/// finds too few.
[[nodiscard]] std::vector<Eigen::VectorXd> clearPostures(planner::Workcell cell, const std::vector<double>& loads,
                                                         int count, std::uint64_t seed,
                                                         const PostureQuestion& is_allowed = {},
                                                         PostureChoice choice = PostureChoice::kAnywhere);

/// Returns a touch of each hole under the cell's load, with the noise `sigma` [m].
[[nodiscard]] std::vector<calibration::MeasurementCandidate> holeTouches(const planner::Workcell& cell,
                                                                         const std::vector<ReachedHole>& holes,
                                                                         double sigma);

/// Returns a measurement of the tip position at each posture under each load [N], with the noise `sigma` [m].
[[nodiscard]] std::vector<calibration::MeasurementCandidate> positionMeasurements(
    const std::vector<Eigen::VectorXd>& postures, const std::vector<double>& loads, double sigma);

/// Returns, for each posture, touches of one point under every load (two or more) [N]. The point is where the tip rests
/// in this posture under the first load. Points that the arm cannot reach without collision under every load are
/// excluded.
[[nodiscard]] std::vector<calibration::MeasurementCandidate> pointTouches(planner::Workcell cell,
                                                                          const std::vector<Eigen::VectorXd>& postures,
                                                                          const std::vector<double>& loads,
                                                                          double sigma);

}  // namespace tubeplan::app
