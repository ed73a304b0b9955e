#include "studies/benchmarks/thesis_campaign.hpp"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <numbers>

#include "calibration/estimation/fit.hpp"
#include "deflection/inverse/inverse_kinematics.hpp"
#include "deflection/inverse/rigid_branches.hpp"
#include "deflection/kinematics.hpp"

namespace tubeplan::benchmarks {

namespace {

using deflection::Arm, deflection::Row;
using Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

constexpr double kInch = 0.0254, kPound = 4.4482216152605, kDegree = std::numbers::pi / 180;
constexpr double kTorquePerAngle = kPound * kInch / kDegree, kPressure = kPound / (kInch * kInch);
constexpr double kInchToTheFourth = kInch * kInch * kInch * kInch;

constexpr int kPostures = 31;
constexpr double kLoads[] = {20, 30, 40};  // loads on the tip [lb]
constexpr double kSigma = 0.02 * kInch;
constexpr double kStartFactor = 3, kBoundFactor = 1000;
constexpr const char* kUnknowns[] = {
    "tool.joint_stiffness.z", "forearm.joint_stiffness.z",        "latch-link.beam.Iz",
    "mezzanine-beam.beam.Iz", "mezzanine-beam.joint_stiffness.z", "mezzanine-platform.joint_stiffness.x"};
constexpr Eigen::Index kCount = std::size(kUnknowns);
const deflection::FlexibleKinematicsOptions kKinematics{1e-13, 100};

Row<double> rowOf(const char* name, double alpha, double a, double d) {
  Row<double> row;
  row.name = name;
  row.placement = deflection::DenavitHartenberg<double>{alpha * kDegree, a * kInch, d * kInch, 0};
  return row;
}

Row<double> turning(Row<double> row, double lower, double upper, double distributed, double end) {
  row.joint.type = deflection::JointType::kRevolute;
  row.joint.lower = lower * kDegree;
  row.joint.upper = upper * kDegree;
  row.weight.distributed = distributed * kPound / kInch;
  row.weight.end = end * kPound;
  return row;
}

deflection::Beam<double> beamOf(double Iz) {
  deflection::Beam<double> beam;
  beam.E = 1.0121e7 * kPressure;
  beam.I.z() = Iz * kInchToTheFourth;
  return beam;
}

/// Returns the arm of the thesis's tables 5.2 and 5.4, with four values from app/cells/cobra-arm.yaml that the thesis's
/// examples require.
Arm cobraArm() {
  Arm arm;
  arm.rows = {rowOf("mezzanine-beam", 90, 0, 0),
              rowOf("mezzanine-platform", -91.37, 15, 0),
              turning(rowOf("base-link", 0, 0, 8.940), -175, 175, 0.152, 26.7),
              turning(rowOf("latch-link", 90, 13.202, 0), 0, 180, 0.403, 20),
              turning(rowOf("forearm", 0, 26.406, 0), -155, 155, 0.126, 10.4),
              turning(rowOf("tool", 0, 19.4, 0), -135, 135, 1.2062, 0)};
  arm.rows[0].joint_stiffness.z() = 272000 * kTorquePerAngle;
  arm.rows[0].beam = beamOf(0.426);
  arm.rows[1].joint_stiffness.x() = 6543 * kTorquePerAngle;
  arm.rows[3].beam = beamOf(0.394);
  arm.rows[4].joint_stiffness.z() = 207000 * kTorquePerAngle;
  arm.rows[5].joint_stiffness.z() = 5588 * kTorquePerAngle;
  arm.p_LT = Vector3d(16.2493, 7.8471, 0) * kInch;
  return arm;
}

struct TipMeasurement {
  deflection::Posture posture;
  Vector3d p_BT;
};

/// Returns measurements of the true arm: postures spread evenly over the joint ranges, each measured under every load.
std::vector<TipMeasurement> measure(const Arm& arm) {
  boost::random::mt19937_64 random(1994);
  boost::random::normal_distribution<double> noise(0, kSigma);
  std::vector<TipMeasurement> measurements;
  for (const auto& q : deflection::latticeStarts(arm, kPostures))
    for (const double load : kLoads) {
      const deflection::Posture posture{q, load * kPound, -Vector3d::UnitZ()};
      Vector3d p_BT = deflection::solveFlexibleKinematics(arm, posture, kKinematics).X_BD.p;
      for (double& coordinate : p_BT) coordinate += noise(random);
      measurements.push_back({posture, p_BT});
    }
  return measurements;
}

/// Residuals of all measurements as a function of the unknown stiffnesses' logarithms.
class Misfit {
 public:
  explicit Misfit(const Arm& truth) : truth_(truth), measurements_(measure(truth)) {
    for (const char* name : kUnknowns) {
      paths_.push_back(deflection::findParameter(truth, name).value().path);
      variables_.push_back(deflection::Variable::number(paths_.back()));
    }
    postures_.resize(4, std::ssize(measurements_));
    for (std::size_t k = 0; k < measurements_.size(); ++k) {
      postures_.q.col(static_cast<Eigen::Index>(k)) = measurements_[k].posture.q;
      postures_.load[static_cast<Eigen::Index>(k)] = measurements_[k].posture.load;
    }
  }

