#include "app/formats/measurements/measurement_row.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "app/formats/foreign/sexagesimal.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::app {

using calibration::Measurement;
using calibration::MeasurementKindRow;

namespace {

const MeasurementKindRow& readKind(const RowReader& row, const MeasurementColumns& columns) {
  if (const auto* kind = calibration::findMeasurementKind(row.field(columns.kind))) return *kind;
  const auto names = calibration::measurementKindNames();
  row.fail(columns.kind, "the kind " + inQuotes(row.field(columns.kind)), alternatives(names),
           suggestion(row.field(columns.kind), names));
}

Eigen::VectorXd readJoints(const RowReader& row, const std::vector<NumberColumn>& columns) {
  Eigen::VectorXd q(static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) q[static_cast<Eigen::Index>(i)] = row.number(columns[i]);
  return q;
}

/// Returns three numbers of a row that must be given together; std::nullopt if all three are missing.
std::optional<Eigen::Vector3d> readTriple(const RowReader& row, const ColumnTriple& columns, const char* names) {
  const Eigen::Vector3d numbers(row.numberOrNaN(columns[0]), row.numberOrNaN(columns[1]), row.numberOrNaN(columns[2]));
  const auto missing = numbers.array().isNaN().count();
  if (missing == 3) return std::nullopt;
  if (missing > 0) row.failRow(fmt::format("only some of the {} are given", names), "give all three or none");
  return numbers;
}

std::optional<calibration::TipWrench> readWrench(const RowReader& row, const MeasurementColumns& columns) {
  const auto force = readTriple(row, columns.force, "forces force_x, force_y, force_z");
  const auto moment = readTriple(row, columns.moment, "moments moment_x, moment_y, moment_z");
  if (!force && !moment) return std::nullopt;
  return calibration::TipWrench{force.value_or(Eigen::Vector3d::Zero()), moment.value_or(Eigen::Vector3d::Zero())};
}

/// Returns the separate standard deviations of x, y and z; std::nullopt if the row states none. Throws InputError for
/// kinds of measurements that do not measure coordinates.
std::optional<Eigen::Vector3d> readSigmas(const RowReader& row, const MeasurementColumns& columns,
                                          const MeasurementKindRow& kind) {
  const auto sigmas = readTriple(row, columns.sigmas, "coordinates' sigma_x, sigma_y, sigma_z");
  if (!sigmas) return std::nullopt;
  if (!(sigmas->minCoeff() > 0))
    row.failRow("a sigma of x, y or z is not above zero", "write one standard deviation of the coordinate");
  if (!kind.has_coordinates)
    row.failRow(fmt::format("a reading of kind {} has no sigma_x, sigma_y, sigma_z: this kind does not measure x, y, z",
                            kind.name),
                "write a single `sigma` instead");
  return sigmas;
}

/// Returns the correlations between the errors of x, y and z, which require separate standard deviations; std::nullopt
/// if the row states no correlations.
std::optional<Eigen::Vector3d> readCorrelations(const RowReader& row, const MeasurementColumns& columns,
                                                const std::optional<Eigen::Vector3d>& sigmas) {
  const auto correlations = readTriple(row, columns.correlations, "correlations rho_xy, rho_xz, rho_yz");
  if (!correlations) return std::nullopt;
  if (!sigmas)
    row.failRow("the correlations rho_xy, rho_xz, rho_yz need sigma_x, sigma_y, sigma_z",
                "add those columns, or leave the correlations out");
  for (std::size_t k = 0; k < 3; ++k)
    if (!(std::abs((*correlations)[static_cast<Eigen::Index>(k)]) < 1))
      row.fail(columns.correlations[k]->index, row.field(columns.correlations[k]->index),
               "a correlation above -1 and below 1", "to convert a covariance, divide it by both standard deviations");
  if (!calibration::isPossibleCorrelation(*correlations))
    row.failRow("the correlations rho_xy, rho_xz, rho_yz do not form a positive definite matrix",
                "check their order and signs, or write them with more digits");
  return correlations;
}

std::optional<Eigen::Vector3d> directionOfRow(const RowReader& row, const MeasurementColumns& columns) {
  const auto direction = readTriple(row, columns.direction, "direction's dx, dy, dz");
  if (!direction) return std::nullopt;
  if (!(direction->norm() > 0)) row.failRow("the direction dx, dy, dz is zero", "write a direction that is not zero");
  return direction->normalized();
}

/// Returns the index of the arm's row whose frame was measured, from the row's name; std::nullopt for the tool.
std::optional<int> readRowOfArm(const RowReader& row, const MeasurementColumns& columns, const MeasurementKindRow& kind,
                                const deflection::Arm& arm) {
  const std::string name = row.textOr(columns.row);
  if (name.empty()) return std::nullopt;
  if (!kind.may_be_of_row)
    row.failWithProblem(
        *columns.row,
        fmt::format("a reading of kind {} cannot be of row {}: only readings of kind {} can name a row of the arm",
                    kind.name, inQuotes(name), fmt::join(calibration::kindNamesOfRows(), ", ")),
        "leave the field empty");
  if (const auto found = deflection::findRow(arm, name)) return found;
  const auto names = deflection::rowNames(arm);
  row.fail(*columns.row, "the unknown row " + inQuotes(name), alternatives(names) + ", or nothing for the tool",
           suggestion(name, names));
}

std::vector<int> readApproachDirections(const RowReader& row, const MeasurementColumns& columns) {
  std::vector<int> approach_directions;
  for (const std::size_t column : columns.approach_directions) {
    const auto approach_direction = tubesheets::parseInteger(row.field(column));
    if (!approach_direction || *approach_direction < -1 || *approach_direction > 1)
      row.fail(column, inQuotes(row.field(column)), "-1, 0 or 1");
    approach_directions.push_back(*approach_direction);
  }
  return approach_directions;
}

deflection::ConditionValues readConditions(const RowReader& row, const MeasurementColumns& columns) {
  deflection::ConditionValues values;
  for (const auto& kind : deflection::kConditionKinds) {
    double& value = values[kind.condition];
    value = row.numberOrNaN(columns.conditions[kind.condition]);
    if (value < kind.least)
      row.failRow(fmt::format("the {} is below {}", kind.name, kind.least_words),
                  fmt::format("write the reading's {} in the column's unit", kind.name));
  }
  return values;
}

bool readSplit(const RowReader& row, const std::optional<std::size_t>& column) {
  if (!column || row.field(*column) == "fit" || row.field(*column).empty()) return false;
  if (row.field(*column) != "held-out") row.fail(*column, inQuotes(row.field(*column)), "fit or held-out");
  return true;
}

// Returns the centre of a hole in the world frame, which is the sheet's frame; std::nullopt if the sheet or a hole's
// name is missing.
std::optional<Eigen::Vector3d> holeCentre(const RowReader& row, const MeasurementColumns& columns,
                                          const std::string& point, const tubesheets::Sheet* sheet) {
  const auto name = tubesheets::parseTubeName(point);
  if (!sheet || !name) return std::nullopt;
  const tubesheets::Tube* tube = sheet->find(name->row, name->column);
  if (!tube)
    row.fail(*columns.point, "the hole " + inQuotes(point),
             fmt::format("a hole of the sheet: rows 1 to {}, columns 1 to {}", sheet->rows, sheet->columns));
  return Eigen::Vector3d(tube->x, tube->y, 0);
}

/// Returns the name of a column with all units that it may have: "distance_in (or _mm, _cm, _m, _ft)".
std::string columnText(const calibration::MeasuredColumn& column) {
  if (column.quantity == deflection::Quantity::kNone) return column.name;
  const auto units = unitNames(unitKindOf(column.quantity));
  std::vector<std::string> others(units.begin() + 1, units.end());
  return fmt::format("{}_{} (or _{})", column.name, units.front(), fmt::join(others, ", _"));
}

Eigen::Vector3d readKindValues(const RowReader& row, const MeasurementColumns& columns,
                               const MeasurementKindRow& kind) {
  Eigen::Vector3d kind_values = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < kind.columns.size(); ++k)
    if (const auto column = columns.kind_columns.find(kind.columns[k].name); column != columns.kind_columns.end())
      kind_values[static_cast<Eigen::Index>(k)] = row.numberOrNaN(std::optional(column->second));
  return kind_values;
}

