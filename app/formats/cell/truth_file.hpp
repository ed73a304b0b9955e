// Writer of the true parameters behind simulated measurements, a file next to the measurements.
#pragma once

#include <cstdint>
#include <string>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/simulation/simulated_campaign.hpp"

namespace tubeplan::app {

struct TruthFile {
  const Cell& cell;
  const calibration::CampaignDesign& design;
  const calibration::CampaignTruth& truth;
  const calibration::SimulatedCampaign& campaign;
  std::uint64_t seed = 1;
  double spread = 0;
  double base_shift = 0, base_turn = 0;  ///< standard deviations of the true base about the cell's base [m, rad]
};

/// Returns YAML in the cell's units with the keys cell, design, seed, measurements, units, sigma, encoder_sigma (of
/// each joint), spread and base_error, and the lists `parameters` (those under identify: name, value, nominal, unit),
/// `bases` (setup, position, rpy), `points` (name, position) and `hidden`.
[[nodiscard]] std::string truthYaml(const TruthFile& file);

/// Returns the arm's parameters that the cell's `identify` names, in file order; `geometry` and `tool.tip` are expanded
/// to single parameters.
[[nodiscard]] std::vector<deflection::Parameter> identifiedParameters(const Cell& cell);

}  // namespace tubeplan::app
