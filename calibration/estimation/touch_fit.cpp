#include "calibration/estimation/touch_fit.hpp"

#include <cmath>

#include "calibration/estimation/fit.hpp"
#include "calibration/estimation/prior.hpp"
#include "calibration/measurements/measurement_placement.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/statistics.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::Isometry3d, Eigen::Matrix3d, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

namespace {

constexpr double kWidestBound = 8;  // bound on the standard normal variables in a fit [standard deviations]
constexpr int kModelErrorRounds = 24;

/// Least-squares problem of fitting a base and the arm's uncertain parameters to touches. The variables x are the base
/// step, then the standard normal variables z of the parameters.
class TouchProblem {
 public:
  TouchProblem(const deflection::Arm& arm, const UncertainNumbers& numbers, const std::vector<Measurement>& touches,
               const Isometry3d& X_WB)
      : arm_(arm), numbers_(numbers), touches_(touches), X_WB_(X_WB) {
    for (const auto& unknown : numbers.unknowns) request_.numbers.push_back(deflection::Variable::number(unknown.path));
    request_.by_base = request_.by_joints = true;
  }

  [[nodiscard]] Index variables() const { return 6 + numbers_.root.cols(); }
  [[nodiscard]] Index rows() const { return 3 * static_cast<Index>(touches_.size()); }

  [[nodiscard]] Isometry3d baseAt(const VectorXd& x) const { return moved(X_WB_, x.head<6>()); }
  [[nodiscard]] deflection::Arm armAt(const VectorXd& x) const {
    deflection::Arm arm = arm_;
    const VectorXd values = numbers_.root * x.tail(x.size() - 6);
    for (std::size_t k = 0; k < numbers_.unknowns.size(); ++k)
      deflection::locate(arm, numbers_.unknowns[k].path) = valueAt(numbers_.unknowns[k], values[static_cast<Index>(k)]);
    return arm;
  }

  /// Computes the covariance of each touch at x due to its own noise and encoder noise, and its whitener L^-1, which
  /// also includes the model error. Returns false if the arm's deflected shape does not converge.
  bool weigh(const VectorXd& x, double model_error) {
    const deflection::Arm arm = armAt(x);
    const Isometry3d X_WB = baseAt(x);
    MeasurementPredictor predictor(arm);
    PredictionRequest by_joints;
    by_joints.by_joints = true;
    noise_.clear();
    whitener_.clear();
    for (const Measurement& touch : touches_) {
      const Prediction tip = predictor.predict(X_WB, touch, by_joints);
      if (!tip.ok) return false;
      noise_.emplace_back(measurementCovariance(arm, touch, tip.by_joints));
      const Matrix3d covariance = noise_.back() + model_error * model_error * Matrix3d::Identity();
      whitener_.emplace_back(covariance.llt().matrixL().solve(Matrix3d::Identity()));
    }
    return true;
  }

  /// Computes the residuals, which are the whitened errors followed by the prior residuals z, and their Jacobian if
  /// `jacobian` is not null; also the errors in metres if `error` is not null.
  bool evaluate(const VectorXd& x, VectorXd& r, MatrixXd* jacobian, Eigen::Matrix3Xd* error = nullptr) const {
    const deflection::Arm arm = armAt(x);
    const Isometry3d X_WB = baseAt(x);
    MeasurementPredictor predictor(arm);
    const Index numbers = x.size() - 6;
    r.resize(rows() + numbers);
    r.tail(numbers) = x.tail(numbers);
    if (jacobian) {
      jacobian->setZero(r.size(), x.size());
      jacobian->bottomRightCorner(numbers, numbers).setIdentity();
    }
    const MatrixXd by_z = jacobian ? numberSlopes(x) * numbers_.root : MatrixXd();
    const Matrix3d turn = deflection::leftJacobian(Vector3d(x.segment<3>(3)));
    for (std::size_t k = 0; k < touches_.size(); ++k) {
      const Prediction tip = predictor.predict(X_WB, touches_[k], jacobian ? request_ : PredictionRequest{});
      if (!tip.ok) return false;
      const auto row = 3 * static_cast<Index>(k);
      const Vector3d off = tip.value - *touches_[k].p_W;
      if (error) error->col(static_cast<Index>(k)) = off;
      r.segment<3>(row) = whitener_[k] * off;
      if (!jacobian) continue;
      jacobian->block(row, 0, 3, 3) = whitener_[k] * tip.by_base.leftCols(3);
      jacobian->block(row, 3, 3, 3) = whitener_[k] * tip.by_base.rightCols(3) * turn;
      if (numbers) jacobian->block(row, 6, 3, numbers) = whitener_[k] * tip.by_numbers * by_z;
    }
    return true;
  }

