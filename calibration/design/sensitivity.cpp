#include "calibration/design/sensitivity.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <cmath>

#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

using deflection::Quantity;
using Eigen::Index, Eigen::Matrix3d, Eigen::Matrix3Xd, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kNumberStep = 1e-3;  // step of central differences, as a fraction of the parameter's value

NumberKind numberKindOf(Quantity quantity) {
  switch (quantity) {
    case Quantity::kTorquePerAngle:
    case Quantity::kPressure:
    case Quantity::kLengthToTheFourth:
      return NumberKind::kStiffness;
    case Quantity::kForce:
    case Quantity::kForcePerLength:
      return NumberKind::kWeight;
    case Quantity::kLength:
      return NumberKind::kLength;
    default:
      return NumberKind::kOther;
  }
}

Measurement tipAt(const VectorXd& q, double load) {
  Measurement tip;
  tip.q = q;
  tip.load = load;
  return tip;
}

/// Returns the projection of an error onto the components that contribute to the centring error.
Matrix3d countedPart(const SensitivityTask& task) {
  if (!task.hole_axis_W) return Matrix3d::Identity();
  return Matrix3d::Identity() - *task.hole_axis_W * task.hole_axis_W->transpose();
}

/// Positions of the rigid arm's tip, and displacements of the tip by deflection, at several postures, in world axes.
struct Deflections {
  bool ok = true;
  /// Vectors from the base to the rigid tip, and from the rigid to the deflected tip [m].
  std::vector<Vector3d> lever_W, deflection_W;
};

Deflections deflectionsAt(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                          const std::vector<VectorXd>& postures, double load) {
  Deflections result;
  for (const auto& q : postures) {
    const auto shape =
        deflection::solveFlexibleKinematics(arm, {q, load, deflection::gravityInBase(arm, X_WB)}, {1e-13, 100});
    result.ok = result.ok && shape.status == deflection::KinematicsStatus::kConverged;
    result.lever_W.push_back(X_WB.linear() * shape.X_BT.p);
    result.deflection_W.push_back(X_WB.linear() * (shape.X_BD.p - shape.X_BT.p));
  }
  return result;
}

/// Returns the 3 x 6 Jacobian of a point with respect to a small base motion (shift, then rotation); `lever` is the
/// vector from the base to the point.
Eigen::Matrix<double, 3, 6> motionBy(const Vector3d& lever) {
  Eigen::Matrix<double, 3, 6> motion;
  motion.leftCols<3>().setIdentity();
  motion.rightCols<3>() << 0, lever.z(), -lever.y(), -lever.z(), 0, lever.x(), lever.y(), -lever.x(), 0;
  return motion;
}

double meanLength(const std::vector<Vector3d>& errors, const Matrix3d& counted) {
  double sum = 0;
  for (const auto& error : errors) sum += (counted * error).norm();
  return sum / static_cast<double>(errors.size());
}

/// Predicted tip positions at several postures, with the requested derivatives; `ok` is false if the arm's deflected
/// shape does not converge at one of them.
struct Tips {
  bool ok = true;
  std::vector<Prediction> tips;
};

Tips tipsAt(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const std::vector<VectorXd>& postures,
            double load, const PredictionRequest& request) {
  Tips result;
  result.tips.resize(postures.size());
  tbb::parallel_for(std::size_t{0}, postures.size(), [&](std::size_t k) {
    result.tips[k] = predictMeasurement(arm, X_WB, tipAt(postures[k], load), request);
  });
  for (const auto& tip : result.tips) result.ok = result.ok && tip.ok;
  return result;
}

/// Returns the changes of the variables estimated by a touch calibration due to a unit error of each parameter, one
/// column per parameter. Empty if the touches do not determine the base; zero if there are no touches.
std::optional<MatrixXd> calibratedResponse(const Estimate& untouched, const SensitivityTask& task, const Tips& touches,
                                           Index numbers) {
  const Index all = untouched.information.rows();
  MatrixXd information = MatrixXd::Zero(all, all), right = MatrixXd::Zero(all, numbers);
  if (touches.tips.empty()) return right;
  Measurement touch;
  touch.sigma = task.touch_sigma;
  const auto slopes = tipSensitivities(untouched, task.touches, 0);
  for (std::size_t t = 0; t < slopes.size(); ++t) {
    const Prediction& tip = touches.tips[t];
    Matrix3d covariance = measurementCovariance(untouched.start.arm, touch, tip.by_joints);
    covariance.diagonal().array() += untouched.model_error * untouched.model_error;
    const MatrixXd weighted = covariance.ldlt().solve(slopes[t]);
    information += slopes[t].transpose() * weighted;
    right += weighted.transpose() * tip.by_numbers;
  }
  const Eigen::LDLT<Matrix6> base(information.topLeftCorner<6, 6>());
  if (base.vectorD().minCoeff() <= 1e-12 * base.vectorD().maxCoeff()) return std::nullopt;
  return -(untouched.information + information).ldlt().solve(right);
}

