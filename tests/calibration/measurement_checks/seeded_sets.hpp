// Sets of clean measurements of arms that differ slightly from their drawing, simulated for a design of a shipped cell
// or chosen by number.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/cell/simulation_input.hpp"
#include "app/formats/measurements/measurement_input.hpp"
#include "app/formats/measurements/measurements_reader.hpp"
#include "app/formats/measurements/measurements_writer.hpp"
#include "app/studies/model/cell_fit.hpp"
#include "calibration/measurement_checks/measurement_checks.hpp"
#include "deflection/effects/effect.hpp"

namespace tubeplan::calibration {

/// Cell with measurements in the format of a measurement file.
struct SeededSet {
  std::string name;
  app::Cell cell;
  app::MeasurementTable table;
};

using SeededRandom = std::mt19937_64;

inline double drawnBetween(double from, double to, SeededRandom& random) {
  return from + (to - from) * static_cast<double>(random() >> 11) / 9007199254740992.0;
}
inline int drawnBelow(int count, SeededRandom& random) {
  return static_cast<int>(random() % static_cast<std::uint64_t>(count));
}

inline app::Cell shippedCell(const std::string& name) {
  return app::readCell((std::filesystem::path(TUBEPLAN_SOURCE_DIR) / "app/cells" / name).string());
}

/// Returns measurements simulated for a design of a shipped cell, with stiffnesses wrong by a tenth, a displaced base
/// if it is unknown, and the effects `hidden`. Empty if the simulation cannot make the measurements.
inline std::optional<SeededSet> simulatedSet(const std::string& cell_name, const std::string& design, int measurements,
                                             const std::vector<std::string>& hidden, std::uint64_t seed,
                                             const std::function<void(app::SimulationTask&)>& change = {}) {
  SeededSet set{
      fmt::format("{} {} {} readings seed {} {}", cell_name, design, measurements, seed, fmt::join(hidden, "+")),
      shippedCell(cell_name),
      {}};
  app::SimulationRequest request;
  request.design = design;
  request.measurements = measurements;
  request.hide = hidden;
  request.spread = set.cell.identify.empty() ? 0 : 0.1;
  request.seed = seed;
  auto task = app::prepareSimulation(set.cell, request);
  if (change) change(task);
  const auto campaign = app::simulateMeasurements(set.cell, task, seed, {});
  if (campaign.status != CampaignStatus::kDone) return std::nullopt;
  set.table = app::parseMeasurementTable(app::measurementsCsv(campaign.measurements, set.cell.arm, set.cell.units),
                                         "simulated.csv", set.cell.arm, set.cell.sheet ? &*set.cell.sheet : nullptr);
  app::stateSigma(set.table.measurements, set.cell, "simulated.csv", 0);
  return set;
}

inline MeasurementChecks checksOf(const SeededSet& set) {
  const CheckedMeasurements checked{app::startOf(set.cell, set.table.measurements), set.table.measurements,
                                    app::freeNumbersOf(set.cell), set.table.units,
                                    set.cell.sheet ? &*set.cell.sheet : nullptr};
  return checkMeasurements(checked);
}

/// Returns the clean set with this number; designs, sizes and seeds vary with the number.
inline std::optional<SeededSet> cleanSet(std::uint64_t number) {
  static constexpr int kSizes[] = {30, 60, 120, 45};
  const int size = kSizes[number / 5 % 4];
  const auto twoSetups = [](app::SimulationTask& task) {
    task.design.setups = 2;
    auto second = task.truth.bases.front();
    task.truth.bases.front().setup = "A";
    second.setup = "B";
    second.X_WB.translation() += Eigen::Vector3d(0.05, -0.03, 0.01);
    task.truth.bases.push_back(second);
  };
  switch (number % 5) {
    case 0:
      return simulatedSet("bench.yaml", "bench", size, {}, number);
    case 1:
      return simulatedSet("bowl.yaml", "bench", size, {}, number, twoSetups);
    case 2:
      return simulatedSet("bowl.yaml", "bowl", size, {}, number);
    case 3:
      return simulatedSet("bowl.yaml", "bench", size, {}, number);
    default: {
      auto set = simulatedSet("mockup.yaml", "bowl", 18, {}, number, [](app::SimulationTask& task) {
        task.truth.bases.front().X_WB = shippedCell("mockup.yaml").X_WB;
      });
      if (set) set->cell.base_known = number % 2;
      return set;
    }
  }
}

/// Returns a randomly drawn effect at a randomly drawn place, as "effect@at"; the simulation chooses its size.
inline std::string drawnEffect(const deflection::Arm& arm, SeededRandom& random) {
  for (;;) {
    const auto& kinds = deflection::effectKinds();
    const auto& kind = kinds[random() % kinds.size()];
    const auto places = deflection::placeTexts(arm, kind);
    if (places.empty() || kind.parameters.empty()) continue;
    const std::string at = places[random() % places.size()];
    if (deflection::makeEffect(arm, kind.name, at).status == deflection::EffectStatus::kMade)
      return std::string(kind.name) + "@" + at;
  }
}

/// Returns a set without a mistake by an arm with one or two hidden effects of 1 to 10 times their usual size; every
/// seventh arm is also three times as soft as drawn.
inline std::optional<SeededSet> hidingSet(std::uint64_t number) {
  static constexpr std::pair<const char*, const char*> kDesigns[] = {
      {"bench.yaml", "bench"}, {"bowl.yaml", "bowl"}, {"bowl.yaml", "bench"}, {"bowl.yaml", "touch"}};
  SeededRandom random(number + 5000);
  const auto& [cell, design] = kDesigns[number % 4];
  const int sizes[] = {24, 48, 96};
  const auto arm = shippedCell(cell).arm;
  std::vector<std::string> hidden;
  for (std::uint64_t k = 0; k < 1 + number % 3 / 2; ++k) hidden.push_back(drawnEffect(arm, random));
  const double factor = drawnBetween(1, 10, random);
  return simulatedSet(cell, design, sizes[number / 4 % 3], hidden, number, [&](app::SimulationTask& task) {
    for (auto& effect : task.truth.arm.effects) {
      const auto& kind = deflection::effectKinds().at(static_cast<std::size_t>(effect.kind));
      for (std::size_t v = 0; v < effect.values.size() && v < kind.parameters.size(); ++v)
        if (!kind.parameters[v].is_shape)
          effect.values[v] =
              std::clamp(kind.parameters[v].neutral + factor * (effect.values[v] - kind.parameters[v].neutral),
                         kind.parameters[v].lower, kind.parameters[v].upper);
    }
    if (number % 7 == 0)  // the arm is far softer than its model and sags by inches
      for (auto& row : task.truth.arm.rows) row.joint_stiffness /= 3;
  });
}

}  // namespace tubeplan::calibration
