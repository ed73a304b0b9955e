// Rows of the watched measurements: whitened residuals and their derivatives with respect to the errors of the
// calibration and to the candidate changes.
//
// A measured value has the residual u = r + H x + C t with unit variance, where x is the error of base and parameters
// (prior: standard normal) and t a change. A count of steps has two such rows, the offset from the hole's axis divided
// by its standard deviation, and states only the region in which this offset lies (counted_steps.hpp).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/touch_fit.hpp"
#include "calibration/hooks.hpp"
#include "calibration/watch/candidate_changes.hpp"
#include "calibration/watch/counted_steps.hpp"

namespace tubeplan::calibration {

/// The calibrated arm that is watched. `uncertainty` is that of base and parameters together, about X_WB and `arm`.
struct WatchedArm {
  const deflection::Arm& arm;
  Eigen::Isometry3d X_WB;
  const JointUncertainty& uncertainty;
  double model_error = 0;             ///< standard deviation of the model error of each coordinate [m]
  tubesheets::SteppedTool tool = {};  ///< tool whose steps are counted; without steps, no measurement may count them
};

struct WatchedRows {
  std::string reason;  ///< reason why there are no rows; empty on success
  Eigen::VectorXd r;
  Eigen::MatrixXd H;        ///< derivatives with respect to x
  Eigen::MatrixXd changes;  ///< derivatives with respect to the numbers of all candidate changes
  std::vector<int> first_row;
  std::vector<std::optional<CountedSteps>> counted;  ///< the count of a measurement that counts steps
  std::vector<double> scale;  ///< standard deviation that divides a counted offset [m]; 0 for other measurements
  std::vector<Eigen::MatrixXd> whitener;

  [[nodiscard]] int count() const { return static_cast<int>(first_row.size()); }
  [[nodiscard]] Eigen::Index first(int k) const { return first_row[static_cast<std::size_t>(k)]; }
  [[nodiscard]] Eigen::Index rowsOf(int k) const { return (k + 1 < count() ? first(k + 1) : r.size()) - first(k); }
  [[nodiscard]] bool isCounted(int k) const { return counted[static_cast<std::size_t>(k)].has_value(); }
  [[nodiscard]] bool hasCounts() const;
};

/// Returns the rows of the measurements, with the candidate changes that they could show. Throws WorkStopped.
struct RowsAndCandidates {
  WatchedRows rows;
  CandidateChanges candidates;
};
[[nodiscard]] RowsAndCandidates watchedRows(const WatchedArm& watched, const std::vector<Measurement>& measurements,
                                            const StopQuestion& stop = {});

}  // namespace tubeplan::calibration
