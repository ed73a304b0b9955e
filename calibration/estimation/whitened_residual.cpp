#include "calibration/estimation/whitened_residual.hpp"

#include <cassert>
#include <cmath>
#include <map>

#include "calibration/estimation/campaign_residual.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/predict_all.hpp"
#include "calibration/measurements/surfaces.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

namespace {

/// Adds the unknown points and surfaces to `weights.points`, each with the readings that touch it.
void groupByPlace(const std::vector<Measurement>& readings, ReadingWeights& weights) {
  std::map<std::string, std::size_t> index;
  for (std::size_t k = 0; k < readings.size(); ++k) {
    if (!hasUnknownPlace(readings[k])) continue;
    const auto [at, is_new] = index.emplace(placeOf(readings[k]), weights.points.size());
    if (is_new) weights.points.push_back({readings[k].point, {}, {}, {}});
    weights.points[at->second].readings.push_back(static_cast<int>(k));
  }
}

void eliminatePoints(const std::vector<Measurement>& readings, ReadingWeights& weights) {
  groupByPlace(readings, weights);
  for (auto& point : weights.points) {
    const auto whitenerAt = [&](Index i) -> const MatrixXd& {
      return weights.whitener[static_cast<std::size_t>(point.readings[static_cast<std::size_t>(i)])];
    };
    const auto n = static_cast<Index>(point.readings.size());
    const Index rows = whitenerAt(0).rows();
    const auto& columns = weights.by_place_numbers;
    MatrixXd stacked(rows * n, columns[static_cast<std::size_t>(point.readings.front())].cols());
    for (Index i = 0; i < n; ++i)
      stacked.middleRows(rows * i, rows) =
          whitenerAt(i) * columns[static_cast<std::size_t>(point.readings[static_cast<std::size_t>(i)])];
    decorrelateWithin(weights, point.readings, stacked);
    const Eigen::CompleteOrthogonalDecomposition<MatrixXd> qr(stacked);
    point.Q = qr.householderQ() * MatrixXd::Identity(rows * n, qr.rank());
    MatrixXd weighed = qr.pseudoInverse().transpose();
    decorrelateWithin(weights, point.readings, weighed);
    point.estimate = weighed.transpose();
    for (Index i = 0; i < n; ++i) point.estimate.middleCols(rows * i, rows) *= whitenerAt(i);
    weights.degrees_of_freedom -= static_cast<int>(qr.rank());
  }
}

/// Computes the derivatives of each reading with respect to the parameters of the unknown point or surface that it
/// touches, at this state of the arm.
bool placeColumns(const PlacedArm& placed, const std::vector<Measurement>& readings, std::vector<MatrixXd>& columns) {
  columns.resize(readings.size());
  for (std::size_t k = 0; k < readings.size(); ++k) {
    if (!hasUnknownPlace(readings[k])) continue;
    if (!touchesSurface(readings[k])) {
      columns[k] = byPlaceNumbers(readings[k], {});
      continue;
    }
    const auto tool = toolAt(placed, readings[k]);
    if (!tool) return false;
    columns[k] = byPlaceNumbers(readings[k], *tool);
  }
  return true;
}

/// Returns the whitener L^-1 of a reading with covariance L L^T.
template <int Rows>
MatrixXd whitenerOf(const MatrixXd& covariance) {
  using Square = Eigen::Matrix<double, Rows, Rows>;
  return Eigen::LLT<Square>(Square(covariance)).matrixL().solve(Square::Identity(covariance.rows(), covariance.rows()));
}

/// Computes the derivatives of each reading with respect to the joint readings.
bool jointSlopes(const PlacedArm& placed, const std::vector<Measurement>& readings, std::vector<MatrixXd>& by_joints,
                 const StopQuestion& stop) {
  by_joints.resize(readings.size());
  return predictAll(placed, readings, basePosesOf(placed, readings), {.by_joints = true}, stop,
                    [&](std::size_t k, const Prediction& prediction) { by_joints[k] = prediction.by_joints; });
}

}  // namespace

MatrixXd ReadingWeights::covariance(std::size_t reading) const {
  MatrixXd sum = noise[reading];
  sum.diagonal().array() += model_error * model_error;
  return sum;
}

