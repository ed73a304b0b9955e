// Reader of cells: an arm on its base, with tube sheet, calibration tool and scene if the file has them.
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

/// Cell with names, units and sources from its files. Numbers in the cell's file are in the units of the arm file.
struct Cell : CellModel {
  std::string path;
  std::string name;      ///< name in the file, otherwise the file's name without extension
  std::string arm_path;  ///< path of the arm's file; the cell's own path for an inline arm
  Units units;
  std::vector<SceneMesh> meshes;      ///< mesh files that the scene names
  std::vector<std::string> warnings;  ///< warnings about the scene and the hole map, one sentence each

  YamlFile source;      ///< cell's file as read, so that it can be written with changes
  YamlFile arm_source;  ///< arm's file as read; empty for an inline arm
};

/// Reads a cell. Throws InputError, with file, line and key, for any content that docs/files.md does not describe.
[[nodiscard]] Cell readCell(const std::string& path);

/// Parses a cell from text as if it were the file `path`; names of files in the text are relative to the folder of
/// `path`. `arm_text`, if given, replaces the content of the arm's file.
[[nodiscard]] Cell parseCell(const std::string& text, const std::string& path,
                             const std::optional<std::string>& arm_text = std::nullopt);

/// Returns the tube sheet. Throws InputError if the cell has none; `purpose` completes "needed to ..." in the message.
[[nodiscard]] const tubesheets::Sheet& requireSheet(const Cell& cell, const std::string& purpose);
[[nodiscard]] const tubesheets::SteppedTool& requireTool(const Cell& cell, const std::string& purpose);

/// Throws InputError if neither the arm's file nor the scene states the tool axis; `purpose` completes "needed to ...".
void requireToolAxis(const Cell& cell, const std::string& purpose);

}  // namespace tubeplan::app
