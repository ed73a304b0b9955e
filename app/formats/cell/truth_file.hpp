// Writer of a simulated campaign's truth, beside its readings.
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
  double base_shift = 0, base_turn = 0;  ///< standard deviations of the base's place [m, rad]
};

/// Returns YAML in the cell's units: cell, design, seed, readings, sigma, encoder_sigma (by joint), spread, base_error;
/// `parameters` (those under identify: name, value, nominal, unit), `bases` (setup, position, rpy), `points` (name,
/// position), `hidden`.
[[nodiscard]] std::string truthYaml(const TruthFile& file);

/// Returns the arm's numbers that the cell's `identify` names, in file order, with `geometry` and `tool.tip` as single
/// numbers.
[[nodiscard]] std::vector<deflection::Parameter> identifiedParameters(const Cell& cell);

}  // namespace tubeplan::app
