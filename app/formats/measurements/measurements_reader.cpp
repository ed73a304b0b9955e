#include "app/formats/measurements/measurements_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/formats/measurements/measurement_columns.hpp"
#include "app/formats/measurements/measurement_row.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/text_file.hpp"
#include "calibration/measurement_checks/joint_limits.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/value_columns.hpp"

namespace tubeplan::app {

using calibration::Measurement;

namespace {

std::vector<calibration::NamedUnit> unitsOf(UnitKind kind) {
  std::vector<calibration::NamedUnit> units;
  for (const auto& name : unitNames(kind)) units.push_back({name, findUnit(kind, name)->factor});
  return units;
}

/// Returns the units in the names of the columns; the unit's name is empty for a quantity without a column.
calibration::MeasurementUnits unitsOf(const MeasurementColumns& columns) {
  calibration::MeasurementUnits units;
  units.coordinates.name = units.loads.name = "";
  const auto take = [](const std::optional<NumberColumn>& column, calibration::NamedUnit& unit) {
    if (column) unit = {std::string(column->unit->name), column->unit->factor};
  };
  for (const auto& [name, column] : columns.kind_columns)
    if (column.unit && column.unit->kind == UnitKind::kLength)
      units.coordinates = {std::string(column.unit->name), column.unit->factor};
  take(columns.place[0], units.coordinates);
  take(columns.load, units.loads);
  units.sigma = units.coordinates;
  take(columns.sigma, units.sigma);
  take(columns.sigma, units.sigma_column);
  take(columns.sigmas[0], units.axis_sigma_columns);
  for (const auto& joint : columns.joints) {
    units.joints.push_back({std::string(joint.unit->name), joint.unit->factor});
    if (joint.unit->kind == UnitKind::kAngle) units.angles = units.joints.back();
  }
  units.lengths = units.sigmas = unitsOf(UnitKind::kLength);
  units.sigmas.push_back({"mil", 2.54e-5});
  units.sigmas.push_back({"um", 1e-6});
  units.forces = unitsOf(UnitKind::kForce);
  units.forces.push_back({"kN", 1e3});
  units.forces.push_back({"kip", 1e3 * findUnit(UnitKind::kForce, "lbf")->factor});
  units.forces.push_back({"gf", 1e-3 * findUnit(UnitKind::kForce, "kgf")->factor});
  units.angle_units = unitsOf(UnitKind::kAngle);
  return units;
}

/// Returns the indices of the columns for measured values of a kind of measurements; empty if the table has no such
/// column.
std::vector<std::size_t> placesOfValues(const calibration::MeasurementKindRow& kind,
                                        const MeasurementColumns& columns) {
  const auto values = calibration::valueColumnsOf(kind);
  std::vector<std::size_t> places;
  if (values.has_joints)
    for (const auto& joint : columns.joints) places.push_back(joint.index);
  if (values.has_place)
    for (const auto& coordinate : columns.place)
      if (coordinate) places.push_back(coordinate->index);
  for (const auto& column : values.numbers)
    if (const auto found = columns.kind_columns.find(column.name); found != columns.kind_columns.end())
      places.push_back(found->second.index);
  return places;
}

/// Returns a phrase for the measured values of a kind of measurements: "x, y, z", "its distance", "its joints'
/// readings".
std::string valuesOf(const calibration::MeasurementKindRow& kind) {
  const auto values = calibration::valueColumnsOf(kind);
  if (values.has_joints) return "its joints' readings";
  std::vector<std::string> names;
  if (values.has_place && values.least == 1) {
    for (const auto& column : kind.columns) names.emplace_back(column.name);
    return fmt::format("its {} or x, y, z", fmt::join(names, ", "));
  }
  for (const auto& column : values.numbers) names.emplace_back(column.name);
  return fmt::format("{}{}", values.has_place ? "" : "its ", fmt::join(names, ", "));
}

/// Throws InputError if rows of a run sheet are not filled in, with one message for all of these rows.
void requireFilledIn(const tubesheets::CsvTable& table, const MeasurementColumns& columns, const std::string& file) {
  constexpr std::size_t kMostNamed = 12;
  std::vector<const tubesheets::CsvRow*> blank;
  const calibration::MeasurementKindRow* kind = nullptr;  // kind of measurement in the first blank row
  for (const auto& row : table.rows) {
    const auto* of_row = calibration::findMeasurementKind(row.fields[columns.kind]);
    if (!of_row) continue;
    const auto places = placesOfValues(*of_row, columns);
    if (places.empty()) continue;
    if (std::ranges::any_of(places, [&](std::size_t place) { return !row.fields[place].empty(); })) continue;
    if (blank.empty()) kind = of_row;
    blank.push_back(&row);
  }
  if (blank.empty()) return;
  std::vector<std::string> named, wanted;
  for (std::size_t k = 0; k < blank.size() && k < kMostNamed; ++k)
    named.push_back(fmt::format("{} in line {}", blank[k]->fields[columns.id], blank[k]->line));
  if (blank.size() > kMostNamed) named.push_back(fmt::format("{} more", blank.size() - kMostNamed));
  for (const std::size_t place : placesOfValues(*kind, columns)) wanted.push_back(table.columns[place]);
  const std::string what = fmt::format("{}", fmt::join(wanted, ", "));
  const auto values = calibration::valueColumnsOf(*kind);
  const bool is_some = !values.has_place && values.least < static_cast<int>(values.numbers.size());
  throw InputError::problem(
      fmt::format("{}:{}", file, blank.front()->line),
      blank.size() == 1 ? fmt::format("the reading of kind {} does not state {}", kind->name, valuesOf(*kind))
                        : fmt::format("{} readings are not filled in: {}", blank.size(), fmt::join(named, ", ")),
      fmt::format("fill in the measured values, {}{}, or remove {}", is_some ? "one or more of " : "", what,
                  blank.size() == 1 ? "the row" : "these rows"));
}

}  // namespace

namespace {

/// Copies a property of a surface, such as a ball's radius, from the measurement that states it to all measurements of
/// the surface. Throws InputError if two measurements state different values.
void shareGivenNumbers(std::vector<Measurement>& measurements, const std::string& file) {
  std::map<std::string, const Measurement*> stated;
  for (const auto& measurement : measurements) {
    if (!touchesSurface(measurement) || std::isnan(measurement.kind_values[0])) continue;
    const auto [first, is_new] = stated.emplace(placeOf(measurement), &measurement);
    if (!is_new && measurement.kind_values[0] != first->second->kind_values[0])
      throw InputError::problem(
          fmt::format("{}:{}", file, measurement.line),
          fmt::format("the {} of the {} differs from that in line {}", kindOf(measurement).columns.front().name,
                      placeOf(measurement), first->second->line),
          "correct the value, or give a different ball a name of its own");
  }
  for (auto& measurement : measurements)
    if (const auto found = stated.find(placeOf(measurement)); found != stated.end())
      measurement.kind_values = found->second->kind_values;
}

}  // namespace

std::vector<Measurement> readMeasurements(const std::string& path, const deflection::Arm& arm,
                                          const tubesheets::Sheet* sheet) {
  return parseMeasurements(readTextFile(path), path, arm, sheet);
}

bool isPastLimits(const Measurement& measurement, const deflection::Arm& arm) {
  for (Eigen::Index i = 0; i < arm.jointCount(); ++i)
    if (calibration::isPastLimit(arm.joint(i), measurement.q[i])) return true;
  return false;
}

namespace {

/// Returns advice to write a joint reading shifted by one turn if this brings it within the limits; otherwise empty.
std::string turnText(const deflection::Joint<double>& joint, double q, const MeasurementTable::JointColumn& column) {
  const auto back = calibration::shiftedByOneTurn(joint, q);
  return back ? fmt::format("one whole turn back the reading is {} {}, which is within the limits; write that value",
                            formatNumber(*back / column.factor), column.unit)
              : "";
}

}  // namespace

void requireWithinLimits(const MeasurementTable& table, const deflection::Arm& arm, const std::string& file,
                         const std::string& advice) {
  for (const auto& measurement : table.measurements)
    for (Eigen::Index i = 0; i < arm.jointCount(); ++i) {
      const auto& joint = arm.joint(i);
      const auto& column = table.joints[i];
      const double q = measurement.q[i];
      if (!calibration::isPastLimit(joint, q)) continue;
      throw InputError(
          fmt::format("{}:{} (column {})", file, measurement.line, column.name), formatNumber(q / column.factor),
          fmt::format("a reading between the joint's limits, {} and {} {}", formatNumber(joint.lower / column.factor),
                      formatNumber(joint.upper / column.factor), column.unit),
          advice.empty() ? turnText(joint, q, column) : advice);
    }
}

std::vector<Measurement> parseMeasurements(const std::string& text, const std::string& file, const deflection::Arm& arm,
                                           const tubesheets::Sheet* sheet) {
  auto table = parseMeasurementTable(text, file, arm, sheet);
  requireWithinLimits(table, arm, file);
  return std::move(table.measurements);
}

MeasurementTable parseMeasurementTable(const std::string& text, const std::string& file, const deflection::Arm& arm,
                                       const tubesheets::Sheet* sheet, const std::vector<Measurement>& before) {
  tubesheets::CsvTable table = tubesheets::parseCsv(text);
  if (table.problem && table.problem->advice.empty()) table.problem->advice = kReadForeign;
  if (table.problem) refuseText(file, *table.problem);
  const MeasurementColumns columns = findColumns(table, file, arm);
  if (table.rows.empty())
    throw InputError::problem(file, "there are no readings below the header", "write a row for each reading");
  requireFilledIn(table, columns, file);
  MeasurementTable read;
  read.units = unitsOf(columns);
  for (const auto& joint : columns.joints)
    read.joints.push_back({joint.name, std::string(joint.unit->name), joint.unit->factor});
  std::vector<Measurement>& out = read.measurements;
  std::map<std::string, std::size_t> index;
  for (const auto& row : table.rows) {
    const RowReader reader(table, row, file);
    out.push_back(readMeasurement(reader, columns, arm, sheet));
    const auto [first, is_new] = index.emplace(out.back().id, out.size() - 1);
    if (!is_new)
      reader.failWithProblem(
          columns.id, fmt::format("line {} already has the id {}", out[first->second].line, inQuotes(out.back().id)),
          "give each reading an id of its own");
  }
  shareGivenNumbers(out, file);
  std::map<std::string, const Measurement*> known;
  for (const auto* measurements : {&before, static_cast<const std::vector<Measurement>*>(&out)})
    for (const auto& measurement : *measurements) known[measurement.id] = &measurement;
  for (std::size_t k = 0; k < out.size(); ++k)
    if (kindOf(out[k]).is_from_measurement)
      out[k].reference = readReference(RowReader(table, table.rows[k], file), columns, known, out[k]);
  return read;
}

}  // namespace tubeplan::app