  bool operator()(const VectorXd& x, VectorXd& r, MatrixXd* jacobian) const {
    Arm arm = truth_;
    VectorXd values(kCount);  // factors that convert derivatives to those with respect to the logarithm
    for (Eigen::Index u = 0; u < kCount; ++u)
      values[u] = deflection::locate(arm, paths_[static_cast<std::size_t>(u)]) *= std::exp(x[u]);
    deflection::Kinematics kinematics(arm);
    deflection::TipBatch tips;
    kinematics.solveWithDerivatives(postures_, jacobian ? variables_ : std::vector<deflection::Variable>{}, tips,
                                    kKinematics);
    r.resize(3 * static_cast<Eigen::Index>(measurements_.size()));
    if (jacobian) jacobian->resize(r.size(), kCount);
    for (std::size_t k = 0; k < measurements_.size(); ++k) {
      if (tips.status[k] != deflection::KinematicsStatus::kConverged) return false;
      const auto posture = static_cast<Eigen::Index>(k), row = 3 * posture;
      r.segment<3>(row) = (tips.poses.col(posture).head<3>() - measurements_[k].p_BT) / kSigma;
      for (Eigen::Index u = 0; jacobian && u < kCount; ++u)
        jacobian->block<3, 1>(row, u) = tips.jacobian.col(posture).segment<3>(6 * u) * (values[u] / kSigma);
    }
    return true;
  }