/// Sets the derivative of the mean deflection with respect to each parameter. At each work posture, it is the
/// difference between the derivatives of the deflected and the rigid tip, projected onto the deflection.
void addDeflection(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const SensitivityTask& task,
                   const Tips& work, std::vector<NumberSensitivity>& numbers) {
  const deflection::Arm rigid = deflection::rigidCopy(arm);
  PredictionRequest geometry;
  std::vector<std::size_t> index;
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    numbers[n].deflection = 0;
    if (numbers[n].kind != NumberKind::kLength && numbers[n].kind != NumberKind::kOther) continue;
    geometry.numbers.push_back(deflection::Variable::number(numbers[n].parameter.path));
    index.push_back(n);
  }
  const Tips straight = tipsAt(rigid, X_WB, task.work, task.load, geometry);
  for (std::size_t w = 0; w < task.work.size(); ++w) {
    const Vector3d along = (work.tips[w].value - straight.tips[w].value).stableNormalized();
    const double share = 1 / static_cast<double>(task.work.size());
    for (std::size_t n = 0; n < numbers.size(); ++n)
      numbers[n].deflection += share * along.dot(work.tips[w].by_numbers.col(static_cast<Index>(n)));
    for (std::size_t i = 0; i < index.size(); ++i)
      numbers[index[i]].deflection -= share * along.dot(straight.tips[w].by_numbers.col(static_cast<Index>(i)));
  }
}

void addUncompensated(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const SensitivityTask& task,
                      std::vector<NumberSensitivity>& numbers) {
  tbb::parallel_for(std::size_t{0}, numbers.size(), [&](std::size_t n) {
    const auto& parameter = numbers[n].parameter;
    const double step = kNumberStep * std::abs(parameter.value);
    if (step == 0) return;
    deflection::Arm more = arm, less = arm;
    deflection::locate(more, parameter.path) += step;
    deflection::locate(less, parameter.path) -= step;
    numbers[n].centring =
        (meanUncompensatedError(more, X_WB, task) - meanUncompensatedError(less, X_WB, task)) / (2 * step);
  });
}

void addErrors(const SensitivityTask& task, const Tips& work, const Estimate& untouched, const MatrixXd& response,
               std::vector<NumberSensitivity>& numbers) {
  const Matrix3d counted = countedPart(task);
  const auto slopes = tipSensitivities(untouched, task.work, task.load);
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    std::vector<Vector3d> known, placed;
    for (std::size_t w = 0; w < work.tips.size(); ++w) {
      known.emplace_back(work.tips[w].by_numbers.col(static_cast<Index>(n)));
      placed.emplace_back(known.back() + slopes[w] * response.col(static_cast<Index>(n)));
    }
    numbers[n].error_base_known = meanLength(known, counted);
    numbers[n].error = meanLength(placed, counted);
  }
}

}  // namespace

double meanDeflection(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const SensitivityTask& task) {
  const auto work = deflectionsAt(arm, X_WB, task.work, task.load);
  return work.ok ? meanLength(work.deflection_W, Matrix3d::Identity()) : std::numeric_limits<double>::quiet_NaN();
}

double meanUncompensatedError(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const SensitivityTask& task) {
  const auto work = deflectionsAt(arm, X_WB, task.work, task.load);
  const auto touches = deflectionsAt(arm, X_WB, task.touches, 0);
  if (!work.ok || !touches.ok) return std::numeric_limits<double>::quiet_NaN();
  BaseStep step = BaseStep::Zero();
  if (!task.touches.empty()) {
    MatrixXd motion(3 * static_cast<Index>(task.touches.size()), 6);
    VectorXd deflection(motion.rows());
    for (std::size_t t = 0; t < task.touches.size(); ++t) {
      motion.middleRows<3>(3 * static_cast<Index>(t)) = motionBy(touches.lever_W[t]);
      deflection.segment<3>(3 * static_cast<Index>(t)) = touches.deflection_W[t];
    }
    step = motion.colPivHouseholderQr().solve(deflection);
  }
  std::vector<Vector3d> errors;
  for (std::size_t w = 0; w < task.work.size(); ++w)
    errors.emplace_back(work.deflection_W[w] - motionBy(work.lever_W[w]) * step);
  return meanLength(errors, countedPart(task));
}

Sensitivity findSensitivities(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const SensitivityTask& task) {
  Sensitivity result;
  PredictionRequest request;
  request.by_base = request.by_joints = true;
  for (const auto& parameter : deflection::parametersOf(arm)) {
    request.numbers.push_back(deflection::Variable::number(parameter.path));
    result.numbers.emplace_back();
    result.numbers.back().parameter = parameter;
    result.numbers.back().kind = numberKindOf(parameter.quantity);
  }
  const Tips work = tipsAt(arm, X_WB, task.work, task.load, request);
  const Tips touches = tipsAt(arm, X_WB, task.touches, 0, request);
  if (task.work.empty() || !work.ok || !touches.ok) {
    result.status = SensitivityStatus::kNotConverged;
    result.reason = task.work.empty() ? "no posture to work at" : "the deflected shape does not converge";
    return result;
  }
  const Estimate untouched = estimateFrom(arm, X_WB, false, {}, {{}, true}, task.additional);
  const auto response = calibratedResponse(untouched, task, touches, static_cast<Index>(result.numbers.size()));
  if (!response) {
    result.status = SensitivityStatus::kTouchesDoNotDetermineBase;
    result.reason = "the touches do not place the base: three different places that are not on a line are needed";
    return result;
  }
  result.mean_deflection = meanDeflection(arm, X_WB, task);
  result.mean_uncompensated = meanUncompensatedError(arm, X_WB, task);
  addDeflection(arm, X_WB, task, work, result.numbers);
  addUncompensated(arm, X_WB, task, result.numbers);
  addErrors(task, work, untouched, *response, result.numbers);
  result.status = SensitivityStatus::kDone;
  return result;
}

}  // namespace tubeplan::calibration