  [[nodiscard]] LeastSquaresProblem problem(const VectorXd& start) const {
    LeastSquaresProblem problem;
    problem.start = start;
    problem.scale = VectorXd::Ones(variables());
    problem.scale.head<3>().setConstant(deflection::reachOf(arm_));
    problem.upper = VectorXd::Constant(variables(), kWidestBound);
    problem.upper.head<6>().setConstant(std::numeric_limits<double>::infinity());
    problem.lower = -problem.upper;
    problem.evaluate = [this](const VectorXd& x, VectorXd& r, MatrixXd* jacobian) { return evaluate(x, r, jacobian); };
    return problem;
  }

  /// Returns the joint covariance of the base step, relative to the fitted pose, and of the parameters' variables,
  /// given the Jacobian at x.
  [[nodiscard]] MatrixXd covarianceAt(const VectorXd& x, const MatrixXd& jacobian) const {
    const Index n = numbers_.root.rows();
    MatrixXd back = MatrixXd::Zero(6 + n, variables());
    back.topLeftCorner<3, 3>().setIdentity();
    back.block<3, 3>(3, 3) = deflection::leftJacobian(Vector3d(x.segment<3>(3)));
    back.bottomRightCorner(n, numbers_.root.cols()) = numbers_.root;
    return back * inverseOfInformation(jacobian.transpose() * jacobian) * back.transpose();
  }

  [[nodiscard]] const std::vector<Matrix3d>& noise() const { return noise_; }

  [[nodiscard]] std::vector<Unknown> unknownsAt(const VectorXd& x) const {
    std::vector<Unknown> unknowns;
    const VectorXd values = numbers_.root * x.tail(x.size() - 6);
    for (std::size_t k = 0; k < numbers_.unknowns.size(); ++k)
      unknowns.push_back(rebased(numbers_.unknowns[k], valueAt(numbers_.unknowns[k], values[static_cast<Index>(k)])));
    return unknowns;
  }

 private:
  /// Returns the derivative of each parameter's value with respect to its variable, as a diagonal matrix.
  [[nodiscard]] Eigen::DiagonalMatrix<double, Eigen::Dynamic> numberSlopes(const VectorXd& x) const {
    VectorXd slopes = numbers_.root * x.tail(x.size() - 6);
    for (Index k = 0; k < slopes.size(); ++k)
      slopes[k] = slopeAt(numbers_.unknowns[static_cast<std::size_t>(k)], slopes[k]);
    return Eigen::DiagonalMatrix<double, Eigen::Dynamic>(slopes);
  }

