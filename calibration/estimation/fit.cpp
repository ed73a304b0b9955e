#include "calibration/estimation/fit.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "calibration/estimation/campaign_residual.hpp"
#include "calibration/estimation/prior.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/reading_prediction.hpp"
#include "calibration/statistics.hpp"
#include "deflection/prepared_arm.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

namespace {

constexpr int kMaxRounds = 3;
constexpr double kWeightsRest = 1e-3;      // relative change of chi-square by new weights that asks for another round
constexpr double kGrossErrorLevel = 0.01;  // chance of taking any reading for a gross error where there is none
constexpr double kNearMinimum = 0.01;      // of chi-square, that a fit which creeps has yet to fall
constexpr int kMostAlignments = 12;
constexpr double kAligned = 1e-9;  // change of a placing (m, rad) that asks for no further alignment
constexpr int kMaxModelErrorRounds = 8;
constexpr double kModelErrorConverged = 0.01;  // relative change that asks for no further round

/// Weight of a reading whose whitened length is so many times the usual one.
double robustFactor(double length, RobustLoss loss) {
  if (loss == RobustLoss::kNone) return 1;
  return loss == RobustLoss::kHuber ? (length > 1.6 ? 1.6 / length : 1) : 1 / (1 + length * length / 6);
}

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
  std::vector<double> sizes;
  for (std::size_t k = 0; k < readings.size(); ++k)
    sizes.push_back(size[static_cast<Index>(k)] / std::sqrt(medianOfMeanSquare(rowsOf(readings[k]))));
  const double spread = std::max(1., median(std::move(sizes)));
  VectorXd factors(size.size());
  for (Index k = 0; k < size.size(); ++k) {
    factors[k] = robustFactor(size[k] / spread, loss);
  }
  return factors;
}

/// Mean square of a reading's whitened rows that none of so many readings exceeds but by chance.
double grossErrorLimit(std::size_t readings, int rows) {
  return chiSquareQuantile(kGrossErrorLevel / static_cast<double>(readings), rows) / rows;
}

/// Of a reading's whitened square what a robust loss leaves, in the mean over normal noise.
double shareLeft(int rows, RobustLoss loss) {
  constexpr int kSteps = 400;
  double sum = 0;
  for (int k = 0; k < kSteps; ++k) {
    const double square = chiSquareQuantile((k + 0.5) / kSteps, rows);
    sum += square * robustFactor(std::sqrt(square / rows), loss);
  }
  return sum / kSteps / rows;
}

LeastSquaresProblem problemOf(const std::shared_ptr<CampaignResidual>& residual, const std::vector<Unknown>& unknowns,
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
  problem.evaluate = [residual](const VectorXd& at, VectorXd& r, MatrixXd* jacobian) {
    return residual->evaluate(at, r, jacobian);
  };
  return problem;
}

}  // namespace

LeastSquaresProblem fitProblem(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                               const std::vector<Measurement>& readings, const ReadingWeights& weights,
                               const VectorXd& x, const StopQuestion& stop) {
  return problemOf(
      std::make_shared<CampaignResidual>(start, unknowns, readings, weights, CampaignResidual::Priors::kAppended, stop),
      unknowns, x);
}

LeastSquaresResult minimizeOrUnwind(const LeastSquaresProblem& problem, const LeastSquaresOptions& solver) {
  LeastSquaresResult result = minimizeLeastSquares(problem, solver);
  if (result.status == LeastSquaresStatus::kStopped) throw WorkStopped{};
  return result;
}

namespace {

/// One fit under way.
class Fitting {
 public:
  Fitting(const PlacedArm& start, const std::vector<Unknown>& unknowns, const std::vector<Measurement>& readings,
          const VectorXd& x, const FitOptions& options)
      : start_(start),
        unknowns_(unknowns),
        readings_(readings),
        options_(options),
        with_priors_(std::make_shared<CampaignResidual>(start, unknowns, readings, fit_.weights,
                                                        CampaignResidual::Priors::kAppended, options.solver.stop)) {
    fit_.solution.x = x;
    fit_.weights.model_error = options.model_error.value_or(0);
  }

