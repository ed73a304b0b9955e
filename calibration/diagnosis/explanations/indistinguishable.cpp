#include "calibration/diagnosis/explanations/indistinguishable.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "calibration/estimation/prior.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/random_stream.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr int kPostures = 48;
// Two explanations are indistinguishable if all virtual measurements together raise chi-square by less than this.
constexpr double kHardly = 9;

double medianSigma(const std::vector<Measurement>& measurements) {
  std::vector<double> sigmas;
  for (const auto& measurement : measurements) sigmas.push_back(measurement.sigma);
  return median(std::move(sigmas));
}

/// Returns virtual measurements of the tip at random postures over the arm's range, without a load and under the
/// heaviest load of the given measurements. Their conditions are taken from randomly drawn given measurements.
std::vector<Measurement> measurementsOverRange(const FittedBasis& basis, std::uint64_t seed) {
  RandomStream random(seed);
  const auto& arm = basis.fitted.arm;
  double heaviest = 0;
  for (const auto& measurement : basis.measurements) heaviest = std::max(heaviest, measurement.load);
  std::vector<Measurement> all;
  for (int posture = 0; posture < kPostures; ++posture) {
    Measurement m = basis.measurements[static_cast<std::size_t>(random.uniform(0, 1) *
                                                                static_cast<double>(basis.measurements.size()))];
    m.kind = MeasurementKind::kPosition;
    m.p_W = Eigen::Vector3d::Zero();
    m.row.reset();
    m.sigma = medianSigma(basis.measurements);
    m.sigma_W.reset();
    m.correlation_W.reset();
    for (Eigen::Index j = 0; j < arm.jointCount(); ++j) {
      const auto& joint = arm.joint(j);
      const double low = std::isfinite(joint.lower) ? joint.lower : -std::numbers::pi;
      const double high = std::isfinite(joint.upper) ? joint.upper : std::numbers::pi;
      m.q[j] = random.uniform(low, high);
      if (!m.approach_directions.empty()) m.approach_directions[j] = random.uniform(0, 1) < 0.5 ? -1 : 1;
    }
    m.load = 0;
    all.push_back(m);
    m.load = heaviest;
    if (heaviest > 0) all.push_back(m);
  }
  std::erase_if(all, [&](const Measurement& m) { return !predictMeasurement(basis.fitted, m).ok; });
  return all;
}

}  // namespace

RangeViews::RangeViews(const FittedBasis& basis, std::uint64_t seed)
    : basis_(basis), measurements_(measurementsOverRange(basis, seed)) {
  if (auto weights = weighMeasurements(basis.fitted, measurements_)) weights_ = std::move(*weights);
}

RangeView RangeViews::of(const Explanation& explanation) const {
  RangeView view;
  if (weights_.rows == 0) return view;
  const ExplanationModel model = modelOf(basis_, explanation);
  const VectorXd zero = zerosOf(model.unknowns), typical = typicalsOf(model.unknowns);
  auto over_range = whitenedResidual(model.placed, model.unknowns, measurements_, weights_, zero, true, basis_.stop);
  auto at_measurements =
      whitenedResidual(model.placed, model.unknowns, basis_.measurements, basis_.weights, zero, true, basis_.stop);
  view.ok = over_range.ok && at_measurements.ok;
  if (!view.ok) return view;
  view.value = over_range.r;
  view.sensitivity = over_range.jacobian * typical.asDiagonal();
  const MatrixXd by_measurements = at_measurements.jacobian * typical.asDiagonal();
  view.information = by_measurements.transpose() * by_measurements;
  view.information.diagonal() += typical.cwiseProduct(priorSlopes(model.unknowns)).cwiseAbs2();
  return view;
}

VectorXd RangeViews::tipsBy(const Explanation& explanation) const {
  VectorXd tips(3 * static_cast<Index>(measurements_.size()));
  for (std::size_t k = 0; k < measurements_.size(); ++k) {
    const auto tip = predictMeasurement(explanation.fitted, measurements_[k]);
    if (!tip.ok) return {};
    tips.segment<3>(3 * static_cast<Index>(k)) = tip.value;
  }
  return tips;
}

bool areTheSame(const RangeView& a, const RangeView& b) {
  if (!a.ok || !b.ok) return false;
  const VectorXd difference = a.value - b.value;
  const auto rise = [&](const RangeView& model) {
    const MatrixXd information = model.information + model.sensitivity.transpose() * model.sensitivity;
    const VectorXd gradient = model.sensitivity.transpose() * difference;
    return difference.squaredNorm() - gradient.dot(information.ldlt().solve(gradient));
  };
  return rise(a) < kHardly && rise(b) < kHardly;
}

}  // namespace tubeplan::calibration