 private:
  Arm truth_;
  std::vector<TipMeasurement> measurements_;
  std::vector<deflection::ParameterPath> paths_;
  std::vector<deflection::Variable> variables_;
  deflection::PostureBatch postures_;
};

}  // namespace

Campaign thesisCampaign() {
  Campaign campaign;
  auto& problem = campaign.problem;
  problem.start = VectorXd::Constant(kCount, std::log(kStartFactor));
  for (Eigen::Index k = 1; k < kCount; k += 2) problem.start[k] *= -1;
  problem.lower = VectorXd::Constant(kCount, -std::log(kBoundFactor));
  problem.upper = -problem.lower;
  problem.scale = VectorXd::Ones(kCount);
  problem.evaluate = Misfit(cobraArm());
  campaign.error = [](const VectorXd& x) { return std::expm1(x.lpNorm<Eigen::Infinity>()); };
  return campaign;
}

namespace {

/// One of the thesis's eleven stiffnesses, in the thesis's units.
struct TrueStiffness {
  const char* name;
  double value, unit;
};
constexpr TrueStiffness kTrueStiffnesses[] = {
    {"mezzanine-beam.joint_stiffness.z", 272000, kTorquePerAngle},
    {"mezzanine-beam.beam.Iz", 0.426, kInchToTheFourth},
    {"mezzanine-platform.joint_stiffness.x", 6543, kTorquePerAngle},
    {"base-link.beam.Iy", 0.3, kInchToTheFourth},
    {"base-link.joint_stiffness.y", 60000, kTorquePerAngle},
    {"latch-link.beam.Iz", 0.394, kInchToTheFourth},
    {"latch-link.joint_stiffness.z", 80000, kTorquePerAngle},
    {"forearm.beam.Iz", 0.2, kInchToTheFourth},
    {"forearm.joint_stiffness.z", 40000, kTorquePerAngle},
    {"tool.beam.Iz", 0.2, kInchToTheFourth},
    {"tool.joint_stiffness.z", 5588, kTorquePerAngle},
};
constexpr int kTouchPoints = 45;
constexpr double kTouchSigma = 0.0005 * kInch;

Arm touchingArm() {
  Arm arm = cobraArm();
  arm.tool_axis_L = Vector3d::UnitY();
  for (const std::size_t row : {2, 4, 5}) arm.rows[row].beam = beamOf(deflection::kRigid);
  arm.rows[2].beam->I.y() = arm.rows[2].joint_stiffness.y() = arm.rows[3].joint_stiffness.z() = 1;
  arm.rows[4].beam->I.z() = arm.rows[5].beam->I.z() = 1;
  for (const auto& [name, value, unit] : kTrueStiffnesses)
    deflection::locate(arm, deflection::findParameter(arm, name).value().path) = value * unit;
  return arm;
}

/// Returns the touches of one point: under each load, the tool is moved back to the point at the same tilt. Empty if
/// the point cannot be reached.
std::vector<calibration::Measurement> touchPoint(const Arm& arm, const VectorXd& q, int point,
                                                 boost::random::mt19937_64& random) {
  boost::random::normal_distribution<double> noise(0, kTouchSigma);
  const Vector3d gravity_B = -Vector3d::UnitZ();
  const auto bare = deflection::solveFlexibleKinematics(arm, {q, 0, gravity_B}, kKinematics);
  std::vector<calibration::Measurement> touches;
  for (const double load : {0., kLoads[0], kLoads[1], kLoads[2]}) {
    Vector3d p_BT = bare.X_BD.p;
    for (double& coordinate : p_BT) coordinate += noise(random);
    const auto found =
        deflection::refineBranch(arm, {p_BT, bare.X_BD.R * arm.tool_axis_L}, load * kPound, gravity_B, q);
    if (found.status != deflection::BranchStatus::kConverged || (found.q - q).norm() > 0.5) return {};
    calibration::Measurement touch;
    touch.kind = calibration::MeasurementKind::kTouch;
    touch.point = "P" + std::to_string(point);
    touch.id = touch.point + "-" + std::to_string(touches.size() + 1);
    touch.q = found.q;
    touch.load = load * kPound;
    touch.sigma = kTouchSigma;
    touch.p_W = bare.X_BD.p;
    touches.push_back(touch);
  }
  return touches;
}

std::shared_ptr<const TouchSession> makeTouchSession() {
  auto session = std::make_shared<TouchSession>();
  Arm arm = touchingArm();
  boost::random::mt19937_64 random(1995);
  int points = 0;
  for (const auto& q : deflection::latticeStarts(arm, 4 * kTouchPoints)) {
    if (points == kTouchPoints) break;
    const auto touches = touchPoint(arm, q, points + 1, random);
    points += !touches.empty();
    session->measurements.insert(session->measurements.end(), touches.begin(), touches.end());
  }
  for (std::size_t k = 0; k < std::size(kTrueStiffnesses); ++k) {
    const auto& [name, value, unit] = kTrueStiffnesses[k];
    session->names.emplace_back(name);
    session->truth.push_back(value * unit);
    deflection::locate(arm, deflection::findParameter(arm, name).value().path) *=
        k % 2 == 0 ? kStartFactor : 1 / kStartFactor;
  }
  session->start = {arm, {{"", Eigen::Isometry3d::Identity(), true}}};
  return session;
}

}  // namespace

std::shared_ptr<const TouchSession> touchSession() {
  static const auto kSession = makeTouchSession();
  return kSession;
}

Campaign touchCampaign() {
  struct Parts {
    std::shared_ptr<const TouchSession> session;
    calibration::PlacedArm start;
    std::vector<calibration::Unknown> unknowns;
    calibration::MeasurementWeights weights;
    calibration::LeastSquaresProblem problem;
  };
  const auto parts = std::make_shared<Parts>();
  parts->session = touchSession();
  parts->start = parts->session->start;
  parts->unknowns = calibration::chooseUnknowns(parts->start, {parts->session->names, false}).list;
  parts->weights = calibration::weighMeasurements(parts->start, parts->session->measurements).value();
  parts->problem = calibration::fitProblem(parts->start, parts->unknowns, parts->session->measurements, parts->weights,
                                           VectorXd::Zero(std::ssize(parts->unknowns)));
  Campaign campaign;
  campaign.problem = parts->problem;
  campaign.problem.evaluate = [parts](const VectorXd& x, VectorXd& r, MatrixXd* jacobian) {
    return parts->problem.evaluate(x, r, jacobian);
  };
  campaign.error = [parts](const VectorXd& x) {
    double worst = 0;
    for (std::size_t k = 0; k < parts->unknowns.size(); ++k) {
      const double value = calibration::valueAt(parts->unknowns[k], x[static_cast<Eigen::Index>(k)]);
      worst = std::max(worst, std::abs(value / parts->session->truth[k] - 1));
    }
    return worst;
  };
  return campaign;
}

}  // namespace tubeplan::benchmarks
