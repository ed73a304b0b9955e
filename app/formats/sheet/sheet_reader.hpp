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

/// Reads a sheet with a layout, `tubesheet: {layout: {type, ...}, hole_diameter, leg, viewed_from?, name?, manway?}`,
/// or with a hole map, `tubesheet: {map: FILE.csv, pitch, hole_diameter, leg, viewed_from?, name?, manway?}`. FILE.csv
/// is relative to `folder`; `manway` is `{center, diameter}`. Throws InputError for any other value and for a sheet or
/// hole map that the library tubesheets rejects.
[[nodiscard]] tubesheets::Sheet readSheet(const YamlNode& node, const Units& units,
                                          const std::filesystem::path& folder);

/// Adds warnings about a hole map: its notes, holes whose names contradict their positions, and holes off the lattice
/// of their neighbours.
void warnOfHoles(const tubesheets::Sheet& sheet, const Units& units, std::vector<std::string>& warnings);

/// Reads `calibration_tool: {steps: [{diameter, tolerance}, ...], lengths?}`, a tool for holes of `hole_diameter` [m].
/// Throws InputError for any other value and for a tool that does not fit the holes.
[[nodiscard]] tubesheets::SteppedTool readSteppedTool(const YamlNode& node, const Units& units, double hole_diameter);

}  // namespace tubeplan::app
