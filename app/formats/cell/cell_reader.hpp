// A cell: an arm on its base, with the tube sheet, the calibration tool and the scene around it where the file has
// them.
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

/// With what its files say besides: names, units, sources. The cell's file has its numbers in the arm's units.
struct Cell : CellModel {
  std::string path;
  std::string name;      ///< the file's stem where it states none
  std::string arm_path;  ///< the cell's own path where the arm stands inline
  Units units;
  std::vector<SceneMesh> meshes;      ///< that the scene names
  std::vector<std::string> warnings;  ///< of the scene and the hole map, a sentence each

  YamlFile source;      ///< as read, for writing it again with changes
  YamlFile arm_source;  ///< the same of the arm's file; empty where it stands inline
};

/// Throws InputError for anything that is not as documented, naming file, line and key.
[[nodiscard]] Cell readCell(const std::string& path);

/// The same from text at hand, as if it stood at `path`: the files it names are relative to there, but for the arm's
/// where its text is given too.
[[nodiscard]] Cell parseCell(const std::string& text, const std::string& path,
                             const std::optional<std::string>& arm_text = std::nullopt);

/// The sheet, or InputError that the cell has none; `purpose` continues "needed to ...".
[[nodiscard]] const tubesheets::Sheet& requireSheet(const Cell& cell, const std::string& purpose);
[[nodiscard]] const tubesheets::SteppedTool& requireTool(const Cell& cell, const std::string& purpose);

/// Throws InputError where neither the arm's file nor the scene says which way the tool points.
void requireToolAxis(const Cell& cell, const std::string& purpose);

}  // namespace tubeplan::app
