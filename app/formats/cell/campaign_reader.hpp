// Reader of YAML files that describe the design of a measurement campaign.
#pragma once

#include <optional>
#include <string>

#include "app/formats/units.hpp"
#include "calibration/simulation/campaign_design.hpp"

namespace tubeplan::app {

struct CampaignFile {
  calibration::CampaignDesign design;
  /// Number of postures, each measured under every load; std::nullopt if the file states none.
  std::optional<int> postures;
};

/// Reads {kind: a name of measurementKinds(), at: anywhere | plane | holes, points: known | unknown, postures,
/// postures_per_point, loads: [...], push, rows: [...], anchor: [x, y, z], direction: [x, y, z], region: {from: [x, y,
/// z], to: [x, y, z]}, setups, split, sigma, sigmas: [x, y, z], correlations: [xy, xz, yz], turn_sigma, name}. Only
/// `kind` is required, and `anchor` and `direction` for kinds that need them. Numbers are in the cell's units; `rows`
/// lists names of rows of the arm. Throws InputError, with the line, for any other content.
[[nodiscard]] CampaignFile readCampaignFile(const std::string& path, const deflection::Arm& arm, const Units& units,
                                            bool has_sheet);

}  // namespace tubeplan::app
