#include "calibration/measurement_checks/stuck_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "calibration/measurement_checks/check_words.hpp"
#include "calibration/measurement_checks/from_measurement.hpp"
#include "calibration/measurement_checks/golden_section.hpp"
#include "calibration/measurement_checks/row_comparison.hpp"
#include "calibration/statistics.hpp"
#include "deflection/weights.hpp"

namespace tubeplan::calibration {

namespace {

// Smallest ratio of a gross error to the usual error and to the noise, as for copied joints.
constexpr double kGrossOfStuck = 10;
constexpr std::size_t kFewestStuck = 3;  // smallest number of measurements with gross errors in a run
constexpr double kMostStuck = 0.4;       // largest fraction of the measurements that a run may have
constexpr int kTurnsTried = 36;          // values of the joint that are tried before the best is refined
constexpr int kStepsToJoint = 30;        // number of golden-section steps

/// Run of measurements with one reading of a joint, and the range of the values that the measured positions require.
struct StuckRun {
  Run run;
  int joint = 0;
  double lowest = 0, highest = 0;
};

class StuckSearch {
 public:
  StuckSearch(const CheckedMeasurements& checked, const PlacedArm& found)
      : checked_(checked), found_(found), rows_(found, checked.measurements) {
    std::vector<double> known;
    for (std::size_t k = 0; k < checked.measurements.size(); ++k)
      if (std::isfinite(rows_.at(k))) known.push_back(rows_.at(k));
    if (!known.empty()) usual_ = median(std::move(known));
  }

  std::vector<MeasurementCheck> find() {
    std::vector<MeasurementCheck> checks;
    for (int j = 0; j < checked_.start.arm.jointCount(); ++j)
      for (const Run& same : runsOf(j))
        if (const auto stuck = stuckIn(same, j)) checks.push_back(checkOf(*stuck));
    return checks;
  }

 private:
  [[nodiscard]] const std::vector<Measurement>& all() const { return checked_.measurements; }
  [[nodiscard]] double grossAt(std::size_t k) const { return kGrossOfStuck * std::max(usual_, all()[k].sigma); }
  [[nodiscard]] bool isGross(std::size_t k) { return rows_.at(k) > grossAt(k); }

  /// Returns the runs of one set-up in which the joint has exactly one reading.
  [[nodiscard]] std::vector<Run> runsOf(int joint) const {
    std::vector<Run> runs;
    for (std::size_t first = 0, k = 1; k <= all().size(); ++k) {
      if (k < all().size() && all()[k].q[joint] == all()[first].q[joint] && all()[k].setup == all()[first].setup)
        continue;
      if (k - first >= kFewestStuck) runs.push_back({first, k - 1});
      first = k;
    }
    return runs;
  }

  /// Returns the part of a run with gross errors, if they are this joint's. The first measurements of the run may be
  /// right.
  std::optional<StuckRun> stuckIn(Run run, int joint) {
    while (run.first < run.last && !isGross(run.first)) ++run.first;
    while (run.last > run.first && !isGross(run.last)) --run.last;
    const std::size_t length = run.last - run.first + 1;
    if (length < kFewestStuck || static_cast<double>(length) > kMostStuck * static_cast<double>(all().size()))
      return std::nullopt;
    StuckRun stuck{run, joint, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (std::size_t k = run.first; k <= run.last; ++k) {
      const auto [value, error] = bestJoint(k, joint);
      const bool is_right = !isGross(k);  // the true value may be near the reading by chance
      if (!is_right && !(error < grossAt(k) && error * kGrossOfStuck < rows_.at(k))) return std::nullopt;
      stuck.lowest = std::min(stuck.lowest, value), stuck.highest = std::max(stuck.highest, value);
    }
    return stuck;
  }

  /// Returns the value of the joint with which measurement `k` fits best [rad or m], and its error there [m].
  [[nodiscard]] std::pair<double, double> bestJoint(std::size_t k, int joint) const {
    const bool turns = checked_.start.arm.joint(joint).type == deflection::JointType::kRevolute;
    const double range = turns ? std::numbers::pi : deflection::reachOf(checked_.start.arm);
    std::vector<Measurement> measurement{all()[k]};
    const double reading = measurement.front().q[joint];
    const auto errorAt = [&](double value) {
      measurement.front().q[joint] = value;
      return RowErrors(found_, measurement).at(0);
    };
    double best = reading, least = std::numeric_limits<double>::infinity();
    for (int step = -kTurnsTried / 2; step < kTurnsTried / 2; ++step)
      if (const double value = reading + 2 * range * step / kTurnsTried, error = errorAt(value); error < least)
        best = value, least = error;
    const double width = 2 * range / kTurnsTried;
    best = leastOf(errorAt, best - width, best + width, kStepsToJoint);
    return {best, errorAt(best)};
  }

  /// Returns the root mean square of the errors [m], without those of a run if one is given.
  [[nodiscard]] double rmsWithout(const std::optional<Run>& run) {
    double sum = 0;
    int count = 0;
    for (std::size_t k = 0; k < all().size(); ++k) {
      if (!std::isfinite(rows_.at(k)) || (run && k >= run->first && k <= run->last)) continue;
      sum += rows_.at(k) * rows_.at(k), ++count;
    }
    return std::sqrt(sum / std::max(1, count));
  }

  MeasurementCheck checkOf(const StuckRun& stuck) {
    const NamedUnit unit = columnUnitOf(checked_, stuck.joint);
    const std::string &first = all()[stuck.run.first].id, &last = all()[stuck.run.last].id;
    MeasurementCheck check{
        "stuck-joint",
        CheckSeverity::kMistake,
        fmt::format("joint {} reads {:.6g} {} in all readings {} to {}, although the tip moves as if it stood between "
                    "{:.4g} and {:.4g} {}: its encoder or its column stood still",
                    checked_.start.arm.joint(stuck.joint).name, all()[stuck.run.first].q[stuck.joint] / unit.factor,
                    unit.name, first, last, stuck.lowest / unit.factor, stuck.highest / unit.factor, unit.name),
        rmsWithout(std::nullopt),
        rmsWithout(stuck.run),
        "without=" + calibration::textOf(stuck.run, all()),
        {}};
    return check;
  }

  const CheckedMeasurements& checked_;
  const PlacedArm& found_;
  RowErrors rows_;
  double usual_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::vector<MeasurementCheck> stuckJoints(const CheckedMeasurements& checked, const PlacedArm& found) {
  return StuckSearch(checked, found).find();
}

}  // namespace tubeplan::calibration
