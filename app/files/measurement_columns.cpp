#include "app/files/measurement_columns.hpp"

#include <fmt/format.h>

#include <set>

#include "app/files/input_error.hpp"
#include "app/files/suggestion.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::app {

namespace {

using deflection::JointType;

/// Takes columns out of a header one by one; what is left over at the end is unknown.
class Header {
 public:
  Header(const tubesheets::CsvTable& table, const std::string& file) : table_(table), file_(file) {}

  std::optional<std::size_t> take(const std::string& name) {
    known_.push_back(name);
    const auto index = table_.find(name);
    if (index) taken_.insert(*index);
    return index;
  }

  std::size_t takeRequired(const std::string& name) {
    if (const auto index = take(name)) return *index;
    missing(name);
  }

  /// The column quantity_UNIT with a unit of that kind.
  std::optional<NumberColumn> takeNumber(const std::string& quantity, UnitKind kind) {
    std::optional<NumberColumn> found;
    for (const std::string& unit : unitNames(kind)) {
      const std::string name = quantity + "_" + unit;
      const auto index = take(name);
      if (index && found)
        fail("both " + inQuotes(found->name) + " and " + inQuotes(name), "one of them", "remove the other");
      if (index) found = NumberColumn{*index, findUnit(kind, unit), name};
    }
    if (!found) refuseOtherUnit(quantity, kind);
    return found;
  }

  NumberColumn takeRequiredNumber(const std::string& quantity, UnitKind kind) {
    if (auto column = takeNumber(quantity, kind)) return *column;
    missing(quantity + "_" + unitNames(kind).front());
  }

  void refuseUnknown() const {
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      const std::string& name = table_.columns[i];
      if (taken_.contains(i)) continue;
      const std::string advice = suggestion(name, known_);
      fail("the unknown column " + inQuotes(name), "only the columns of a measurement table",
           advice.empty() ? "remove or rename it" : advice);
    }
  }

  [[noreturn]] void fail(const std::string& found, const std::string& expected, const std::string& advice) const {
    throw InputError(fmt::format("{}:{}", file_, table_.header_line), found, expected, advice);
  }

 private:
  [[noreturn]] void missing(const std::string& name) const {
    std::vector<std::string> left;
    for (std::size_t i = 0; i < table_.columns.size(); ++i)
      if (!taken_.contains(i)) left.push_back(table_.columns[i]);
    const std::string near = suggestion(name, left);
    fail("no column " + inQuotes(name), "one",
         near.empty() ? "add it to the header" : "is it " + near.substr(near.find('\'')));
  }

  void refuseOtherUnit(const std::string& quantity, UnitKind kind) const {
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      const std::string& name = table_.columns[i];
      if (taken_.contains(i) || !name.starts_with(quantity + "_") || name == quantity + "_dir") continue;
      fail("the column " + inQuotes(name) + " with the unknown unit " + inQuotes(name.substr(quantity.size() + 1)),
           alternatives(unitNames(kind)), "");
    }
  }

  const tubesheets::CsvTable& table_;
  const std::string& file_;
  std::set<std::size_t> taken_;
  std::vector<std::string> known_;
};

void takeJoints(Header& header, const deflection::Arm& arm, MeasurementColumns& columns) {
  for (const int row : deflection::activeRows(arm)) {
    const auto& joint = arm.rows[static_cast<std::size_t>(row)].joint;
    columns.joints.push_back(header.takeRequiredNumber(
        joint.name, joint.type == JointType::kPrismatic ? UnitKind::kLength : UnitKind::kAngle));
  }
  for (const int row : deflection::activeRows(arm))
    if (const auto approach_direction = header.take(arm.rows[static_cast<std::size_t>(row)].joint.name + "_dir"))
      columns.approach_directions.push_back(*approach_direction);
  if (!columns.approach_directions.empty() && columns.approach_directions.size() != columns.joints.size())
    header.fail(fmt::format("{} columns <joint>_dir", columns.approach_directions.size()),
                fmt::format("one for each of the {} joints, or none", columns.joints.size()), "");
}

/// What the kinds measure beside places.
void takeOwn(Header& header, MeasurementColumns& columns) {
  for (const auto& kind : calibration::measurementKinds())
    for (const auto& [name, quantity] : kind.columns) {
      if (columns.own.contains(name)) continue;
      std::optional<NumberColumn> found;
      if (quantity != deflection::Quantity::kNone)
        found = header.takeNumber(name, unitKindOf(quantity));
      else if (const auto index = header.take(name))
        found = NumberColumn{*index, nullptr, name};
      if (found) columns.own[name] = *found;
    }
}

}  // namespace

UnitKind unitKindOf(deflection::Quantity quantity) {
  return quantity == deflection::Quantity::kAngle ? UnitKind::kAngle : UnitKind::kLength;
}

MeasurementColumns findColumns(const tubesheets::CsvTable& table, const std::string& file, const deflection::Arm& arm) {
  Header header(table, file);
  MeasurementColumns columns;
  columns.id = header.takeRequired("id");
  columns.kind = header.takeRequired("kind");
  columns.point = header.take("point");
  columns.setup = header.take("setup");
  columns.split = header.take("split");
  columns.from = header.take("from");
  takeJoints(header, arm, columns);
  columns.load = header.takeNumber("load", UnitKind::kForce);
  columns.x = header.takeNumber("x", UnitKind::kLength);
  columns.y = header.takeNumber("y", UnitKind::kLength);
  columns.z = header.takeNumber("z", UnitKind::kLength);
  columns.tool_x = header.takeNumber("tool_x", UnitKind::kLength);
  columns.tool_y = header.takeNumber("tool_y", UnitKind::kLength);
  columns.tool_z = header.takeNumber("tool_z", UnitKind::kLength);
  takeOwn(header, columns);
  columns.dx = header.take("dx");
  columns.dy = header.take("dy");
  columns.dz = header.take("dz");
  columns.sigma_x = header.takeNumber("sigma_x", UnitKind::kLength);
  columns.sigma_y = header.takeNumber("sigma_y", UnitKind::kLength);
  columns.sigma_z = header.takeNumber("sigma_z", UnitKind::kLength);
  columns.sigma = header.takeNumber("sigma", UnitKind::kLength);
  columns.turn_sigma = header.takeNumber("turn_sigma", UnitKind::kAngle);
  columns.temperature = header.takeNumber("temperature", UnitKind::kTemperature);
  columns.time = header.takeNumber("time", UnitKind::kTime);
  header.refuseUnknown();
  return columns;
}

}  // namespace tubeplan::app
