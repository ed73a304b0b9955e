#include "calibration/base_calibration.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "calibration/least_squares.hpp"
#include "calibration/touched_arm.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::calibration {

namespace {

constexpr double kLackOfFit = 0.01;  // p below which the stated noise is refused, as in every fit

using Eigen::Isometry3d, Eigen::Matrix3d, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

/// Best rigid placing of the arm's touched tips on the holes (Umeyama 1991, no scale); repeated, since the sag of the
/// tips depends on gravity's direction in the base, which the placing tells.
Isometry3d alignBase(TouchedArm& arm, const std::vector<Touch>& touches, Isometry3d X_WB, int repeats) {
  Eigen::Matrix3Xd tips(3, touches.size()), holes(3, touches.size());
  for (int n = 0; n < repeats; ++n) {
    for (std::size_t k = 0; k < touches.size(); ++k) {
      tips.col(static_cast<Eigen::Index>(k)) = arm.tipInBase(X_WB, touches[k], {}, false);
      holes.col(static_cast<Eigen::Index>(k)) = touches[k].p_WH;
    }
    const Isometry3d before = X_WB;
    X_WB.matrix() = Eigen::umeyama(tips, holes, false);
    if ((X_WB.matrix() - before.matrix()).norm() < 1e-9) break;
  }
  return X_WB;
}

/// Rows of one touch: whitened misfit and its derivative by the base step at zero.
struct WhitenedTouch {
  bool ok = false;
  Vector3d residual;
  Eigen::Matrix<double, 3, 6> jacobian;
};

using Whitener = Matrix3d;  // inverse of the lower Cholesky factor of a touch's covariance

WhitenedTouch whitenedTouch(TouchedArm& arm, const Isometry3d& X_WB, const Touch& touch, const Whitener& whitener) {
  const TipInWorld tip = arm.tipInWorld(X_WB, touch.q, touch.load);
  return {tip.ok, whitener * (tip.p_WT - touch.p_WH), whitener * tip.by_base};
}

/// The misfit alone, NaN where the shape does not settle: what a solver asks at every trial point.
Vector3d whitenedMisfit(TouchedArm& arm, const Isometry3d& X_WB, const Touch& touch, const Whitener& whitener) {
  return whitener * (X_WB * arm.tipInBase(X_WB, touch, {1e-12, 100}, true) - touch.p_WH);
}

std::vector<Whitener> whitenersAt(TouchedArm& arm, const Isometry3d& X_WB, const std::vector<Touch>& touches,
                                  double model_sigma) {
  std::vector<Whitener> whiteners;
  for (const auto& touch : touches) {
    const Matrix3d covariance =
        touchCovariance(arm.arm(), arm.tipInWorld(X_WB, touch.q, touch.load), std::hypot(touch.sigma, model_sigma));
    whiteners.push_back(covariance.llt().matrixL().solve(Matrix3d::Identity()));
  }
  return whiteners;
}

/// d(exp(w + e)) = exp(J e) exp(w): the left Jacobian of the rotation, so that steps away from zero have exact
/// derivatives.
Matrix3d leftJacobian(const Vector3d& w) {
  const double t = w.norm();
  Matrix3d K;
  K << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  if (t < 1e-6) return Matrix3d::Identity() + K / 2;
  return Matrix3d::Identity() + (1 - std::cos(t)) / (t * t) * K + (t - std::sin(t)) / (t * t * t) * K * K;
}

LeastSquaresProblem baseProblem(TouchedArm& arm, const std::vector<Touch>& touches, const Isometry3d& X_WB,
                                const std::vector<Whitener>& whiteners) {
  LeastSquaresProblem problem;
  const double infinity = std::numeric_limits<double>::infinity();
  problem.start = VectorXd::Zero(6);
  problem.lower = VectorXd::Constant(6, -infinity);
  problem.upper = VectorXd::Constant(6, infinity);
  problem.scale = VectorXd::Constant(6, 1e-3);
  problem.scale.tail<3>() /= deflection::reachOf(arm.arm());
  problem.evaluate = [&arm, &touches, &whiteners, X_WB](const VectorXd& x, VectorXd& r, MatrixXd* jacobian) {
    r.resize(3 * static_cast<Eigen::Index>(touches.size()));
    if (jacobian) jacobian->resize(r.size(), 6);
    const Isometry3d X = moved(X_WB, x);
    for (std::size_t k = 0; k < touches.size(); ++k) {
      if (!jacobian) {
        r.segment<3>(3 * static_cast<Eigen::Index>(k)) = whitenedMisfit(arm, X, touches[k], whiteners[k]);
        continue;
      }
      const WhitenedTouch row = whitenedTouch(arm, X, touches[k], whiteners[k]);
      if (!row.ok) return false;
      r.segment<3>(3 * static_cast<Eigen::Index>(k)) = row.residual;
      jacobian->block<3, 3>(3 * static_cast<Eigen::Index>(k), 0) = row.jacobian.leftCols<3>();
      jacobian->block<3, 3>(3 * static_cast<Eigen::Index>(k), 3) =
          row.jacobian.rightCols<3>() * leftJacobian(x.tail<3>());
    }
    return true;
  };
  return problem;
}

struct BaseFit {
  LeastSquaresResult solution;
  Isometry3d X_WB;
  double p_value = 0;
};

/// Weights are taken at the aligned pose: encoder noise through the Jacobian changes little after it.
BaseFit fitBase(TouchedArm& arm, const std::vector<Touch>& touches, const Isometry3d& aligned, double model_sigma,
                LeastSquaresMethod method) {
  const auto whiteners = whitenersAt(arm, aligned, touches, model_sigma);
  BaseFit fit;
  fit.solution = minimizeLeastSquares(baseProblem(arm, touches, aligned, whiteners), {.method = method});
  fit.X_WB = moved(aligned, fit.solution.x);
  const double freedom = 3. * static_cast<double>(touches.size()) - 6;
  if (std::isfinite(fit.solution.chi2))
    fit.p_value =
        boost::math::cdf(boost::math::complement(boost::math::chi_squared(freedom), std::max(fit.solution.chi2, 0.)));
  return fit;
}

Eigen::Matrix<double, 6, 6> baseCovariance(TouchedArm& arm, const std::vector<Touch>& touches, const Isometry3d& X_WB) {
  Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();
  const auto whiteners = whitenersAt(arm, X_WB, touches, 0);
  for (std::size_t k = 0; k < touches.size(); ++k) {
    const WhitenedTouch row = whitenedTouch(arm, X_WB, touches[k], whiteners[k]);
    information += row.jacobian.transpose() * row.jacobian;
  }
  return information.inverse();
}

void recordResiduals(TouchedArm& arm, const std::vector<Touch>& touches, BaseCalibration& result) {
  std::vector<TipInWorld> tips;
  double sum = 0;
  for (const auto& touch : touches) {
    tips.push_back(arm.tipInWorld(result.X_WB, touch.q, touch.load));
    const Vector3d residual = tips.back().p_WT - touch.p_WH;
    result.residuals.push_back(
        {touch.id, touch.hole, residual, touchCovariance(arm.arm(), tips.back(), touch.sigma).diagonal().cwiseSqrt()});
    sum += residual.squaredNorm();
  }
  result.rms = std::sqrt(sum / static_cast<double>(touches.size()));
  for (std::size_t i = 0; i < touches.size(); ++i)
    for (std::size_t j = i + 1; j < touches.size(); ++j) {
      if (touches[i].hole == touches[j].hole) continue;
      const Vector3d along = (touches[j].p_WH - touches[i].p_WH).normalized();
      const Matrix3d both =
          touchCovariance(arm.arm(), tips[i], touches[i].sigma) + touchCovariance(arm.arm(), tips[j], touches[j].sigma);
      result.distances.push_back({touches[i].hole, touches[j].hole, (tips[j].p_WT - tips[i].p_WT).norm(),
                                  (touches[j].p_WH - touches[i].p_WH).norm(), std::sqrt(along.dot(both * along))});
    }
}

/// Each touch in turn is taken for each of its neighbours; those that make the touches fit are named, best first.
std::vector<std::string> findMistakenHoles(TouchedArm& arm, const std::vector<Touch>& touches, const Isometry3d& X_WB,
                                           double chi2, const BaseCalibrationOptions& options) {
  std::vector<std::pair<double, std::string>> found;
  for (std::size_t k = 0; k < touches.size(); ++k)
    for (const auto& neighbour : touches[k].neighbours) {
      std::vector<Touch> supposed = touches;
      supposed[k].p_WH = neighbour.p_WH;
      const BaseFit fit =
          fitBase(arm, supposed, alignBase(arm, supposed, X_WB, 3), options.model_sigma, options.method);
      if (fit.p_value > 0.01 && fit.solution.chi2 < chi2 / 4)
        found.emplace_back(fit.solution.chi2,
                           "touch " + touches[k].id + " named " + touches[k].hole + " fits hole " + neighbour.name);
    }
  std::sort(found.begin(), found.end());
  std::vector<std::string> names;
  for (auto& [fit, name] : found) names.push_back(name);
  return names;
}

BaseStep stepBetween(const Isometry3d& from, const Isometry3d& to) {
  const Eigen::AngleAxisd turn(Matrix3d(to.linear() * from.linear().transpose()));
  BaseStep step;
  step << to.translation() - from.translation(), turn.angle() * turn.axis();
  return step;
}

BaseCalibration refused(std::string reason) {
  BaseCalibration result;
  result.status = CalibrationStatus::kRefused;
  result.reason = std::move(reason);
  return result;
}

/// Looks at a misfit that noise and the model's usual error cannot explain.
bool isMistaken(TouchedArm& arm, const std::vector<Touch>& touches, const BaseCalibrationOptions& options,
                BaseCalibration& result) {
  if (result.p_value >= options.mistaken_hole_p_value) return false;
  const BaseFit tolerant = fitBase(arm, touches, result.X_WB, options.model_sigma, options.method);
  if (tolerant.p_value >= options.mistaken_hole_p_value) return false;
  result.suspects = findMistakenHoles(arm, touches, result.X_WB, tolerant.solution.chi2, options);
  if (result.suspects.empty()) {
    result.reason =
        "the touches fit neither the holes they name nor any of their neighbours: check the hole names, the arm file "
        "and the load";
  } else {
    result.reason = "a hole was mistaken for its neighbour: " + result.suspects.front();
    for (std::size_t k = 1; k < std::min<std::size_t>(result.suspects.size(), 3); ++k)
      result.reason += "; or " + result.suspects[k];
  }
  result.status = CalibrationStatus::kRefused;
  return true;
}

}  // namespace

