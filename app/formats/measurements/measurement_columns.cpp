#include "app/formats/measurements/measurement_columns.hpp"

#include <fmt/format.h>

#include <set>

#include "app/formats/arm/joint_units.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "deflection/side_chains.hpp"

namespace tubeplan::app {

namespace {

/// Header of a table, from which known columns are taken by name; columns that are never taken are unknown.
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

  /// Takes the column `quantity_UNIT`, where UNIT is any unit of the given kind; std::nullopt if there is no such
  /// column.
  std::optional<NumberColumn> takeNumber(const std::string& quantity, UnitKind kind) {
    std::optional<NumberColumn> found;
    for (const std::string& unit : unitNames(kind)) {
      const std::string name = quantity + "_" + unit;
      const auto index = take(name);
      if (index && found)
        failWithProblem(fmt::format("the header has both columns {} and {}", inQuotes(found->name), inQuotes(name)),
                        "remove one of them");
      if (index) found = NumberColumn{*index, findUnit(kind, unit), name};
    }
    if (!found) refuseOtherUnit(quantity, kind);
    return found;
  }

  NumberColumn takeRequiredNumber(const std::string& quantity, UnitKind kind) {
    if (auto column = takeNumber(quantity, kind)) return *column;
    missing(quantity + "_" + unitNames(kind).front());
  }

  ColumnTriple takeThree(const std::array<const char*, 3>& names, UnitKind kind) {
    ColumnTriple columns;
    for (std::size_t i = 0; i < 3; ++i) columns[i] = takeNumber(names[i], kind);
    return columns;
  }

  std::optional<NumberColumn> takePlain(const std::string& name) {
    const auto index = take(name);
    return index ? std::optional(NumberColumn{*index, nullptr, name}) : std::nullopt;
  }

  void refuseUnknown() const {
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      const std::string& name = table_.columns[i];
      if (taken_.contains(i)) continue;
      const std::string advice = suggestion(name, known_);
      failWithProblem("a measurement table has no column " + inQuotes(name),
                      advice.empty() ? "remove or rename it" : advice);
    }
  }

  [[noreturn]] void fail(const std::string& found, const std::string& expected, const std::string& advice) const {
    throw InputError(fmt::format("{}:{}", file_, table_.header_line), found, expected, advice);
  }

  [[noreturn]] void failWithProblem(const std::string& what, const std::string& advice) const {
    throw InputError::problem(fmt::format("{}:{}", file_, table_.header_line), what, advice);
  }

 private:
  [[noreturn]] void missing(const std::string& name) const {
    std::vector<std::string> unused;
    for (std::size_t i = 0; i < table_.columns.size(); ++i)
      if (!taken_.contains(i)) unused.push_back(table_.columns[i]);
    const std::string near = suggestion(name, unused);
    failWithProblem("there is no column " + inQuotes(name),
                    near.empty() ? std::string("add it to the header, or ") + kReadForeign
                                 : "did you mean the column " + near.substr(near.find('\'')) + " If so, rename it");
  }

  void refuseOtherUnit(const std::string& quantity, UnitKind kind) const {
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      const std::string& name = table_.columns[i];
      if (taken_.contains(i) || !name.starts_with(quantity + "_") || name == quantity + "_dir") continue;
      fail(fmt::format("the unknown unit {} of the column {}", inQuotes(name.substr(quantity.size() + 1)),
                       inQuotes(name)),
           alternatives(unitNames(kind)), "");
    }
  }

  const tubesheets::CsvTable& table_;
  const std::string& file_;
  std::set<std::size_t> taken_;
  std::vector<std::string> known_;
};

NumberColumn takeJoint(Header& header, const deflection::Joint<double>& joint) {
  return header.takeRequiredNumber(jointColumnName(joint), unitKindOf(joint));
}