  Fit run() {
    if (!untilWeightsRest() || !describe()) return std::move(fit_);
    if (options_.model_error || !(fit_.p_value < kLackOfFit)) return std::move(fit_);
    for (int round = 0; round < kMaxModelErrorRounds; ++round) {
      const double before = fit_.weights.model_error;
      const double now = modelErrorOf(readings_, fit_.weights, fit_.residual.error, fit_.degrees_of_freedom);
      if (std::abs(now - before) <= kModelErrorConverged * now) break;
      fit_.weights = reweighted(fit_.weights, readings_, now, fit_.factors);
      if (!minimize() || !describe()) break;
    }
    return std::move(fit_);
  }

 private:
  bool weigh(bool is_first) {
    if (is_first && options_.weights && fit_.weights.model_error == 0) {
      fit_.weights = *options_.weights;
      return true;
    }
    const PlacedArm placed = applied(start_, unknowns_, fit_.solution.x);
    auto weights = weighReadings(placed, readings_, fit_.factors, fit_.weights.model_error, options_.solver.stop);
    if (!weights) return failed("the model cannot be evaluated at the readings: the arm is too compliant for its load");
    fit_.weights = std::move(*weights);
    return true;
  }

  bool failed(const char* reason) {
    fit_.solution.status = LeastSquaresStatus::kFailed;
    fit_.solution.reason = reason;
    return false;
  }

  bool minimize() {
    if (unknowns_.empty()) {
      fit_.solution.status = LeastSquaresStatus::kConverged;
      return true;
    }
    const LeastSquaresResult before = fit_.solution;
    fit_.solution = minimizeOrUnwind(problemOf(with_priors_, unknowns_, before.x), options_.solver);
    fit_.solution.iterations += before.iterations;
    fit_.solution.evaluations += before.evaluations;
    fit_.solution.jacobian_evaluations += before.jacobian_evaluations;
    return fit_.solution.status != LeastSquaresStatus::kFailed;
  }

  /// Of the readings alone, at the solution and by the weights as they are.
  WhitenedResidual residual(bool with_jacobian) {
    WhitenedResidual at;
    at.ok = with_priors_->evaluate(fit_.solution.x, at.r, with_jacobian ? &at.jacobian : nullptr, &at.error);
    if (!at.ok) return at;
    at.r.conservativeResize(fit_.weights.rows);
    if (with_jacobian) at.jacobian.conservativeResize(fit_.weights.rows, Eigen::NoChange);
    return at;
  }

  /// Of the readings by their stated noise alone.
  [[nodiscard]] double statedChi2() const {
    if (fit_.weights.model_error == 0) return comparable(fit_.residual.r);
    const ReadingWeights stated = reweighted(fit_.weights, readings_, 0, fit_.factors);
    return comparable(
        whitenedResidual(start_, unknowns_, readings_, stated, fit_.solution.x, false, options_.solver.stop).r);
  }

  /// Squares of which a robust loss has left a share, made comparable with their degrees of freedom.
  [[nodiscard]] double comparable(const VectorXd& r) const {
    if (options_.loss == RobustLoss::kNone) return r.squaredNorm();
    std::map<int, double> left;
    double chi2 = 0;
    for (std::size_t k = 0; k < readings_.size(); ++k) {
      const int rows = rowsOf(readings_[k]);
      if (!left.contains(rows)) left[rows] = shareLeft(rows, options_.loss);
      chi2 += r.segment(fit_.weights.first_row[k], rows).squaredNorm() / left[rows];
    }
    return chi2;
  }

