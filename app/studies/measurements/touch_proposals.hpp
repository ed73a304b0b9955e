// Proposals of further measurements in a cell: holes to touch for calibrating the base, and measurements that improve
// the free parameters.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/design/next_measurements.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Input of proposeTouches(): the estimates to improve, the measurements that may be proposed, and the work list.
struct TouchTask {
  CellModel cell;  ///< cell with the estimated arm and base
  /// Workcell under the tube sheet; std::nullopt if the cell has no sheet.
  std::optional<planner::Workcell> under_sheet;
  std::vector<int> tubes;  ///< tubes of the work list, where the tip's uncertainty matters
  /// Estimates of the base and of the parameters from the measurements so far; std::nullopt if not requested.
  std::optional<calibration::Estimate> of_base, of_numbers;
  bool is_first = true;  ///< true if there are no measurements yet
  /// True if measurements for the parameters are touches; false if they are tip positions.
  bool by_touch = true;
  double base_sigma = 0, sigma = 0;  ///< noise of touches for the base, and of measurements for the parameters [m]
  std::vector<double> loads;         ///< loads under which measurements may be proposed [N]
  /// Number of touches for the base and of measurements for the parameters; by default 3 touches and 10 measurements.
  int count = 0;
  int candidates = 0;  ///< number of holes or postures to choose from; by default 60 holes or 600 postures
  /// Design criterion for the measurements of the parameters.
  calibration::Optimality optimality = calibration::Optimality::kDeterminant;
  std::uint64_t seed = 1;
};

struct TouchProposal {
  std::vector<calibration::MeasurementCandidate> candidates;
  calibration::NextMeasurements next;
  std::string reason;  ///< reason why there is no proposal; empty on success
  [[nodiscard]] const calibration::MeasurementCandidate& chosen(const calibration::DesignStep& step) const {
    return candidates[static_cast<std::size_t>(next.candidates[static_cast<std::size_t>(step.candidate)])];
  }
};

struct TouchProposals {
  /// Number of work postures, and number of tubes on the work list that are out of reach. The proposals minimise the
  /// tip's uncertainty in the work postures.
  int work = 0, work_lost = 0;
  /// Number of touchable holes in reach from the nominal base, and number of those excluded because they may be out of
  /// reach from the true base.
  int holes = 0, holes_uncertain = 0;
  std::optional<TouchProposal> base, parameters;
  std::vector<std::string> nearest_holes;  ///< the three touchable holes nearest to the base, for comparison
  calibration::TipSigma tip_nearest;
};

[[nodiscard]] TouchProposals proposeTouches(const TouchTask& task);

}  // namespace tubeplan::app
