// Reader of a cell's tube sheet and calibration tool.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "app/formats/yaml/yaml_node.hpp"
#include "tubesheets/sheet.hpp"
#include "tubesheets/stepped_tool.hpp"

namespace tubeplan::app {

/// Reads `tubesheet: {layout: {type, ...}, hole_diameter, leg, viewed_from?, name?, manway?}` or, for a map with
/// another layout, `{map: FILE.csv, pitch, hole_diameter, leg, viewed_from?, name?, manway?}` with the file relative to
/// `folder`; `manway: {center, diameter}`. Throws InputError, also for the problems that the readers of tubesheets
/// find.
[[nodiscard]] tubesheets::Sheet readSheet(const YamlNode& node, const Units& units,
                                          const std::filesystem::path& folder);

/// Adds warnings about the hole map: its notes, names that do not match, and holes off the lattice of their neighbours.
void warnOfHoles(const tubesheets::Sheet& sheet, const Units& units, std::vector<std::string>& warnings);

/// Reads `calibration_tool: {steps: [{diameter, tolerance}, ...], lengths?}` for holes of that diameter [m]. Throws
/// InputError.
[[nodiscard]] tubesheets::SteppedTool readSteppedTool(const YamlNode& node, const Units& units, double hole_diameter);

}  // namespace tubeplan::app
