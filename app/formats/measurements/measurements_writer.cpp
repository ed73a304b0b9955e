#include "app/formats/measurements/measurements_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "app/formats/arm/joint_units.hpp"
#include "app/formats/measurements/measurement_columns.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/value_columns.hpp"
#include "deflection/side_chains.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using calibration::Measurement, calibration::MeasuredColumn, calibration::ProposedMeasurement;

/// Column of the written table: a name, and a function that returns the field of a measurement.
struct Column {
  std::string name;
  std::function<std::string(const Measurement&)> field;
};

std::string numberOrNothing(double value) { return std::isnan(value) ? "" : formatNumber(value); }

template <class Has>
bool anyHas(const std::vector<Measurement>& measurements, Has has) {
  return std::any_of(measurements.begin(), measurements.end(), has);
}

constexpr std::array<const char*, 3> kCorrelationColumns{"rho_xy", "rho_xz", "rho_yz"};
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

std::string columnName(const MeasuredColumn& column, const Units& units) {
  if (column.quantity == deflection::Quantity::kNone) return column.name;
  return fmt::format("{}_{}", column.name, units.nameOf(dimensionOf(column.quantity)));
}

/// Returns true if the measured values of a measurement are its joint readings.
bool isMeasuredByJoints(const Measurement& measurement) {
  return calibration::valueColumnsOf(calibration::kindOf(measurement)).has_joints;
}

/// Kind of table: completed measurements, or a run sheet of measurements to be made.
enum class TableOf { kMeasurements, kRunSheet };

class Table {
 public:
  Table(const std::vector<Measurement>& measurements, const deflection::Arm& arm, const Units& units,
        TableOf of = TableOf::kMeasurements)
      : measurements_(measurements),
        arm_(arm),
        units_(units),
        is_sheet_(of == TableOf::kRunSheet),
        side_joints_(deflection::sideJoints(arm)) {}

  std::string text() {
    addNames();
    addJoints();
    addNear();
    addCoordinates();
    if (anyHas(measurements_, [](const auto& m) { return referenceOf(m) != nullptr; }))
      add("from", [](const auto& m) {
        const Measurement* from = referenceOf(m);
        return from ? tubesheets::csvField(from->id) : std::string();
      });
    if (anyHas(measurements_, [](const auto& m) { return m.row.has_value(); }))
      add("row", [this](const auto& m) {
        return m.row ? tubesheets::csvField(arm_.rows.at(static_cast<std::size_t>(*m.row)).name) : std::string();
      });
    addConditions();
    std::vector<std::string> names;
    for (const Column& column : columns_) names.push_back(tubesheets::csvField(column.name));
    std::string text = fmt::format("{}\n", fmt::join(names, ","));
    for (const Measurement& measurement : measurements_) {
      std::vector<std::string> fields;
      for (const Column& column : columns_) fields.push_back(column.field(measurement));
      text += fmt::format("{}\n", fmt::join(fields, ","));
    }
    return text;
  }

 private:
  void add(const std::string& name, std::function<std::string(const Measurement&)> field) {
    columns_.push_back({name, std::move(field)});
  }

  void addNames() {
    add("id", [](const auto& m) { return tubesheets::csvField(m.id); });
    add("kind", [](const auto& m) { return std::string(calibration::kindOf(m).name); });
    add("point", [](const auto& m) { return tubesheets::csvField(m.point); });
    if (anyHas(measurements_, [](const auto& m) { return !m.setup.empty(); }))
      add("setup", [](const auto& m) { return tubesheets::csvField(m.setup); });
  }

  void addJoints() {
    add("load_" + std::string(units_.force().name),
        [this](const auto& m) { return formatNumber(units_.toFile(m.load, dimension::kForce)); });
    if (anyHas(measurements_, [](const auto& m) { return m.wrench.has_value(); })) addWrench();
    for (Eigen::Index k = 0; k < arm_.jointCount(); ++k)
      add(jointColumn(arm_.joint(k), units_), [this, k](const auto& m) { return isBlank(m) ? "" : jointField(m, k); });
    for (std::size_t k = 0; k < side_joints_.size(); ++k)
      add(jointColumn(*side_joints_[k], units_), [this, k](const auto& m) {
        const auto at = static_cast<Eigen::Index>(k);
        return at < m.side_q.size() ? formatNumber(units_.toFile(m.side_q[at], jointDimension(*side_joints_[k]))) : "";
      });
  }

  /// Returns true for a measurement of a run sheet whose joint readings are still to be measured.
  [[nodiscard]] bool isBlank(const Measurement& m) const { return is_sheet_ && isMeasuredByJoints(m); }

  [[nodiscard]] std::string jointField(const Measurement& m, Eigen::Index k) const {
    return formatNumber(units_.toFile(m.q[k], jointDimension(arm_.joint(k))));
  }

  void addNear() {
    if (!anyHas(measurements_, [this](const auto& m) { return isBlank(m); })) return;
    for (Eigen::Index k = 0; k < arm_.jointCount(); ++k)
      add(kNearPrefix + jointColumn(arm_.joint(k), units_),
          [this, k](const auto& m) { return isBlank(m) ? jointField(m, k) : ""; });
  }

  void addWrench() {
    const std::string force(units_.force().name), torque = force + std::string(units_.length().name);
    for (Eigen::Index k = 0; k < 3; ++k)
      add(fmt::format("force_{}_{}", "xyz"[k], force), [this, k](const auto& m) {
        return numberOrNothing(m.wrench ? units_.toFile(m.wrench->force_W[k], dimension::kForce) : kNothing);
      });
    if (!anyHas(measurements_, [](const auto& m) { return m.wrench && !m.wrench->moment_W.isZero(0); })) return;
    for (Eigen::Index k = 0; k < 3; ++k)
      add(fmt::format("moment_{}_{}", "xyz"[k], torque), [this, k](const auto& m) {
        return numberOrNothing(m.wrench ? units_.toFile(m.wrench->moment_W[k], dimension::kTorque) : kNothing);
      });
  }

