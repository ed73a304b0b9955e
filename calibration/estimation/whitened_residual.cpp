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

/// Adds the unknown points and surfaces to `weights.points`, each with the measurements that touch it.
void groupByPlace(const std::vector<Measurement>& measurements, MeasurementWeights& weights) {
  std::map<std::string, std::size_t> index;
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    if (!hasUnknownPlace(measurements[k])) continue;
    const auto [at, is_new] = index.emplace(placeOf(measurements[k]), weights.points.size());
    if (is_new) weights.points.push_back({measurements[k].point, {}, {}, {}});
    weights.points[at->second].measurements.push_back(static_cast<int>(k));
  }
}

void eliminatePoints(const std::vector<Measurement>& measurements, MeasurementWeights& weights) {
  groupByPlace(measurements, weights);
  for (auto& point : weights.points) {
    const auto whitenerAt = [&](Index i) -> const MatrixXd& {
      return weights.whitener[static_cast<std::size_t>(point.measurements[static_cast<std::size_t>(i)])];
    };
    const auto n = static_cast<Index>(point.measurements.size());
    const Index rows = whitenerAt(0).rows();
    const auto& columns = weights.by_place_numbers;
    MatrixXd stacked(rows * n, columns[static_cast<std::size_t>(point.measurements.front())].cols());
    for (Index i = 0; i < n; ++i)
      stacked.middleRows(rows * i, rows) =
          whitenerAt(i) * columns[static_cast<std::size_t>(point.measurements[static_cast<std::size_t>(i)])];
    decorrelateWithin(weights, point.measurements, stacked);
    const Eigen::CompleteOrthogonalDecomposition<MatrixXd> qr(stacked);
    point.Q = qr.householderQ() * MatrixXd::Identity(rows * n, qr.rank());
    MatrixXd weighed = qr.pseudoInverse().transpose();
    decorrelateWithin(weights, point.measurements, weighed);
    point.estimate = weighed.transpose();
    for (Index i = 0; i < n; ++i) point.estimate.middleCols(rows * i, rows) *= whitenerAt(i);
    weights.degrees_of_freedom -= static_cast<int>(qr.rank());
  }
}

/// Computes the derivatives of each measurement with respect to the parameters of the unknown point or surface that it
/// touches, at this state of the arm.
bool placeColumns(const PlacedArm& placed, const std::vector<Measurement>& measurements,
                  std::vector<MatrixXd>& columns) {
  columns.resize(measurements.size());
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    if (!hasUnknownPlace(measurements[k])) continue;
    if (!touchesSurface(measurements[k])) {
      columns[k] = byPlaceNumbers(measurements[k], {});
      continue;
    }
    const auto tool = toolAt(placed, measurements[k]);
    if (!tool) return false;
    columns[k] = byPlaceNumbers(measurements[k], *tool);
  }
  return true;
}

/// Returns the whitener L^-1 of a measurement with covariance L L^T.
template <int Rows>
MatrixXd whitenerOf(const MatrixXd& covariance) {
  using Square = Eigen::Matrix<double, Rows, Rows>;
  return Eigen::LLT<Square>(Square(covariance)).matrixL().solve(Square::Identity(covariance.rows(), covariance.rows()));
}

/// Computes the derivatives of each measurement with respect to the joint readings.
bool jointSlopes(const PlacedArm& placed, const std::vector<Measurement>& measurements,
                 std::vector<MatrixXd>& by_joints, const StopQuestion& stop) {
  by_joints.resize(measurements.size());
  return predictAll(placed, measurements, basePosesOf(placed, measurements), {.by_joints = true}, stop,
                    [&](std::size_t k, const Prediction& prediction) { by_joints[k] = prediction.by_joints; });
}

}  // namespace

MatrixXd MeasurementWeights::covariance(std::size_t measurement) const {
  MatrixXd sum = noise[measurement];
  sum.diagonal().array() += model_error * model_error;
  return sum;
}

