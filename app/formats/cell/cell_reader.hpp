// Reader of cells: an arm on its base, with the tube sheet, the calibration tool and the scene if the file has them.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "app/formats/arm/arm_reader.hpp"
#include "app/formats/cell/scene_reader.hpp"
#include "app/formats/units.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "app/studies/cell_model.hpp"

namespace tubeplan::app {

/// Cell with the names, units and sources of its files. The numbers of the cell's file are in the arm's units.
struct Cell : CellModel {
  std::string path;
  std::string name;      ///< the file's stem if the file states none
  std::string arm_path;  ///< the cell's own path for an inline arm
  Units units;
  std::vector<SceneMesh> meshes;      ///< meshes that the scene names
  std::vector<std::string> warnings;  ///< warnings about the scene and the hole map, a sentence each

  YamlFile source;      ///< the file as read, to write it again with changes
  YamlFile arm_source;  ///< the arm's file as read; empty for an inline arm
};

/// Reads a cell. Throws InputError, with file, line and key, for anything that is not as documented.
[[nodiscard]] Cell readCell(const std::string& path);

/// Reads a cell from text, as if it were the file `path`: names of files in it are relative to there. The arm's file is
/// not read if its text is given.
[[nodiscard]] Cell parseCell(const std::string& text, const std::string& path,
                             const std::optional<std::string>& arm_text = std::nullopt);

/// Returns the sheet. Throws InputError if the cell has none; `purpose` continues "needed to ...".
[[nodiscard]] const tubesheets::Sheet& requireSheet(const Cell& cell, const std::string& purpose);
[[nodiscard]] const tubesheets::SteppedTool& requireTool(const Cell& cell, const std::string& purpose);

/// Throws InputError if neither the arm's file nor the scene states the direction of the tool.
void requireToolAxis(const Cell& cell, const std::string& purpose);

}  // namespace tubeplan::app