  const deflection::Arm& arm_;
  const UncertainNumbers& numbers_;
  const std::vector<Measurement>& touches_;
  Isometry3d X_WB_;
  PredictionRequest request_;
  std::vector<Matrix3d> noise_, whitener_;
};

constexpr const char* kTooCompliant =
    "the model cannot be evaluated at the touches: the arm is too compliant for its load";

/// Minimises twice, because the weights depend on x: the second pass uses the weights at the first minimum.
bool minimize(TouchProblem& problem, double model_error, LeastSquaresMethod method, VectorXd& x, TouchFit& fit) {
  for (int round = 0; round < 2; ++round) {
    if (!problem.weigh(x, model_error)) {
      fit.status = LeastSquaresStatus::kFailed;
      fit.reason = kTooCompliant;
      return false;
    }
    LeastSquaresOptions solver;
    solver.method = method;
    const LeastSquaresResult found = minimizeLeastSquares(problem.problem(x), solver);
    fit.iterations += found.iterations;
    fit.status = found.status;
    fit.reason = found.reason;
    if (found.status != LeastSquaresStatus::kConverged) return false;
    x = found.x;
    fit.chi2 = found.chi2;
  }
  fit.model_error = model_error;
  return true;
}

/// Searches for the model error at which chi-square equals its degrees of freedom, with a new fit for each trial value.
bool findModelError(TouchProblem& problem, LeastSquaresMethod method, VectorXd& x, TouchFit& fit) {
  const double refused = fit.chi2;
  double low = fit.model_error, high = low + fit.error_W.norm() / std::sqrt(static_cast<double>(fit.error_W.size()));
  bool is_above = false;
  for (int round = 0; round < kModelErrorRounds && !(is_above && high - low < 0.01 * high); ++round) {
    const double middle = is_above ? (low + high) / 2 : high;
    if (!minimize(problem, middle, method, x, fit)) return false;
    if (fit.chi2 > fit.degrees_of_freedom)
      low = middle, high = is_above ? high : 2 * high;
    else
      high = middle, is_above = true;
  }
  fit.chi2 = refused;
  fit.is_model_error_found = true;
  return true;
}

void describe(const TouchProblem& problem, const VectorXd& x, TouchFit& fit) {
  VectorXd r;
  MatrixXd jacobian;
  fit.error_W.resize(3, problem.rows() / 3);
  if (!problem.evaluate(x, r, &jacobian, &fit.error_W)) {
    fit.status = LeastSquaresStatus::kFailed;
    fit.reason = kTooCompliant;
    return;
  }
  fit.X_WB = problem.baseAt(x);
  fit.arm = problem.armAt(x);
  fit.noise = problem.noise();
  fit.uncertainty = {problem.unknownsAt(x), problem.covarianceAt(x, jacobian)};
}

}  // namespace

TouchFit fitTouches(const deflection::Arm& arm, const UncertainNumbers& numbers,
                    const std::vector<Measurement>& touches, const Isometry3d& X_WB_start,
                    const TouchFitOptions& options) {
  PlacedArm aligned = placeForMeasurements(arm, X_WB_start, false, touches);
  alignBases(aligned, touches);
  TouchProblem problem(arm, numbers, touches, aligned.base_poses.front().X_WB);
  TouchFit fit;
  fit.degrees_of_freedom = static_cast<int>(problem.rows()) - 6;
  VectorXd x = VectorXd::Zero(problem.variables());
  if (!minimize(problem, options.model_error, options.method, x, fit)) return fit;
  fit.p_value = chiSquareTail(fit.chi2, fit.degrees_of_freedom);
  describe(problem, x, fit);
  const bool is_refused = fit.p_value < kLackOfFit;
  if (is_refused && options.finds_model_error && findModelError(problem, options.method, x, fit))
    describe(problem, x, fit);
  return fit;
}

std::optional<JointUncertainty> uncertaintyByTouches(const deflection::Arm& arm, const Isometry3d& X_WB,
                                                     const UncertainNumbers& numbers,
                                                     const std::vector<Measurement>& touches, double model_error) {
  TouchProblem problem(arm, numbers, touches, X_WB);
  const VectorXd x = VectorXd::Zero(problem.variables());
  VectorXd r;
  MatrixXd jacobian;
  if (!problem.weigh(x, model_error) || !problem.evaluate(x, r, &jacobian)) return std::nullopt;
  return JointUncertainty{numbers.unknowns, problem.covarianceAt(x, jacobian)};
}

}  // namespace tubeplan::calibration
