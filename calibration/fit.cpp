#include "calibration/fit.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <memory>

#include "calibration/campaign_residual.hpp"
#include "calibration/reading_prediction.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

namespace {

constexpr int kMaxRounds = 3;
constexpr double kWeightsRest = 1e-3;  // relative change of chi-square by new weights that asks for another round

/// Weight of each reading by its whitened length, against the spread of most readings: a model that is off everywhere
/// must not make every reading an outlier.
VectorXd robustFactors(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                       const WhitenedResidual& residual, const VectorXd& old, RobustLoss loss) {
  VectorXd size(static_cast<Index>(readings.size()));
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const double weight = old.size() ? old[static_cast<Index>(k)] : 1;
    size[static_cast<Index>(k)] =
        residual.r.segment(weights.first_row[k], rowsOf(readings[k])).norm() / std::sqrt(weight * rowsOf(readings[k]));
  }
  std::vector<double> sorted(size.begin(), size.end());
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<long>(sorted.size() / 2), sorted.end());
  const double spread = std::max(1., sorted[sorted.size() / 2] / 0.89);  // median of chi_3 / sqrt 3
  VectorXd factors(size.size());
  for (Index k = 0; k < size.size(); ++k) {
    const double s = size[k] / spread;
    factors[k] = loss == RobustLoss::kHuber ? (s > 1.6 ? 1.6 / s : 1) : 1 / (1 + s * s / 6);
  }
  return factors;
}

}  // namespace

LeastSquaresProblem fitProblem(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                               const std::vector<Measurement>& readings, const ReadingWeights& weights,
                               const VectorXd& x) {
  const auto n = static_cast<Index>(unknowns.size());
  LeastSquaresProblem problem;
  problem.start = x;
  problem.lower.resize(n);
  problem.upper.resize(n);
  problem.scale.resize(n);
  for (Index k = 0; k < n; ++k) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(k)];
    problem.lower[k] = unknown.lower;
    problem.upper[k] = unknown.upper;
    problem.scale[k] = unknown.typical;
  }
  const auto residual = std::make_shared<CampaignResidual>(start, unknowns, readings, weights);
  problem.evaluate = [residual](const VectorXd& at, VectorXd& r, MatrixXd* jacobian) {
    return residual->evaluate(at, r, jacobian);
  };
  return problem;
}

LeastSquaresResult minimizeOrUnwind(const LeastSquaresProblem& problem, const LeastSquaresOptions& solver) {
  LeastSquaresResult result = minimizeLeastSquares(problem, solver);
  if (result.status == LeastSquaresStatus::kStopped) throw WorkStopped{};
  return result;
}

Fit fitUnknowns(const PlacedArm& start, const std::vector<Unknown>& unknowns, const std::vector<Measurement>& readings,
                const VectorXd& x, const LeastSquaresOptions& solver, RobustLoss loss) {
  Fit fit;
  fit.solution.x = x;
  VectorXd next_factors;
  int iterations = 0, evaluations = 0, jacobian_evaluations = 0;
  double before = std::numeric_limits<double>::quiet_NaN();
  const int rounds = loss == RobustLoss::kNone ? kMaxRounds : 5 * kMaxRounds;
  for (int round = 0; round < rounds; ++round) {
    auto weights = weighReadings(applied(start, unknowns, fit.solution.x), readings, next_factors);
    if (!weights) {
      fit.solution.status = LeastSquaresStatus::kFailed;
      fit.solution.reason = "the deflected shape does not settle: the arm is too soft for its load";
      return fit;
    }
    fit.weights = std::move(*weights);
    fit.factors = next_factors;
    if (round > 0 && loss == RobustLoss::kNone) {
      const double now =
          whitenedResidual(start, unknowns, readings, fit.weights, fit.solution.x, false).r.squaredNorm();
      if (std::abs(now - before) <= kWeightsRest * std::max(now, 1.)) break;
    }
    const VectorXd from = fit.solution.x;
    if (unknowns.empty()) {
      fit.solution.status = LeastSquaresStatus::kConverged;
    } else {
      fit.solution = minimizeOrUnwind(fitProblem(start, unknowns, readings, fit.weights, from), solver);
      iterations += fit.solution.iterations;
      evaluations += fit.solution.evaluations;
      jacobian_evaluations += fit.solution.jacobian_evaluations;
    }
    if (fit.solution.status == LeastSquaresStatus::kFailed) return fit;
    before = fit.solution.chi2;
    if (loss == RobustLoss::kNone) continue;
    const auto residual = whitenedResidual(start, unknowns, readings, fit.weights, fit.solution.x, false);
    next_factors = robustFactors(readings, fit.weights, residual, fit.factors, loss);
    if (fit.factors.size() && (next_factors - fit.factors).cwiseAbs().maxCoeff() < 1e-3) break;
  }
  fit.residual = whitenedResidual(start, unknowns, readings, fit.weights, fit.solution.x, true);
  fit.solution.chi2 = fit.residual.r.squaredNorm();
  fit.solution.iterations = iterations;
  fit.solution.evaluations = evaluations;
  fit.solution.jacobian_evaluations = jacobian_evaluations;
  return fit;
}