MeasurementWeights reweighted(const MeasurementWeights& weights, const std::vector<Measurement>& measurements,
                              double model_error, const VectorXd& factors) {
  assert(factors.size() == 0 || factors.size() == static_cast<Index>(measurements.size()));
  MeasurementWeights other = weights;
  other.model_error = model_error;
  other.points.clear();
  other.degrees_of_freedom = other.rows;
  other.whitener.resize(measurements.size());
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    MatrixXd covariance = other.own_noise[k];
    covariance.diagonal().array() += model_error * model_error;
    other.whitener[k] = covariance.rows() == 1   ? whitenerOf<1>(covariance)
                        : covariance.rows() == 3 ? whitenerOf<3>(covariance)
                                                 : whitenerOf<Eigen::Dynamic>(covariance);
    if (factors.size()) other.whitener[k] *= std::sqrt(factors[static_cast<Index>(k)]);
  }
  placeSharedNoise(other);
  eliminatePoints(measurements, other);
  return other;
}

std::optional<MeasurementWeights> weighMeasurements(const PlacedArm& placed, const std::vector<Measurement>& taken,
                                                    const VectorXd& factors, double model_error,
                                                    const StopQuestion& stop) {
  std::vector<Measurement> settled;
  if (touchSurfaces(taken)) {
    settled = taken;
    if (!settleSurfaces(placed, settled)) return std::nullopt;
  }
  const std::vector<Measurement>& measurements = settled.empty() ? taken : settled;
  MeasurementWeights weights;
  if (!placeColumns(placed, measurements, weights.by_place_numbers)) return std::nullopt;
  for (const auto& measurement : measurements) {
    weights.first_row.push_back(weights.rows);
    weights.rows += rowsOf(measurement);
  }
  std::vector<MatrixXd> by_joints;
  if (!jointSlopes(placed, measurements, by_joints, stop)) {
    throwIfStopped(stop);
    return std::nullopt;
  }
  weights.shared = separateSharedNoise(placed.arm, measurements, by_joints);
  for (std::size_t k = 0; k < measurements.size(); ++k)
    weights.own_noise.push_back(measurementCovariance(placed.arm, measurements[k], by_joints[k]));
  weights.noise = weights.own_noise;
  for (const auto& shared : weights.shared)
    for (std::size_t i = 0; i < shared.measurements.size(); ++i)
      weights.noise[static_cast<std::size_t>(shared.measurements[i])] +=
          shared.slopes[i] * shared.slopes[i].transpose();
  return reweighted(weights, measurements, model_error, factors);
}

WhitenedResidual whitenedResidual(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                  const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                                  const VectorXd& x, bool with_jacobian, const StopQuestion& stop) {
  WhitenedResidual result;
  result.ok = CampaignResidual(start, unknowns, measurements, weights, CampaignResidual::Priors::kNone, stop)
                  .evaluate(x, result.r, with_jacobian ? &result.jacobian : nullptr, &result.error);
  return result;
}

VectorXd errorLengths(const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                      const VectorXd& error) {
  VectorXd lengths(static_cast<Index>(measurements.size()));
  for (std::size_t k = 0; k < measurements.size(); ++k)
    lengths[static_cast<Index>(k)] = error.segment(weights.first_row[k], rowsOf(measurements[k])).norm();
  return lengths;
}

double lengthOfRows(const std::vector<Measurement>& measurements) {
  double rows = 0;
  for (const auto& measurement : measurements) rows += rowsOf(measurement);
  return std::sqrt(rows / static_cast<double>(measurements.size()));
}

double noiseFloor(const std::vector<Measurement>& measurements, const MeasurementWeights& weights) {
  double sum = 0;
  for (const auto& noise : weights.noise) sum += noise.trace();
  for (const auto& point : weights.points)
    for (const int k : point.measurements)
      sum -= weights.noise[static_cast<std::size_t>(k)].trace() * static_cast<double>(point.Q.cols()) /
             static_cast<double>(point.Q.rows());
  return std::sqrt(sum / static_cast<double>(measurements.size()));
}

}  // namespace tubeplan::calibration