/// Throws InputError if measured values of the measurement's kind are missing: some kinds require one value, others
/// all.
void checkOwn(const RowReader& row, const MeasurementKindRow& kind, const Measurement& m) {
  if (calibration::statesEnough(m)) return;
  const std::size_t count = kind.columns.size();
  std::vector<std::string> names, columns;
  for (const auto& column : kind.columns) names.emplace_back(column.name), columns.push_back(columnText(column));
  row.failRow(fmt::format("the reading of kind {} has no {}", kind.name, fmt::join(names, ", ")),
              fmt::format("write {}number{} in the column{} {}", count > 1 ? "" : "a ",
                          kind.is_possible && count == 1 ? " above zero"
                          : count > 1                    ? "s"
                                                         : "",
                          count > 1 ? "s" : "", fmt::join(columns, ", ")));
}

void checkKind(const RowReader& row, const MeasurementKindRow& kind, const Measurement& m) {
  if (const auto lack = kind.lack ? kind.lack(m, kind.name) : std::nullopt) row.failRow(lack->what, lack->advice);
  checkOwn(row, kind, m);
  if (m.p_TQ && calibration::isDisplacement(m))
    row.failRow(
        fmt::format("a reading of kind {} is of the tip itself, so tool_x, tool_y, tool_z do not apply", kind.name),
        "leave these columns empty");
  if (m.p_TQ && m.row)
    row.failRow("the reading has both a row of the arm and a point of the tool (tool_x, tool_y, tool_z)",
                "leave one of them empty");
  if (m.sigma <= 0) row.failRow("the sigma is not above zero", "write one standard deviation of a coordinate");
  if (m.turn_sigma <= 0) row.failRow("the turn_sigma is not above zero", "write one standard deviation of an angle");
  if (m.load < 0) row.failRow("the load is negative", "write a load of zero or more");
}

}  // namespace