  void addLength(const std::string& quantity, std::function<double(const Measurement&)> metres) {
    add(quantity + "_" + std::string(units_.length().name), [this, metres = std::move(metres)](const Measurement& m) {
      return numberOrNothing(units_.toFile(metres(m), dimension::kLength));
    });
  }

  void addCoordinates() {
    addLength("x", [](const auto& m) { return m.p_W ? m.p_W->x() : kNothing; });
    addLength("y", [](const auto& m) { return m.p_W ? m.p_W->y() : kNothing; });
    addLength("z", [](const auto& m) { return m.p_W ? m.p_W->z() : kNothing; });
    addOwn();
    if (anyHas(measurements_, [](const auto& m) { return m.p_TQ.has_value(); }))
      for (Eigen::Index k = 0; k < 3; ++k)
        addLength(std::string("tool_") + "xyz"[k], [k](const auto& m) { return m.p_TQ ? (*m.p_TQ)[k] : kNothing; });
    if (anyHas(measurements_, [](const auto& m) { return calibration::kindOf(m).has_direction; }))
      for (Eigen::Index k = 0; k < 3; ++k)
        add(std::string("d") + "xyz"[k], [k](const auto& m) {
          return numberOrNothing(calibration::kindOf(m).has_direction ? (*m.direction_W)[k] : kNothing);
        });
    addLength("sigma", [](const auto& m) { return m.sigma; });
    if (anyHas(measurements_, [](const auto& m) { return m.sigma_W.has_value(); }))
      for (Eigen::Index k = 0; k < 3; ++k)
        addLength(std::string("sigma_") + "xyz"[k],
                  [k](const auto& m) { return m.sigma_W ? (*m.sigma_W)[k] : kNothing; });
    if (anyHas(measurements_, [](const auto& m) { return m.correlation_W.has_value(); }))
      for (Eigen::Index k = 0; k < 3; ++k)
        add(kCorrelationColumns[static_cast<std::size_t>(k)],
            [k](const auto& m) { return numberOrNothing(m.correlation_W ? (*m.correlation_W)[k] : kNothing); });
    if (anyHas(measurements_, [](const auto& m) { return !std::isnan(m.turn_sigma); }))
      add("turn_sigma_" + std::string(units_.angle().name),
          [this](const auto& m) { return numberOrNothing(units_.toFile(m.turn_sigma, dimension::kAngle)); });
  }

  /// Adds the columns of quantities that belong to particular kinds, for all kinds among the measurements.
  void addOwn() {
    std::set<std::string> added;
    for (const auto& kind : calibration::measurementKinds()) {
      if (!anyHas(measurements_, [&](const auto& m) { return m.kind == kind.kind; })) continue;
      for (const MeasuredColumn& column : kind.columns) {
        if (!added.insert(column.name).second) continue;
        add(columnName(column, units_),
            [this, name = column.name, dimension = dimensionOf(column.quantity)](const auto& m) {
              return numberOrNothing(units_.toFile(calibration::ownNumber(m, name), dimension));
            });
      }
    }
  }

  void addConditions() {
    if (anyHas(measurements_, [](const auto& m) { return !m.approach_directions.empty(); }))
      for (std::size_t k = 0; const auto& joint : arm_.joints()) {
        add(jointColumnName(joint) + "_dir", [k](const auto& m) {
          return std::to_string(m.approach_directions.empty() ? 0 : m.approach_directions[k]);
        });
        ++k;
      }
    for (const auto& kind : deflection::kConditionKinds)
      if (anyHas(measurements_, [&](const auto& m) { return m.conditions.states(kind.condition); }))
        add(conditionColumn(kind, units_), [this, &kind](const auto& m) {
          return is_sheet_ ? "" : numberOrNothing(units_.toFile(m.conditions[kind.condition], kind.unit));
        });
    if (anyHas(measurements_, [](const auto& m) { return m.is_held_out; }))
      add("split", [](const auto& m) { return std::string(m.is_held_out ? "held-out" : "fit"); });
  }

  const std::vector<Measurement>& measurements_;
  const deflection::Arm& arm_;
  const Units& units_;
  bool is_sheet_;
  std::vector<const deflection::Joint<double>*> side_joints_;
  std::vector<Column> columns_;
};

}  // namespace

std::string measurementsCsv(const std::vector<Measurement>& measurements, const deflection::Arm& arm,
                            const Units& units) {
  return Table(measurements, arm, units).text();
}

std::string runSheetCsv(const std::vector<ProposedMeasurement>& proposed, const deflection::Arm& arm,
                        const Units& units) {
  std::vector<Measurement> rows;
  for (const auto& measurement : proposed) rows.push_back(calibration::conditionsOf(measurement));
  return Table(rows, arm, units, TableOf::kRunSheet).text();
}

FillIn fillInOf(const ProposedMeasurement& proposed, const deflection::Arm& arm, const Units& units) {
  const auto values = calibration::valueColumnsOf(proposed);
  FillIn fill;
  fill.least = values.least;
  for (Eigen::Index k = 0; values.has_joints && k < arm.jointCount(); ++k, ++fill.least)
    fill.columns.push_back(jointColumn(arm.joint(k), units));
  for (const auto& column : values.numbers) fill.columns.push_back(columnName(column, units));
  for (const auto& kind : deflection::kConditionKinds)
    if (proposed.conditions.states(kind.condition)) fill.optional.push_back(conditionColumn(kind, units));
  return fill;
}

}  // namespace tubeplan::app