  /// Encoders' noise reaches a reading by the posture's slopes, and a robust weight by the residual: both follow the
  /// solution.
  bool untilWeightsRest() {
    const bool is_robust = options_.loss != RobustLoss::kNone;
    const int rounds = is_robust ? 5 * kMaxRounds : kMaxRounds;
    double before = std::numeric_limits<double>::quiet_NaN();
    for (int round = 0; round < rounds; ++round) {
      if (!weigh(round == 0)) return false;
      if (round > 0 && !is_robust) {
        const double now = residual(false).r.squaredNorm();
        if (std::abs(now - before) <= kWeightsRest * std::max(now, 1.)) break;
      }
      if (!minimize()) return false;
      const WhitenedResidual at = residual(false);
      if (!at.ok) return failed("the model cannot be evaluated at the readings");
      before = at.r.squaredNorm();
      if (!is_robust) continue;
      const VectorXd factors = robustFactors(readings_, fit_.weights, at, fit_.factors, options_.loss);
      const bool rest = fit_.factors.size() && (factors - fit_.factors).cwiseAbs().maxCoeff() < 1e-3;
      fit_.factors = factors;
      if (rest) break;
    }
    if (is_robust) fit_.weights = reweighted(fit_.weights, readings_, fit_.weights.model_error, fit_.factors);
    return true;
  }

  /// Residual, covariance and chi-square at the solution.
  bool describe() {
    fit_.residual = residual(true);
    if (!fit_.residual.ok || !fit_.residual.r.allFinite() || !fit_.residual.jacobian.allFinite())
      return failed("the model cannot be differentiated at the readings");
    fit_.solution.chi2 = fit_.residual.r.squaredNorm();
    fit_.covariance = posteriorCovariance(fit_.residual.jacobian, unknowns_);
    fit_.degrees_of_freedom = fit_.weights.degrees_of_freedom - numbersDetermined(fit_.covariance, unknowns_);
    fit_.chi2 = statedChi2();
    fit_.p_value = chiSquareTail(fit_.chi2, fit_.degrees_of_freedom);
    if (fit_.solution.status == LeastSquaresStatus::kIterationLimit && distanceToMinimum() < kNearMinimum) {
      fit_.solution.status = LeastSquaresStatus::kConverged;
      fit_.solution.reason = "the minimum is nearer than the noise lets it be known";
    }
    return true;
  }

  /// What chi-square is expected to fall by yet, to second order: gradient^T covariance gradient. One is a step of one
  /// standard deviation.
  [[nodiscard]] double distanceToMinimum() const {
    const VectorXd gradient = fit_.residual.jacobian.transpose() * fit_.residual.r +
                              priorSlopes(unknowns_).cwiseProduct(priorResiduals(unknowns_, fit_.solution.x));
    return gradient.dot(fit_.covariance * gradient);
  }

  const PlacedArm& start_;
  const std::vector<Unknown>& unknowns_;
  const std::vector<Measurement>& readings_;
  const FitOptions& options_;
  Fit fit_;
  std::shared_ptr<CampaignResidual> with_priors_;  ///< by the weights of `fit_`, whatever they become
};

}  // namespace

Fit fitUnknowns(const PlacedArm& start, const std::vector<Unknown>& unknowns, const std::vector<Measurement>& readings,
                const VectorXd& x, const FitOptions& options) {
  return Fitting(start, unknowns, readings, x, options).run();
}

namespace {

/// Errors of readings against their noise and a further variance of every coordinate.
class ErrorVariance {
 public:
  ErrorVariance(const std::vector<Measurement>& readings, const ReadingWeights& weights, const VectorXd& error) {
    for (std::size_t k = 0; k < readings.size(); ++k) {
      const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(weights.noise[k]);
      noise_.push_back(axes.eigenvalues().cwiseMax(0));
      squares_.push_back(
          (axes.eigenvectors().transpose() * error.segment(weights.first_row[k], rowsOf(readings[k]))).cwiseAbs2());
    }
  }

  /// The square of a reading's error in units of its variance, over its rows.
  [[nodiscard]] double meanSquare(std::size_t reading, double variance) const {
    return (squares_[reading].array() / (noise_[reading].array() + variance)).mean();
  }