double RowReader::number(std::size_t index) const {
  constexpr double kMost = 1e30;  // limit of all quantities; the sum of their squares is still finite
  const auto value = tubesheets::parseNumber(field(index));
  if (!value)
    fail(index, field(index).empty() ? "nothing" : inQuotes(field(index)), "a finite number",
         parseSexagesimal(field(index)) ? kReadForeign : "");
  if (std::abs(*value) > kMost) fail(index, inQuotes(field(index)), fmt::format("a number within {:g} of zero", kMost));
  return *value;
}

double RowReader::number(const NumberColumn& column) const {
  const double value = number(column.index);
  return column.unit ? (value + column.unit->offset) * column.unit->factor : value;
}

double RowReader::numberOrNaN(const std::optional<NumberColumn>& column) const {
  return column && !field(column->index).empty() ? number(*column) : std::numeric_limits<double>::quiet_NaN();
}

void RowReader::fail(std::size_t column, const std::string& found, const std::string& expected,
                     const std::string& advice) const {
  throw InputError(fmt::format("{}:{} (column {})", file_, row_.line, table_.columns[column]), found, expected, advice);
}

void RowReader::failWithProblem(std::size_t column, const std::string& what, const std::string& advice) const {
  throw InputError::problem(fmt::format("{}:{} (column {})", file_, row_.line, table_.columns[column]), what, advice);
}

void RowReader::failRow(const std::string& what, const std::string& advice) const {
  throw InputError::problem(fmt::format("{}:{}", file_, row_.line), what, advice);
}

Measurement readMeasurement(const RowReader& row, const MeasurementColumns& columns, const deflection::Arm& arm,
                            const tubesheets::Sheet* sheet) {
  Measurement m;
  const MeasurementKindRow& kind = readKind(row, columns);
  m.line = row.line();
  m.kind = kind.kind;
  m.id = row.field(columns.id);
  if (m.id.empty()) row.fail(columns.id, "nothing", "a name for the reading");
  m.point = row.textOr(columns.point);
  m.setup = row.textOr(columns.setup);
  m.load = columns.load ? row.number(*columns.load) : 0;
  m.wrench = readWrench(row, columns);
  m.q = readJoints(row, columns.joints);
  m.side_q = readJoints(row, columns.side_joints);
  m.p_W = readTriple(row, columns.place, "coordinates x, y, z");
  if (!m.p_W && kind.names_hole) m.p_W = holeCentre(row, columns, m.point, sheet);
  if (!m.p_W && kind.is_from_origin) m.p_W = Eigen::Vector3d::Zero();
  m.kind_values = readKindValues(row, columns, kind);
  m.row = readRowOfArm(row, columns, kind, arm);
  m.p_TQ = readTriple(row, columns.tool_point, "measured point's tool_x, tool_y, tool_z");
  m.direction_W = kind.is_to_gravity ? std::optional<Eigen::Vector3d>(-arm.gravity_W) : directionOfRow(row, columns);
  m.sigma = row.numberOrNaN(columns.sigma);
  m.sigma_W = readSigmas(row, columns, kind);
  m.correlation_W = readCorrelations(row, columns, m.sigma_W);
  if (m.sigma_W) m.sigma = calibration::meanSigma(*m.sigma_W);
  m.turn_sigma = row.numberOrNaN(columns.turn_sigma);
  m.approach_directions = readApproachDirections(row, columns);
  m.conditions = readConditions(row, columns);
  m.is_held_out = readSplit(row, columns.split);
  checkKind(row, kind, m);
  return m;
}

std::shared_ptr<const Measurement> readReference(const RowReader& row, const MeasurementColumns& columns,
                                                 const std::map<std::string, const Measurement*>& known,
                                                 const Measurement& m) {
  const std::string id = row.textOr(columns.from);
  if (id.empty())
    row.failRow("the reading of kind relative does not name the reading that it is relative to",
                "write the id of that reading in the column 'from'");
  const auto found = known.find(id);
  if (found == known.end() || id == m.id)
    row.fail(*columns.from, id == m.id ? "the reading's own id" : "the unknown id " + inQuotes(id),
             "the id of another reading");
  const Measurement& other = *found->second;
  if (other.setup != m.setup)
    row.failWithProblem(*columns.from, fmt::format("the reading {} is of another set-up", inQuotes(id)),
                        "name a reading of the same set-up");
  auto reference = std::make_shared<Measurement>(other);
  reference->reference = nullptr;
  return reference;
}

}  // namespace tubeplan::app
