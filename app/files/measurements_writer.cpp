#include "app/files/measurements_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "app/files/joint_units.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "deflection/side_chains.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using calibration::Measurement;

/// A column of the table: its name, and what a reading has there.
struct Column {
  std::string name;
  std::function<std::string(const Measurement&)> field;
};

std::string numberOrNothing(double value) { return std::isnan(value) ? "" : formatNumber(value); }

template <class Has>
bool anyHas(const std::vector<Measurement>& readings, Has has) {
  return std::any_of(readings.begin(), readings.end(), has);
}

constexpr std::array<const char*, 3> kCorrelationColumns{"rho_xy", "rho_xz", "rho_yz"};
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

class Table {
 public:
  Table(const std::vector<Measurement>& readings, const deflection::Arm& arm, const Units& units)
      : readings_(readings), arm_(arm), units_(units), side_joints_(deflection::sideJoints(arm)) {}

  std::string text() {
    addNames();
    addJoints();
    addCoordinates();
    if (anyHas(readings_, [](const auto& m) { return referenceOf(m) != nullptr; }))
      add("from", [](const auto& m) {
        const Measurement* from = referenceOf(m);
        return from ? tubesheets::csvField(from->id) : std::string();
      });
    if (anyHas(readings_, [](const auto& m) { return m.row.has_value(); }))
      add("row", [this](const auto& m) {
        return m.row ? tubesheets::csvField(arm_.rows.at(static_cast<std::size_t>(*m.row)).name) : std::string();
      });
    addConditions();
    std::vector<std::string> names;
    for (const Column& column : columns_) names.push_back(tubesheets::csvField(column.name));
    std::string text = fmt::format("{}\n", fmt::join(names, ","));
    for (const Measurement& reading : readings_) {
      std::vector<std::string> fields;
      for (const Column& column : columns_) fields.push_back(column.field(reading));
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
    if (anyHas(readings_, [](const auto& m) { return !m.setup.empty(); }))
      add("setup", [](const auto& m) { return tubesheets::csvField(m.setup); });
  }

  void addJoints() {
    add("load_" + std::string(units_.force().name),
        [this](const auto& m) { return formatNumber(units_.toFile(m.load, dimension::kForce)); });
    if (anyHas(readings_, [](const auto& m) { return m.wrench.has_value(); })) addWrench();
    for (Eigen::Index k = 0; k < arm_.jointCount(); ++k)
      add(jointColumn(arm_.joint(k), units_),
          [this, k](const auto& m) { return formatNumber(units_.toFile(m.q[k], jointDimension(arm_.joint(k)))); });
    for (std::size_t k = 0; k < side_joints_.size(); ++k)
      add(jointColumn(*side_joints_[k], units_), [this, k](const auto& m) {
        return formatNumber(units_.toFile(m.side_q[static_cast<Eigen::Index>(k)], jointDimension(*side_joints_[k])));
      });
  }

  void addWrench() {
    const std::string force(units_.force().name), torque = force + std::string(units_.length().name);
    for (Eigen::Index k = 0; k < 3; ++k)
      add(fmt::format("force_{}_{}", "xyz"[k], force), [this, k](const auto& m) {
        return numberOrNothing(m.wrench ? units_.toFile(m.wrench->force_W[k], dimension::kForce) : kNothing);
      });
    if (!anyHas(readings_, [](const auto& m) { return m.wrench && !m.wrench->moment_W.isZero(0); })) return;
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
    if (anyHas(readings_, [](const auto& m) { return m.p_TQ.has_value(); }))
      for (Eigen::Index k = 0; k < 3; ++k)
        addLength(std::string("tool_") + "xyz"[k], [k](const auto& m) { return m.p_TQ ? (*m.p_TQ)[k] : kNothing; });
    if (anyHas(readings_, [](const auto& m) { return calibration::kindOf(m).has_direction; }))
      for (Eigen::Index k = 0; k < 3; ++k)
        add(std::string("d") + "xyz"[k], [k](const auto& m) {
          return numberOrNothing(calibration::kindOf(m).has_direction ? (*m.direction_W)[k] : kNothing);
        });
    addLength("sigma", [](const auto& m) { return m.sigma; });
    if (anyHas(readings_, [](const auto& m) { return m.sigma_W.has_value(); }))
      for (Eigen::Index k = 0; k < 3; ++k)
        addLength(std::string("sigma_") + "xyz"[k],
                  [k](const auto& m) { return m.sigma_W ? (*m.sigma_W)[k] : kNothing; });
    if (anyHas(readings_, [](const auto& m) { return m.correlation_W.has_value(); }))
      for (Eigen::Index k = 0; k < 3; ++k)
        add(kCorrelationColumns[static_cast<std::size_t>(k)],
            [k](const auto& m) { return numberOrNothing(m.correlation_W ? (*m.correlation_W)[k] : kNothing); });
    if (anyHas(readings_, [](const auto& m) { return !std::isnan(m.turn_sigma); }))
      add("turn_sigma_" + std::string(units_.angle().name),
          [this](const auto& m) { return numberOrNothing(units_.toFile(m.turn_sigma, dimension::kAngle)); });
  }

  /// The own columns of every kind that the readings have.
  void addOwn() {
    std::set<std::string> added;
    for (const auto& kind : calibration::measurementKinds()) {
      if (!anyHas(readings_, [&](const auto& m) { return m.kind == kind.kind; })) continue;
      for (const auto& [name, quantity] : kind.columns) {
        if (!added.insert(name).second) continue;
        const Dimension dimension = dimensionOf(quantity);
        const bool is_plain = quantity == deflection::Quantity::kNone;
        add(is_plain ? std::string(name) : fmt::format("{}_{}", name, units_.nameOf(dimension)),
            [this, name = name, dimension](const auto& m) {
              return numberOrNothing(units_.toFile(calibration::ownNumber(m, name), dimension));
            });
      }
    }
  }

  void addConditions() {
    if (anyHas(readings_, [](const auto& m) { return !m.approach_directions.empty(); }))
      for (std::size_t k = 0; const auto& joint : arm_.joints()) {
        add(jointColumnName(joint) + "_dir", [k](const auto& m) {
          return std::to_string(m.approach_directions.empty() ? 0 : m.approach_directions[k]);
        });
        ++k;
      }
    if (anyHas(readings_, [](const auto& m) { return !std::isnan(m.temperature); }))
      add("temperature_" + std::string(units_.temperature().name),
          [this](const auto& m) { return numberOrNothing(units_.temperatureToFile(m.temperature)); });
    if (anyHas(readings_, [](const auto& m) { return !std::isnan(m.time); }))
      add("time_" + std::string(units_.time().name),
          [this](const auto& m) { return numberOrNothing(m.time / units_.time().factor); });
    if (anyHas(readings_, [](const auto& m) { return m.is_held_out; }))
      add("split", [](const auto& m) { return std::string(m.is_held_out ? "held-out" : "fit"); });
  }

  const std::vector<Measurement>& readings_;
  const deflection::Arm& arm_;
  const Units& units_;
  std::vector<const deflection::Joint<double>*> side_joints_;
  std::vector<Column> columns_;
};

}  // namespace

std::string measurementsCsv(const std::vector<Measurement>& readings, const deflection::Arm& arm, const Units& units) {
  return Table(readings, arm, units).text();
}

}  // namespace tubeplan::app