  /// The variance at which `size(variance)`, which falls with it, comes down to nothing.
  template <class Size>
  [[nodiscard]] double solve(const Size& size) const {
    if (!(size(0.) > 0)) return 0;
    double low = 0, high = 0;
    for (const auto& squares : squares_) high = std::max(high, squares.maxCoeff());
    for (high *= 4; size(high) > 0; high *= 4) low = high;
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      (size(middle) > 0 ? low : high) = middle;
    }
    return high;
  }

  /// Median over the readings of the mean square, each in units of what normal noise makes of it.
  [[nodiscard]] double usualSquare(double variance) const {
    std::vector<double> squares;
    for (std::size_t k = 0; k < squares_.size(); ++k)
      squares.push_back(meanSquare(k, variance) / medianOfMeanSquare(static_cast<int>(squares_[k].size())));
    return median(std::move(squares));
  }

 private:
  std::vector<VectorXd> noise_, squares_;
};

}  // namespace

double modelErrorOf(const std::vector<Measurement>& readings, const ReadingWeights& weights, const VectorXd& error,
                    int degrees_of_freedom) {
  if (degrees_of_freedom <= 0) return 0;
  const ErrorVariance errors(readings, weights, error);
  // What most readings are off by says which are gross errors: those are no error of the model.
  const double usual = errors.solve([&](double v) { return errors.usualSquare(v) - 1; });
  std::map<int, double> limits;
  std::vector<std::size_t> kept;
  int freedom = degrees_of_freedom;
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const int rows = rowsOf(readings[k]);
    if (!limits.contains(rows)) limits[rows] = grossErrorLimit(readings.size(), rows);
    if (errors.meanSquare(k, usual) <= limits[rows])
      kept.push_back(k);
    else
      freedom -= rows;
  }
  if (freedom <= 0) return 0;
  const auto chi2At = [&](double variance) {
    double chi2 = 0;
    for (const std::size_t k : kept) chi2 += rowsOf(readings[k]) * errors.meanSquare(k, variance);
    return chi2;
  };
  if (!(chiSquareTail(chi2At(0), freedom) < kLackOfFit)) return 0;
  return std::sqrt(errors.solve([&](double v) { return chi2At(v) - freedom; }));
}

void alignBases(PlacedArm& placed, const std::vector<Measurement>& readings) {
  for (std::size_t p = 0; p < placed.base_poses.size(); ++p) {
    BasePose& base_pose = placed.base_poses[p];
    if (base_pose.is_known) continue;
    deflection::PreparedArm arm(placed.arm);
    for (int repeat = 0; repeat < kMostAlignments; ++repeat) {
      std::vector<Vector3d> tips, places;
      for (const auto& reading : readings) {
        if (reading.is_held_out || !statesPlace(reading) || basePoseOf(placed, reading) != static_cast<int>(p))
          continue;
        if (arm.solve(postureOf(reading, placed.arm, base_pose.X_WB)) != deflection::KinematicsStatus::kConverged)
          continue;
        tips.push_back(arm.X_BD().p);
        places.push_back(*reading.p_W);
      }
      if (tips.size() < 3) break;
      const auto n = static_cast<Index>(tips.size());
      const Eigen::Map<const Eigen::Matrix3Xd> from(tips.front().data(), 3, n), to(places.front().data(), 3, n);
      const Eigen::Matrix3Xd centred = from.colwise() - from.rowwise().mean();
      const auto spread = centred.jacobiSvd().singularValues();
      if (spread[1] < 1e-6 * spread[0]) break;  // all in one line: the turn about it cannot be told
      const Eigen::Isometry3d before = base_pose.X_WB;
      base_pose.X_WB = Eigen::Isometry3d(Eigen::umeyama(from, to, false));
      if ((base_pose.X_WB.matrix() - before.matrix()).norm() < kAligned) break;
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

}  // namespace tubeplan::calibration
