// Proposals of the next measurements in a cell: holes that place the base, and readings that improve the free numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/design/next_readings.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Task of a proposal: the numbers to improve, the readings to use and the work.
struct TouchTask {
  CellModel cell;                                ///< the estimated cell
  std::optional<planner::Workcell> under_sheet;  ///< workcell of cells with a sheet
  std::vector<int> tubes;                        ///< tubes of the work list, where the tip must be known
  /// Information from the readings so far; nothing: not asked for.
  std::optional<calibration::Estimate> of_base, of_numbers;
  bool is_first = true;              ///< true: there are no readings yet
  bool by_touch = true;              ///< true: readings for the numbers are touches; false: the tip's place
  double base_sigma = 0, sigma = 0;  ///< sigma of touches for the base, and of readings for the numbers [m]
  std::vector<double> loads;         ///< [N]
  int count = 0;                     ///< number of touches, and of readings; 0: 3 touches, 10 readings
  int candidates = 0;                ///< number of holes or postures to choose from; 0: 60 holes, 600 postures
  /// Criterion of readings for the numbers.
  calibration::Optimality optimality = calibration::Optimality::kDeterminant;
  std::uint64_t seed = 1;
};

struct TouchProposal {
  std::vector<calibration::ReadingCandidate> candidates;
  calibration::NextReadings next;
  std::string reason;  ///< reason if there is none; else empty
  [[nodiscard]] const calibration::ReadingCandidate& chosen(const calibration::DesignStep& step) const {
    return candidates[static_cast<std::size_t>(next.candidates[static_cast<std::size_t>(step.candidate)])];
  }
};

struct TouchProposals {
  int work = 0, work_lost = 0;      ///< postures that the tip must be known in; tubes of the list that are out of reach
  int holes = 0, holes_unsure = 0;  ///< candidates for the base; those left out because another base may not reach them
  std::optional<TouchProposal> base, parameters;
  std::vector<std::string> nearest_holes;  ///< the three touchable holes nearest to the base, for comparison
  calibration::TipSigma tip_nearest;
};

[[nodiscard]] TouchProposals proposeTouches(const TouchTask& task);

}  // namespace tubeplan::app