Eigen::Matrix<double, 6, 6> widenedCovariance(const BaseCalibration& calibration) {
  return calibration.covariance * std::max(1., calibration.chi2 / std::max(1, calibration.degrees_of_freedom));
}

bool isFitRefused(const BaseCalibration& calibration) { return calibration.p_value < kLackOfFit; }

BaseCalibration calibrateBase(const deflection::Arm& given, const std::vector<Touch>& touches,
                              const Isometry3d& X_WB_start, const BaseCalibrationOptions& options) {
  if (const std::string problem = findTouchProblem(touches, options); !problem.empty()) return refused(problem);
  TouchedArm arm(given);
  const BaseFit fit = fitBase(arm, touches, alignBase(arm, touches, X_WB_start, options.alignments), 0, options.method);
  BaseCalibration result;
  result.X_WB = fit.X_WB;
  result.chi2 = fit.solution.chi2;
  result.p_value = fit.p_value;
  result.degrees_of_freedom = 3 * static_cast<int>(touches.size()) - 6;
  result.iterations = fit.solution.iterations;
  result.from_start = stepBetween(X_WB_start, fit.X_WB);
  if (fit.solution.status != LeastSquaresStatus::kConverged) {
    result.status = CalibrationStatus::kNotConverged;
    result.reason = fit.solution.reason;
    return result;
  }
  recordResiduals(arm, touches, result);
  if (isMistaken(arm, touches, options, result)) return result;
  result.covariance = baseCovariance(arm, touches, result.X_WB);
  result.status = CalibrationStatus::kDone;
  return result;
}

}  // namespace tubeplan::calibration
