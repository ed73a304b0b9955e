#include "calibration/estimation/base_calibration.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "calibration/estimation/fit.hpp"
#include "calibration/statistics.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::calibration {

namespace {

using Eigen::Isometry3d, Eigen::Matrix3d, Eigen::Vector3d, Eigen::VectorXd;

constexpr double kSupposedFits = 0.01;    // p of touches by a supposed hole, from which it may be the right one
constexpr double kFarBetter = 0.25;       // of chi-square, which a supposed hole must leave at most
constexpr std::size_t kMostSuspects = 3;  // suspects in a sentence

struct BaseFit {
  Fit fit;
  Isometry3d X_WB;
};

BaseFit fitBase(const deflection::Arm& arm, const std::vector<Measurement>& touches, const Isometry3d& X_WB_start,
                std::optional<double> model_error, LeastSquaresMethod method) {
  PlacedArm start = placeForReadings(arm, X_WB_start, false, touches);
  alignBases(start, touches);
  const auto unknowns = chooseUnknowns(start, {}).list;
  FitOptions options;
  options.solver.method = method;
  options.model_error = model_error;
  BaseFit base{fitUnknowns(start, unknowns, touches, VectorXd::Zero(6), options), {}};
  base.X_WB = applied(start, unknowns, base.fit.solution.x).base_poses.front().X_WB;
  return base;
}

/// By the touches as weighted, the model's supposed error among their noise.
double pValueOf(const BaseFit& base) {
  return chiSquareTail(base.fit.solution.chi2, base.fit.weights.degrees_of_freedom - 6);
}

void recordResiduals(const Fit& fit, const std::vector<Measurement>& touches, BaseCalibration& result) {
  double sum = 0;
  for (std::size_t k = 0; k < touches.size(); ++k) {
    const Vector3d residual = fit.residual.error.segment<3>(fit.weights.first_row[k]);
    const Vector3d sigma = fit.weights.noise[k].diagonal().cwiseSqrt();
    result.residuals.push_back({touches[k].id, touches[k].point, residual, sigma});
    sum += residual.squaredNorm();
  }
  result.rms = std::sqrt(sum / static_cast<double>(touches.size()));
}

/// Between the tips of every two touches, beside those of their holes.
void recordDistances(const Fit& fit, const std::vector<Measurement>& touches, BaseCalibration& result) {
  for (std::size_t i = 0; i < touches.size(); ++i)
    for (std::size_t j = i + 1; j < touches.size(); ++j) {
      if (touches[i].point == touches[j].point) continue;
      const Vector3d between = *touches[j].p_W - *touches[i].p_W, along = between.normalized();
      const Vector3d measured = between + result.residuals[j].residual_W - result.residuals[i].residual_W;
      const Matrix3d both = fit.weights.noise[i] + fit.weights.noise[j];
      result.distances.push_back(
          {touches[i].point, touches[j].point, measured.norm(), between.norm(), std::sqrt(along.dot(both * along))});
    }
}

/// Each touch in turn is taken for each of its neighbours; those that make the touches fit are named, best first.
std::vector<std::string> findMistakenHoles(const deflection::Arm& arm, const std::vector<Measurement>& touches,
                                           const Isometry3d& X_WB, double chi2, const BaseCalibrationOptions& options) {
  std::vector<std::pair<double, std::string>> found;
  for (std::size_t k = 0; options.neighbours && k < touches.size(); ++k)
    for (const auto& neighbour : options.neighbours(touches[k])) {
      std::vector<Measurement> supposed = touches;
      supposed[k].p_W = neighbour.p_WH;
      const BaseFit base = fitBase(arm, supposed, X_WB, options.model_sigma, options.method);
      if (pValueOf(base) > kSupposedFits && base.fit.solution.chi2 < chi2 * kFarBetter)
        found.emplace_back(base.fit.solution.chi2,
                           "touch " + touches[k].id + " named " + touches[k].point + " fits hole " + neighbour.name);
    }
  std::sort(found.begin(), found.end());
  std::vector<std::string> names;
  for (auto& [fit, name] : found) names.push_back(name);
  return names;
}

/// From the covariance of the solver's rotation vector, which starts at the aligned base, to that of a turn from where
/// the base was found.
Eigen::Matrix<double, 6, 6> ofStep(const Fit& fit) {
  Eigen::Matrix<double, 6, 6> step = Eigen::Matrix<double, 6, 6>::Identity();
  step.bottomRightCorner<3, 3>() = deflection::leftJacobian(fit.solution.x.tail<3>());
  return step * fit.covariance * step.transpose();
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

/// Looks at a lack of fit that noise and the model's usual error cannot explain.
bool isMistaken(const deflection::Arm& arm, const std::vector<Measurement>& touches,
                const BaseCalibrationOptions& options, BaseCalibration& result) {
  if (!(result.p_value < options.mistaken_hole_p_value)) return false;
  const BaseFit tolerant = fitBase(arm, touches, result.X_WB, options.model_sigma, options.method);
  if (!(pValueOf(tolerant) < options.mistaken_hole_p_value)) return false;
  result.suspects = findMistakenHoles(arm, touches, result.X_WB, tolerant.fit.solution.chi2, options);
  if (result.suspects.empty()) {
    result.reason =
        "the touches fit neither the holes they name nor any of their neighbours: check the hole names, the arm file "
        "and the load";
  } else {
    result.reason = "a hole was mistaken for its neighbour: " + result.suspects.front();
    for (std::size_t k = 1; k < std::min(result.suspects.size(), kMostSuspects); ++k)
      result.reason += "; or " + result.suspects[k];
  }
  result.status = CalibrationStatus::kRefused;
  return true;
}

BaseCalibration described(const BaseFit& base, const Isometry3d& X_WB_start) {
  BaseCalibration result;
  result.X_WB = base.X_WB;
  result.chi2 = base.fit.chi2;
  result.p_value = base.fit.p_value;
  result.model_error = base.fit.weights.model_error;
  result.degrees_of_freedom = base.fit.degrees_of_freedom;
  result.iterations = base.fit.solution.iterations;
  result.from_start = stepBetween(X_WB_start, base.X_WB);
  return result;
}

/// Of touches that do not fit: the only one without which the others do.
void findOddTouch(const deflection::Arm& arm, const std::vector<Measurement>& touches,
                  const BaseCalibrationOptions& options, BaseCalibration& result) {
  constexpr std::size_t kLeast = 4;  // three alone fit what they will
  if (!isFitRefused(result) || touches.size() < kLeast) return;
  std::vector<std::pair<int, double>> found;  // touches without which the others fit, and the others' rms
  for (int k = 0; k < static_cast<int>(touches.size()); ++k) {
    const auto others = withoutReadings(touches, {k});
    if (!findTouchProblem(others, options).empty()) continue;
    const BaseFit base = fitBase(arm, others, result.X_WB, options.model_error, options.method);
    if (base.fit.p_value >= kLackOfFit)
      found.emplace_back(k, errorSize(others, base.fit.weights, base.fit.residual.error).rms);
  }
  if (found.size() == 1) std::tie(result.odd_touch, result.rms_of_others) = found.front();
}

}  // namespace

bool isFitRefused(const BaseCalibration& calibration) { return calibration.p_value < kLackOfFit; }

BaseCalibration calibrateBase(const deflection::Arm& arm, const std::vector<Measurement>& touches,
                              const Isometry3d& X_WB_start, const BaseCalibrationOptions& options) {
  if (const std::string problem = findTouchProblem(touches, options); !problem.empty()) return refused(problem);
  const BaseFit base = fitBase(arm, touches, X_WB_start, options.model_error, options.method);
  BaseCalibration result = described(base, X_WB_start);
  if (base.fit.solution.status != LeastSquaresStatus::kConverged) {
    result.status = CalibrationStatus::kNotConverged;
    result.reason = base.fit.solution.reason;
    return result;
  }
  recordResiduals(base.fit, touches, result);
  recordDistances(base.fit, touches, result);
  if (isMistaken(arm, touches, options, result)) return result;
  findOddTouch(arm, touches, options, result);
  result.covariance = ofStep(base.fit);
  result.status = CalibrationStatus::kDone;
  return result;
}

}  // namespace tubeplan::calibration
