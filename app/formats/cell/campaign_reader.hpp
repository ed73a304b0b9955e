// Reader of a measurement campaign's design in YAML.
#pragma once

#include <optional>
#include <string>

#include "app/formats/units.hpp"
#include "calibration/simulation/campaign_design.hpp"

namespace tubeplan::app {

struct CampaignFile {
  calibration::CampaignDesign design;
  std::optional<int> postures;  ///< number of postures, each read under every load
};

/// Reads {kind: position | touch | deflection | distance, at: anywhere | plane | holes, points: known | unknown,
/// postures, postures_per_point, loads: [...], rows: [...], anchor: [x, y, z], region: {from: [x, y, z], to: [x, y,
/// z]}, setups, split, sigma, sigmas: [x, y, z], correlations: [xy, xz, yz], turn_sigma, name}. Only the kind is
/// required, and the anchor for distances. Numbers are in the cell's units; rows have the names of the arm's rows.
/// Throws InputError, with the line, for anything else.
[[nodiscard]] CampaignFile readCampaignFile(const std::string& path, const deflection::Arm& arm, const Units& units,
                                            bool has_sheet);

}  // namespace tubeplan::app