ReadingWeights reweighted(const ReadingWeights& weights, const std::vector<Measurement>& readings, double model_error,
                          const VectorXd& factors) {
  assert(factors.size() == 0 || factors.size() == static_cast<Index>(readings.size()));
  ReadingWeights other = weights;
  other.model_error = model_error;
  other.points.clear();
  other.degrees_of_freedom = other.rows;
  other.whitener.resize(readings.size());
  for (std::size_t k = 0; k < readings.size(); ++k) {
    MatrixXd covariance = other.own_noise[k];
    covariance.diagonal().array() += model_error * model_error;
    other.whitener[k] = covariance.rows() == 1   ? whitenerOf<1>(covariance)
                        : covariance.rows() == 3 ? whitenerOf<3>(covariance)
                                                 : whitenerOf<Eigen::Dynamic>(covariance);
    if (factors.size()) other.whitener[k] *= std::sqrt(factors[static_cast<Index>(k)]);
  }
  placeSharedNoise(other);
  eliminatePoints(readings, other);
  return other;
}

std::optional<ReadingWeights> weighReadings(const PlacedArm& placed, const std::vector<Measurement>& taken,
                                            const VectorXd& factors, double model_error, const StopQuestion& stop) {
  std::vector<Measurement> settled;
  if (touchSurfaces(taken)) {
    settled = taken;
    if (!settleSurfaces(placed, settled)) return std::nullopt;
  }
  const std::vector<Measurement>& readings = settled.empty() ? taken : settled;
  ReadingWeights weights;
  if (!placeColumns(placed, readings, weights.by_place_numbers)) return std::nullopt;
  for (const auto& reading : readings) {
    weights.first_row.push_back(weights.rows);
    weights.rows += rowsOf(reading);
  }
  std::vector<MatrixXd> by_joints;
  if (!jointSlopes(placed, readings, by_joints, stop)) {
    goOn(stop);
    return std::nullopt;
  }
  weights.shared = separateSharedNoise(placed.arm, readings, by_joints);
  for (std::size_t k = 0; k < readings.size(); ++k)
    weights.own_noise.push_back(readingCovariance(placed.arm, readings[k], by_joints[k]));
  weights.noise = weights.own_noise;
  for (const auto& shared : weights.shared)
    for (std::size_t i = 0; i < shared.readings.size(); ++i)
      weights.noise[static_cast<std::size_t>(shared.readings[i])] += shared.slopes[i] * shared.slopes[i].transpose();
  return reweighted(weights, readings, model_error, factors);
}

WhitenedResidual whitenedResidual(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                  const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                  const VectorXd& x, bool with_jacobian, const StopQuestion& stop) {
  WhitenedResidual result;
  result.ok = CampaignResidual(start, unknowns, readings, weights, CampaignResidual::Priors::kNone, stop)
                  .evaluate(x, result.r, with_jacobian ? &result.jacobian : nullptr, &result.error);
  return result;
}

VectorXd errorLengths(const std::vector<Measurement>& readings, const ReadingWeights& weights, const VectorXd& error) {
  VectorXd lengths(static_cast<Index>(readings.size()));
  for (std::size_t k = 0; k < readings.size(); ++k)
    lengths[static_cast<Index>(k)] = error.segment(weights.first_row[k], rowsOf(readings[k])).norm();
  return lengths;
}

double lengthOfRows(const std::vector<Measurement>& readings) {
  double rows = 0;
  for (const auto& reading : readings) rows += rowsOf(reading);
  return std::sqrt(rows / static_cast<double>(readings.size()));
}

double noiseFloor(const std::vector<Measurement>& readings, const ReadingWeights& weights) {
  double sum = 0;
  for (const auto& noise : weights.noise) sum += noise.trace();
  for (const auto& point : weights.points)
    for (const int k : point.readings)
      sum -= weights.noise[static_cast<std::size_t>(k)].trace() * static_cast<double>(point.Q.cols()) /
             static_cast<double>(point.Q.rows());
  return std::sqrt(sum / static_cast<double>(readings.size()));
}

}  // namespace tubeplan::calibration
