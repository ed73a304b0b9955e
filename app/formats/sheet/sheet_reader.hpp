// A cell's tube sheet and calibration tool.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "app/formats/yaml/yaml_node.hpp"
#include "tubesheets/sheet.hpp"
#include "tubesheets/stepped_tool.hpp"

namespace tubeplan::app {

/// Reads `tubesheet: {layout: {type, ...}, hole_diameter, leg, viewed_from?, name?, manway?}` or, for a map drilled
/// otherwise, `{map: FILE.csv, pitch, hole_diameter, leg, viewed_from?, name?, manway?}` with the file relative to
/// `folder`; `manway: {center, diameter}`. Throws InputError for what the readers of tubesheets find wrong, too.
[[nodiscard]] tubesheets::Sheet readSheet(const YamlNode& node, const Units& units,
                                          const std::filesystem::path& folder);

/// A sentence for each hole of a map that lies off the lattice of those about it, the first few of them.
void warnOfHoles(const tubesheets::Sheet& sheet, const Units& units, std::vector<std::string>& warnings);

/// Reads `calibration_tool: {steps: [{diameter, tolerance}, ...], lengths?}` for holes of that diameter [m].
[[nodiscard]] tubesheets::SteppedTool readSteppedTool(const YamlNode& node, const Units& units, double hole_diameter);

}  // namespace tubeplan::app
