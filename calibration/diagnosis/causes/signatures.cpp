#include "calibration/diagnosis/causes/signatures.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include "calibration/measurements/measurement_prediction.hpp"
#include "deflection/effects/joint_shift.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd;

namespace {

constexpr std::size_t kNumbersOfLayer = 8;

bool actsAlike(const Cause& cause) { return cause.effects.size() > 1; }

bool isOfJoints(const Cause& cause) {
  return !cause.effects.empty() && deflection::shiftsJoints(cause.effects.front());
}

}  // namespace

Signatures::Signatures(const PlacedArm& fitted, const std::vector<Cause>& causes) {
  for (const Cause& cause : causes) of_cause_.emplace_back(cause.levels.size());
  for (const bool of_joints : {false, true}) addLayers(fitted, causes, of_joints);
  for (std::size_t c = 0; c < causes.size(); ++c)
    if (isStep(causes[c])) addStep(fitted, causes[c], c);
  shareColumns(causes);
}

int Signatures::addColumn(const Unknown& unknown) {
  const bool is_of_effect = unknown.path.effect >= 0;
  columns_.push_back({unknown.lower / unknown.typical, unknown.upper / unknown.typical,
                      is_of_effect ? 1 : unknown.prior_sigma / unknown.typical, is_of_effect});
  return static_cast<int>(columns_.size()) - 1;
}

void Signatures::addLayers(const PlacedArm& fitted, const std::vector<Cause>& causes, bool of_joints) {
  std::size_t most_levels = 0;
  for (const Cause& cause : causes)
    if (!isStep(cause)) most_levels = std::max(most_levels, cause.levels.size());
  for (std::size_t level = 0; level < most_levels; ++level) {
    Layer layer{fitted, {}, {}, {}};
    for (std::size_t c = 0; c < causes.size(); ++c) {
      if (level >= causes[c].levels.size() || isStep(causes[c]) || actsAlike(causes[c])) continue;
      if (isOfJoints(causes[c]) != of_joints) continue;
      for (const Unknown& unknown : placeCause(layer.placed, causes[c], causes[c].levels[level])) {
        of_cause_[c][level].push_back(addColumn(unknown));
        layer.columns.push_back(of_cause_[c][level].back());
        layer.unknowns.push_back(unknown);
      }
      if (layer.unknowns.size() < kNumbersOfLayer) continue;
      layers_.push_back(std::exchange(layer, Layer{fitted, {}, {}, {}}));
    }
    if (!layer.unknowns.empty()) layers_.push_back(std::move(layer));
  }
}

void Signatures::addStep(const PlacedArm& fitted, const Cause& cause, std::size_t index) {
  Layer layer{fitted, {}, {}, cause.levels};
  layer.unknowns = placeCause(layer.placed, cause, -std::numeric_limits<double>::infinity());
  for (std::size_t level = 0; level < cause.levels.size(); ++level)
    for (const Unknown& unknown : layer.unknowns) {
      of_cause_[index][level].push_back(addColumn(unknown));
      layer.columns.push_back(of_cause_[index][level].back());
    }
  layers_.push_back(std::move(layer));
}

/// Reuses the columns of the effects at single joints for causes that act at every joint.
void Signatures::shareColumns(const std::vector<Cause>& causes) {
  for (std::size_t c = 0; c < causes.size(); ++c) {
    if (!actsAlike(causes[c])) continue;
    for (const auto& effect : causes[c].effects) {
      const auto single = std::ranges::find_if(causes, [&](const Cause& other) {
        return other.effects.size() == 1 && areOne(other.effects.front(), effect);
      });
      assert(single != causes.end());
      const auto& columns = of_cause_[static_cast<std::size_t>(single - causes.begin())].front();
      of_cause_[c].front().insert(of_cause_[c].front().end(), columns.begin(), columns.end());
    }
  }
}

MatrixXd Signatures::columnsAt(const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                               const StopQuestion& stop) const {
  MatrixXd all(weights.rows, static_cast<Index>(columns_.size()));
  // Unknown points absorb a part of a step that depends on its time, so this part is removed only from the finished
  // columns.
  MeasurementWeights without_points = weights;
  without_points.points.clear();
  without_points.shared.clear();
  for (const Layer& layer : layers_) {
    throwIfStopped(stop);
    auto residual = whitenedResidual(layer.placed, layer.unknowns, measurements, without_points,
                                     zerosOf(layer.unknowns), true, stop);
    if (!residual.ok) return {};
    const auto count = static_cast<Index>(layer.unknowns.size());
    residual.jacobian.array().rowwise() *= typicalsOf(layer.unknowns).transpose().array();
    const std::size_t blocks = std::max<std::size_t>(1, layer.times.size());
    for (std::size_t block = 0; block < blocks; ++block)
      for (Index k = 0; k < count; ++k) {
        auto column = all.col(layer.columns[block * static_cast<std::size_t>(count) + static_cast<std::size_t>(k)]);
        column = residual.jacobian.col(k);
        if (layer.times.empty()) continue;
        for (std::size_t r = 0; r < measurements.size(); ++r)
          if (measurements[r].conditions[Condition::kTime] < layer.times[block])
            column.segment(weights.first_row[r], rowsOf(measurements[r])).setZero();
      }
  }
  removeSharedParts(weights, all);
  return all;
}

std::optional<SingleCauses> singleCauses(const PlacedArm& placed, const std::vector<Measurement>& measurements,
                                         const std::vector<Unknown>& fitted, const MeasurementWeights& weights) {
  auto causes = listCauses(placed, measurements, fitted).causes;
  std::erase_if(causes, [](const Cause& cause) { return cause.effects.size() != 1; });
  Signatures signatures(placed, causes);
  MatrixXd columns = signatures.columnsAt(measurements, weights);
  if (columns.rows() != weights.rows) return std::nullopt;
  return SingleCauses{std::move(causes), std::move(signatures), std::move(columns)};
}

}  // namespace tubeplan::calibration
