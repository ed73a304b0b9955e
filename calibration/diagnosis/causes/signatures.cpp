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
  return cause.effects.size() == 1 && cause.shape < 0 && deflection::shiftsJoints(cause.effects.front());
}

}  // namespace

Signatures::Signatures(const PlacedArm& fitted, const std::vector<Cause>& causes) {
  for (const Cause& cause : causes) of_cause_.emplace_back(cause.levels.size());
  addLayers(
      fitted, causes, [](const Cause& cause) { return !isOfJoints(cause); }, layers_);
  addLayers(fitted, causes, isOfJoints, joint_layers_);
  addJointColumns(fitted, causes);
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

template <class IsChosen>
void Signatures::addLayers(const PlacedArm& fitted, const std::vector<Cause>& causes, const IsChosen& isChosen,
                           std::vector<Layer>& layers) {
  std::size_t most_levels = 0;
  for (const Cause& cause : causes)
    if (!isStep(cause)) most_levels = std::max(most_levels, cause.levels.size());
  for (std::size_t level = 0; level < most_levels; ++level) {
    Layer layer{fitted, {}, {}, {}};
    for (std::size_t c = 0; c < causes.size(); ++c) {
      if (level >= causes[c].levels.size() || isStep(causes[c]) || actsAlike(causes[c]) || !isChosen(causes[c]))
        continue;
      for (const Unknown& unknown : placeCause(layer.placed, causes[c], causes[c].levels[level])) {
        of_cause_[c][level].push_back(addColumn(unknown));
        layer.columns.push_back(of_cause_[c][level].back());
        layer.unknowns.push_back(unknown);
      }
      if (layer.unknowns.size() < kNumbersOfLayer) continue;
      layers.push_back(std::exchange(layer, Layer{fitted, {}, {}, {}}));
    }
    if (!layer.unknowns.empty()) layers.push_back(std::move(layer));
  }
}

void Signatures::addJointColumns(const PlacedArm& fitted, const std::vector<Cause>& causes) {
  joints_.placed = fitted;
  for (std::size_t c = 0; c < causes.size(); ++c) {
    if (!isOfJoints(causes[c])) continue;
    const deflection::Effect& neutral = causes[c].effects.front();
    const auto& parameters = deflection::numbersOf(neutral);
    for (std::size_t v = 0; v < parameters.size(); ++v) {
      deflection::Effect typical = neutral;
      typical.values[v] += parameters[v].plausible;
      joint_columns_.push_back({std::move(typical), of_cause_[c].front()[v]});
    }
  }
  if (joint_columns_.empty()) return;
  for (const std::string& joint : deflection::jointNames(fitted.arm)) {
    const Cause offset{"", joint, {deflection::offsetOf(fitted.arm, joint)}, {}};
    for (Unknown& unknown : placeCause(joints_.placed, offset, 0)) joints_.unknowns.push_back(std::move(unknown));
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

bool Signatures::fill(const Layer& layer, const std::vector<Measurement>& measurements,
                      const MeasurementWeights& weights, const StopQuestion& stop, MatrixXd& all) const {
  throwIfStopped(stop);
  auto residual =
      whitenedResidual(layer.placed, layer.unknowns, measurements, weights, zerosOf(layer.unknowns), true, stop);
  if (!residual.ok) return false;
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
  return true;
}

bool Signatures::fillJointColumns(const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                                  const StopQuestion& stop, MatrixXd& all) const {
  if (joint_columns_.empty()) return true;
  throwIfStopped(stop);
  const auto by_joints =
      whitenedResidual(joints_.placed, joints_.unknowns, measurements, weights, zerosOf(joints_.unknowns), true, stop);
  if (!by_joints.ok) return false;
  for (std::size_t r = 0; r < measurements.size(); ++r) {
    const auto rows = Eigen::seqN(weights.first_row[r], rowsOf(measurements[r]));
    const auto posture = postureOf(measurements[r], joints_.placed.arm, basePoseAt(joints_.placed, measurements[r]));
    deflection::JointShift shift(joints_.placed.arm, posture);
    for (const JointColumn& of : joint_columns_)
      all(rows, of.column).noalias() = by_joints.jacobian.middleRows(rows.first(), rows.size()) * shift.by(of.effect);
  }
  return true;
}

MatrixXd Signatures::columnsAt(const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                               const StopQuestion& stop) const {
  MatrixXd all(weights.rows, static_cast<Index>(columns_.size()));
  // Unknown points absorb a part of a step that depends on its time, so this part is removed only from the finished
  // columns.
  MeasurementWeights without_points = weights;
  without_points.points.clear();
  without_points.shared.clear();
  const auto fillAll = [&](const std::vector<Layer>& layers) {
    return std::ranges::all_of(
        layers, [&](const Layer& layer) { return fill(layer, measurements, without_points, stop, all); });
  };
  if (!fillAll(layers_)) return {};
  const bool by_layers = std::ranges::any_of(measurements, isDisplacement);
  if (by_layers ? !fillAll(joint_layers_) : !fillJointColumns(measurements, without_points, stop, all)) return {};
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
