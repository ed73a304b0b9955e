// Simulated measurements of a cell: from the request to the readings and the truth behind them.
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

/// Options of a simulation in the cell's units, as typed.
struct SimulationRequest {
  std::string design;  ///< name of a row of the table, or path of a design file
  std::optional<int> readings;
  std::vector<double> loads, base_error;
  std::vector<std::string> hide;
  std::optional<double> sigma, held_out, push;
  double spread = 0;
  std::uint64_t seed = 1;
};

/// Standard deviation of the base's place about that of the cell.
struct BaseError {
  double shift = 0, turn = 0;  // standard deviation of each coordinate [m] and about each axis [rad]
};

/// Complete inputs of a simulation.
struct SimulationTask {
  calibration::CampaignDesign design;
  int readings = 0;
  BaseError base;
  calibration::CampaignTruth truth;
};

/// Returns the inputs of a simulation. Throws InputError for requests that cannot be measured or hidden.
[[nodiscard]] SimulationTask prepareSimulation(const Cell& cell, const SimulationRequest& request);

/// Simulates the campaign; the true arm is clear of the cell's scene at every reading.
[[nodiscard]] calibration::SimulatedCampaign simulateReadings(const Cell& cell, const SimulationTask& task,
                                                              std::uint64_t seed,
                                                              const calibration::CampaignHooks& hooks);

}  // namespace tubeplan::app
