// A document's figures in other units than those of the file: in SI units, or in units chosen by a reader.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "app/formats/unit_names.hpp"

namespace tubeplan::app {

/// Joint of the arm to which figures belong whose unit is that of the joint.
struct JointInFile {
  std::string name;
  bool is_slide = false;
};

/// Units of the file in which a document's figures are stated, where the document itself does not name them.
struct FileFigures {
  std::string length = "m", angle = "rad";
  std::vector<JointInFile> joints = {};  ///< joints in the order of lists of their readings
};

/// Returns a document in which all figures with a unit (figure_units.hpp), and the names of their units, are those of
/// `target`. Text stays as it is. Figures per joint are lists in the order of the joints, or have a joint's name as
/// key.
[[nodiscard]] nlohmann::json inUnits(nlohmann::json document, const FileFigures& file, const TargetUnits& target);

/// Multiplies a number, or all numbers of nested lists, by a factor.
void scaleNumbers(nlohmann::json& value, double factor);

}  // namespace tubeplan::app