void alignPlacings(PlacedArm& placed, const std::vector<Measurement>& readings) {
  for (std::size_t p = 0; p < placed.placings.size(); ++p) {
    Placing& placing = placed.placings[p];
    if (placing.is_known) continue;
    for (int repeat = 0; repeat < 6; ++repeat) {
      std::vector<Vector3d> tips, places;
      for (const auto& reading : readings) {
        const bool tells = reading.kind == MeasurementKind::kPosition || reading.kind == MeasurementKind::kTouch;
        if (reading.is_held_out || !tells || !reading.p_W || placingOf(placed, reading) != static_cast<int>(p))
          continue;
        const auto shape =
            deflection::solveFlexibleKinematics(placed.arm, postureOf(reading, placed.arm, placing.X_WB));
        if (shape.status != deflection::KinematicsStatus::kConverged) continue;
        tips.push_back(shape.X_BD.p);
        places.push_back(*reading.p_W);
      }
      if (tips.size() < 3) break;
      const auto n = static_cast<Index>(tips.size());
      const Eigen::Map<const Eigen::Matrix3Xd> from(tips.front().data(), 3, n), to(places.front().data(), 3, n);
      const Eigen::Matrix3Xd centred = from.colwise() - from.rowwise().mean();
      const auto spread = centred.jacobiSvd().singularValues();
      if (spread[1] < 1e-6 * spread[0]) break;  // all in one line: the turn about it cannot be told
      placing.X_WB = Eigen::Isometry3d(Eigen::umeyama(from, to, false));
    }
  }
}

ErrorSize errorSize(const std::vector<Measurement>& readings, const ReadingWeights& weights, const VectorXd& error) {
  const VectorXd lengths = errorLengths(readings, weights, error);
  ErrorSize size;
  size.readings = static_cast<int>(readings.size());
  if (lengths.size() == 0) return size;
  size.rms = std::sqrt(lengths.squaredNorm() / static_cast<double>(lengths.size()));
  size.mean = lengths.mean();
  size.max = lengths.maxCoeff();
  return size;
}

MatrixXd covarianceOf(const MatrixXd& jacobian) {
  if (jacobian.cols() == 0) return {};
  // Columns of unit length: a compliance and a force differ by many powers of ten.
  const VectorXd lengths = jacobian.colwise().norm().transpose();
  const VectorXd scale = lengths.unaryExpr([](double length) { return length > 0 ? 1 / length : 0; });
  const MatrixXd back =
      scale.asDiagonal() * MatrixXd(jacobian * scale.asDiagonal()).completeOrthogonalDecomposition().pseudoInverse();
  return back * back.transpose();
}

double chiSquareTail(double chi2, double degrees_of_freedom) {
  if (degrees_of_freedom <= 0 || !std::isfinite(chi2)) return 1;
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(degrees_of_freedom), std::max(chi2, 0.)));
}

}  // namespace tubeplan::calibration