void takeJoints(Header& header, const deflection::Arm& arm, MeasurementColumns& columns) {
  for (const auto& joint : arm.joints()) columns.joints.push_back(takeJoint(header, joint));
  for (const auto* joint : deflection::sideJoints(arm)) columns.side_joints.push_back(takeJoint(header, *joint));
  for (const auto& joint : arm.joints())  // near_ columns are allowed in a filled-in run sheet, but not used
    (void)header.takeNumber(kNearPrefix + jointColumnName(joint), unitKindOf(joint));
  for (const auto& joint : arm.joints())
    if (const auto approach_direction = header.take(jointColumnName(joint) + "_dir"))
      columns.approach_directions.push_back(*approach_direction);
  if (!columns.approach_directions.empty() && columns.approach_directions.size() != columns.joints.size())
    header.fail(fmt::format("{} columns <joint>_dir", columns.approach_directions.size()),
                fmt::format("one for each of the {} joints, or none", columns.joints.size()), "");
}

/// Takes the columns of quantities that belong to particular kinds of measurements.
void takeOwn(Header& header, MeasurementColumns& columns) {
  for (const auto& kind : calibration::measurementKinds())
    for (const auto& [name, quantity] : kind.columns) {
      if (columns.kind_columns.contains(name)) continue;
      const auto found = quantity == deflection::Quantity::kNone ? header.takePlain(name)
                                                                 : header.takeNumber(name, unitKindOf(quantity));
      if (found) columns.kind_columns[name] = *found;
    }
}

}  // namespace

UnitKind unitKindOf(deflection::Quantity quantity) {
  switch (quantity) {
    case deflection::Quantity::kAngle:
      return UnitKind::kAngle;
    case deflection::Quantity::kForce:
      return UnitKind::kForce;
    case deflection::Quantity::kTorque:
      return UnitKind::kTorque;
    case deflection::Quantity::kTemperature:
      return UnitKind::kTemperature;
    case deflection::Quantity::kTime:
      return UnitKind::kTime;
    default:
      return UnitKind::kLength;
  }
}

UnitKind unitKindOf(const deflection::Joint<double>& joint) {
  return joint.type == deflection::JointType::kPrismatic ? UnitKind::kLength : UnitKind::kAngle;
}

std::string conditionColumn(const deflection::ConditionKind& kind, const Units& units) {
  const std::string unit = units.nameOf(kind.unit);
  return unit.empty() ? kind.name : fmt::format("{}_{}", kind.name, unit);
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
  columns.row = header.take("row");
  takeJoints(header, arm, columns);
  columns.load = header.takeNumber("load", UnitKind::kForce);
  columns.force = header.takeThree({"force_x", "force_y", "force_z"}, UnitKind::kForce);
  columns.moment = header.takeThree({"moment_x", "moment_y", "moment_z"}, UnitKind::kTorque);
  columns.place = header.takeThree({"x", "y", "z"}, UnitKind::kLength);
  columns.tool_point = header.takeThree({"tool_x", "tool_y", "tool_z"}, UnitKind::kLength);
  takeOwn(header, columns);
  columns.direction = {header.takePlain("dx"), header.takePlain("dy"), header.takePlain("dz")};
  columns.sigmas = header.takeThree({"sigma_x", "sigma_y", "sigma_z"}, UnitKind::kLength);
  columns.correlations = {header.takePlain("rho_xy"), header.takePlain("rho_xz"), header.takePlain("rho_yz")};
  columns.sigma = header.takeNumber("sigma", UnitKind::kLength);
  columns.turn_sigma = header.takeNumber("turn_sigma", UnitKind::kAngle);
  for (const auto& kind : deflection::kConditionKinds)
    columns.conditions[kind.condition] = kind.unit.quantity == deflection::Quantity::kNone
                                             ? header.takePlain(conditionColumn(kind, Units()))
                                             : header.takeNumber(kind.name, unitKindOf(kind.unit.quantity));
  header.refuseUnknown();
  return columns;
}

}  // namespace tubeplan::app
