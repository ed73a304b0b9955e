// A measurement campaign's design out of a YAML file.
#pragma once

#include <optional>
#include <string>

#include "app/formats/units.hpp"
#include "calibration/simulation/campaign_design.hpp"

namespace tubeplan::app {

struct CampaignFile {
  calibration::CampaignDesign design;
  std::optional<int> postures;  ///< how many; each is read under every load
};

/// Reads {kind: position | touch | deflection | distance, at: anywhere | plane | holes, points: known | unknown,
/// postures, postures_per_point, loads: [...], rows: [...], anchor: [x, y, z], region: {from: [x, y, z], to: [x, y,
/// z]}, setups, split, sigma, sigmas: [x, y, z], correlations: [xy, xz, yz], turn_sigma, name}, all but the kind
/// optional (the anchor of distances is not), in the cell's units; rows by the names that they have in the arm. Throws
/// InputError, with the line, for what is not as documented.
[[nodiscard]] CampaignFile readCampaignFile(const std::string& path, const deflection::Arm& arm, const Units& units,
                                            bool has_sheet);

}  // namespace tubeplan::app
