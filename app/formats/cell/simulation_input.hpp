// Measurements of a cell to practise on: from what is asked for to the readings and the truth behind them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/simulation/campaign_design.hpp"
#include "calibration/simulation/campaign_truth.hpp"
#include "calibration/simulation/simulated_campaign.hpp"

namespace tubeplan::app {

/// In the cell's units, as typed.
struct SimulationRequest {
  std::string design;  ///< a name of the table, or a design file
  std::optional<int> readings;
  std::vector<double> loads, base_error;
  std::vector<std::string> hide;
  std::optional<double> sigma, held_out, push;
  double spread = 0;
  std::uint64_t seed = 1;
};

/// How far the base may be from where the cell has it.
struct BaseError {
  double shift = 0, turn = 0;  // m, rad
};

/// All that is settled before the first reading is made.
struct SimulationTask {
  calibration::CampaignDesign design;
  int readings = 0;
  BaseError base;
  calibration::CampaignTruth truth;
};

/// Throws InputError for what cannot be measured or hidden.
[[nodiscard]] SimulationTask prepareSimulation(const Cell& cell, const SimulationRequest& request);

/// Measures: every reading of the true arm is clear of the cell's scene.
[[nodiscard]] calibration::SimulatedCampaign simulateReadings(const Cell& cell, const SimulationTask& task,
                                                              std::uint64_t seed,
                                                              const calibration::CampaignHooks& hooks);

}  // namespace tubeplan::app
