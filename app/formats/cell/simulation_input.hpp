// Simulated measurements of a cell: converts a request to measurements, together with the true arm that produced them.
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

/// Options of a simulation as given on the command line, in the cell's units.
struct SimulationRequest {
  std::string design;  ///< name of a built-in design, or path of a design file
  std::optional<int> measurements;
  std::vector<double> loads, base_error;
  std::vector<std::string> hide;
  std::optional<double> sigma, held_out, push;
  double spread = 0;
  std::uint64_t seed = 1;
};

/// Standard deviations of the true base pose about the cell's base pose; zero for a known base.
struct BaseError {
  double shift = 0, turn = 0;  // standard deviation of each coordinate [m] and about each axis [rad]
};

/// Complete inputs of a simulation, in internal units.
struct SimulationTask {
  calibration::CampaignDesign design;
  int measurements = 0;
  BaseError base;
  calibration::CampaignTruth truth;
};

/// Converts a request to the inputs of a simulation. Throws InputError for a design that cannot be measured and for
/// effects that cannot be hidden.
[[nodiscard]] SimulationTask prepareSimulation(const Cell& cell, const SimulationRequest& request);

/// Simulates the measurement campaign. The true arm is clear of the cell's scene at every measurement.
[[nodiscard]] calibration::SimulatedCampaign simulateMeasurements(const Cell& cell, const SimulationTask& task,
                                                                  std::uint64_t seed,
                                                                  const calibration::CampaignHooks& hooks);

}  // namespace tubeplan::app
