// A command's figures in SI units: m, rad, N and s in place of the units of the file.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tubeplan::app {

/// Unit in terms of the SI: 1 of `name` in the file is `factor` of `si`.
struct SiUnit {
  std::string si;
  double factor = 1;
};

/// Returns the SI unit for the name of a unit of files, such as "lbf*in/deg" or "1/(lbf*in)": N*m/rad, with the factor.
/// Temperatures alone keep the file's unit, because a figure may be a difference. std::nullopt for
/// names that are not products of units, such as "percent".
[[nodiscard]] std::optional<SiUnit> siUnitOf(std::string_view name);

/// Joint of the arm to which figures belong whose unit is that of the joint.
struct JointInFile {
  std::string name;
  bool is_slide = false;
};

/// Returns a document in which all figures with a unit (figure_units.hpp), and the names of their units, are those of
/// the SI. Text stays as it is. Figures per joint are lists in the order of `joints`, or have a joint's name as key.
[[nodiscard]] nlohmann::json inSiUnits(const nlohmann::json& document, std::span<const JointInFile> joints);

}  // namespace tubeplan::app
