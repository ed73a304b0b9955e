#include "app/formats/arm/controller_calibration.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <sstream>

#include "app/formats/arm/arm_numbers.hpp"
#include "app/formats/arm/arm_reader.hpp"
#include "app/formats/yaml/yaml_edit.hpp"
#include "app/storage/input_error.hpp"
#include "deflection/row_conventions.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using CalibrationRow = deflection::DenavitHartenberg<double>;

/// List of corrections in calibration.conf, with the parameter of the arm's rows that the list corrects.
struct DeltaList {
  const char* key;
  const char* number;
  std::vector<double> ControllerCalibration::*values;
  double CalibrationRow::*of_row;
  Dimension unit;
};

const std::array<DeltaList, 4>& deltaLists() {
  static const std::array<DeltaList, 4> kLists{
      {{"delta_theta", "theta", &ControllerCalibration::theta, &CalibrationRow::theta, dimension::kAngle},
       {"delta_a", "a", &ControllerCalibration::a, &CalibrationRow::a, dimension::kLength},
       {"delta_d", "d", &ControllerCalibration::d, &CalibrationRow::d, dimension::kLength},
       {"delta_alpha", "alpha", &ControllerCalibration::alpha, &CalibrationRow::alpha, dimension::kAngle}}};
  return kLists;
}

std::string withoutBlanks(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

struct Entry {
  std::string value;
  int line = 0;
};

/// Returns the entries `key = value` of one section, keyed by name; a list in brackets may continue over several lines.
std::map<std::string, Entry> entriesOf(std::string_view text, std::string_view section) {
  std::map<std::string, Entry> entries;
  std::istringstream lines{std::string(text)};
  std::string line, now, key;
  for (int number = 1; std::getline(lines, line); ++number) {
    line = withoutBlanks(line.substr(0, line.find('#')));
    const bool is_open = !key.empty() && entries[key].value.starts_with('[') && !entries[key].value.ends_with(']');
    if (is_open) {
      entries[key].value += line;
      continue;
    }
    if (line.starts_with('[') && line.ends_with(']')) now = line.substr(1, line.size() - 2);
    const auto equals = line.find('=');
    if (now != section || equals == std::string::npos) continue;
    key = withoutBlanks(line.substr(0, equals));
    entries[key] = {withoutBlanks(line.substr(equals + 1)), number};
  }
  return entries;
}

std::vector<double> numbersIn(const Entry& entry, const std::string& where) {
  const std::string& text = entry.value;
  const auto refuse = [&](const std::string& found) {
    throw InputError(where, inQuotes(found), "a list of numbers, [ ... ], one for each joint",
                     "copy the file from the controller again");
  };
  if (!text.starts_with('[') || !text.ends_with(']')) refuse(text);
  std::vector<double> numbers;
  std::istringstream fields(text.substr(1, text.size() - 2));
  for (std::string field; std::getline(fields, field, ',');) {
    const auto number = tubesheets::parseNumber(withoutBlanks(field));
    if (!number) refuse(withoutBlanks(field));
    numbers.push_back(*number);
  }
  if (numbers.empty()) refuse(text);
  return numbers;
}

/// Adds a remark if the calibration has a status other than 2 ("in use").
void addStatus(const std::map<std::string, Entry>& entries, ControllerCalibration& calibration) {
  const auto status = entries.find("calibration_status");
  if (status == entries.end() || status->second.value == "2") return;
  calibration.remarks.push_back(fmt::format(
      "calibration_status is {}, not 2: the controller itself may not use these numbers", status->second.value));
}

}  // namespace

ControllerCalibration parseControllerCalibration(std::string_view text, const std::string& path) {
  const auto entries = entriesOf(text, "mounting");
  ControllerCalibration calibration;
  for (const DeltaList& list : deltaLists()) {
    const auto entry = entries.find(list.key);
    if (entry == entries.end())
      throw InputError::problem(
          path,
          fmt::format("there is no {} in [mounting], where delta_theta, delta_a, delta_d and delta_alpha are expected",
                      list.key),
          "use calibration.conf from the folder .urcontrol of the controller");
    const std::string where = fmt::format("{}:{}: {}", path, entry->second.line, list.key);
    const auto numbers = numbersIn(entry->second, where);
    if (!calibration.theta.empty() && numbers.size() != calibration.theta.size())
      throw InputError(where, fmt::format("{} numbers", numbers.size()),
                       fmt::format("{}, the same number as in delta_theta", calibration.theta.size()));
    calibration.*list.values = numbers;
  }
  addStatus(entries, calibration);
  return calibration;
}

std::string withControllerCalibration(const YamlFile& nominal, const ControllerCalibration& calibration) {
  const ArmSource source = readArm(nominal.root);
  const auto& rows = source.arm.rows;
  if (!deflection::isStandard(rows))
    throw InputError::problem(
        nominal.path,
        "the rows do not use the standard Denavit-Hartenberg convention, to which the controller's corrections apply",
        "write the maker's standard Denavit-Hartenberg table: `convention: standard`, with `dh` for each link");
  const auto active = deflection::activeRows(source.arm);
  if (active.size() != calibration.theta.size())
    throw InputError(
        nominal.path, fmt::format("{} joints", active.size()),
        fmt::format("{}, one for each number of a list in the controller's file", calibration.theta.size()));
  std::string text = nominal.text;
  for (std::size_t joint = 0; joint < active.size(); ++joint) {
    const auto row = static_cast<std::size_t>(active[joint]);
    if (rows[row].joint.type != deflection::JointType::kRevolute || !rows[row].placed_by)
      throw InputError::problem(
          nominal.path,
          fmt::format("the row {} does not have both `dh` and a revolute joint", inQuotes(rows[row].name)),
          "write every row with both");
    const CalibrationRow numbers = deflection::standardNumbers(rows, row);
    for (const DeltaList& list : deltaLists()) {
      const double value = numbers.*list.of_row + (calibration.*list.values)[joint];
      text = withYamlValue(text, armPath(nominal.root, rows[row].name + ".dh." + list.number),
                           formatNumber(source.units.toFile(value, list.unit)));
    }
  }
  return text;
}

}  // namespace tubeplan::app
