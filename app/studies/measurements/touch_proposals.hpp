// What to measure next in a cell: holes that place the base, and readings that sharpen the free numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/design/next_readings.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// What shall be sharpened, by which readings, for which work.
struct TouchTask {
  CellModel cell;                                            ///< as estimated
  std::optional<planner::Workcell> under_sheet;              ///< of cells with a sheet
  std::vector<int> tubes;                                    ///< of the work list: where the tip must be known
  std::optional<calibration::Estimate> of_base, of_numbers;  ///< what the readings made determine; none: not asked for
  bool is_first = true;                                      ///< no reading was made yet
  bool by_touch = true;                                      ///< readings for the numbers touch; else the tip's place
  double base_sigma = 0, sigma = 0;  ///< m, of touches for the base, of readings for the numbers
  std::vector<double> loads;         ///< N
  int count = 0;                     ///< of each; 0: 3 touches, 10 readings
  int candidates = 0;                ///< holes or postures to choose from; 0: 60 holes, 600 postures
  calibration::Optimality optimality = calibration::Optimality::kDeterminant;  ///< of readings for the numbers
  std::uint64_t seed = 1;
};

struct TouchProposal {
  std::vector<calibration::ReadingCandidate> candidates;
  calibration::NextReadings next;
  std::string reason;  ///< why there is none; empty where there is one
  [[nodiscard]] const calibration::ReadingCandidate& chosen(const calibration::DesignStep& step) const {
    return candidates[static_cast<std::size_t>(next.candidates[static_cast<std::size_t>(step.candidate)])];
  }
};

struct TouchProposals {
  int work = 0, work_lost = 0;  ///< postures that the tip shall be known in; tubes of the list that are out of reach
  int holes = 0, holes_unsure = 0;  ///< for the base; of them left out, since another base may not reach them
  std::optional<TouchProposal> base, parameters;
  std::vector<std::string> nearest_holes;  ///< the three nearest the base that can be touched, for comparison
  calibration::TipSigma tip_nearest;
};

[[nodiscard]] TouchProposals proposeTouches(const TouchTask& task);

}  // namespace tubeplan::app
