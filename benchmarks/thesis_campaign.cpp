#include "benchmarks/thesis_campaign.hpp"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <numbers>

#include "deflection/rigid_branches.hpp"
#include "deflection/tip_derivatives.hpp"

namespace tubeplan::benchmarks {

namespace {

using deflection::Arm, deflection::Row;
using Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

constexpr double kInch = 0.0254, kPound = 4.4482216152605, kDegree = std::numbers::pi / 180;
constexpr double kTorquePerAngle = kPound * kInch / kDegree, kPressure = kPound / (kInch * kInch);
constexpr double kInchToTheFourth = kInch * kInch * kInch * kInch;

constexpr int kPostures = 31;
constexpr double kLoads[] = {20, 30, 40};  // lb
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

/// Tables 5.2 and 5.4, with the four values of app/cells/cobra-arm.yaml that the thesis's own examples ask for.
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

struct Reading {
  deflection::Posture posture;
  Vector3d p_BT;
};

/// The true arm measured: postures spread evenly over the joint limits, each under each load.
std::vector<Reading> measure(const Arm& arm) {
  boost::random::mt19937_64 random(1994);
  boost::random::normal_distribution<double> noise(0, kSigma);
  std::vector<Reading> readings;
  for (const auto& q : deflection::latticeStarts(arm, kPostures))
    for (const double load : kLoads) {
      const deflection::Posture posture{q, load * kPound, -Vector3d::UnitZ()};
      Vector3d p_BT = deflection::solveFlexibleKinematics(arm, posture, kKinematics).X_BD.p;
      for (double& coordinate : p_BT) coordinate += noise(random);
      readings.push_back({posture, p_BT});
    }
  return readings;
}

/// Misfit of all readings as a function of the unknowns.
class Misfit {
 public:
  explicit Misfit(const Arm& truth) : truth_(truth), readings_(measure(truth)) {
    for (const char* name : kUnknowns) {
      paths_.push_back(deflection::findParameter(truth, name).value().path);
      variables_.push_back(deflection::Variable::number(paths_.back()));
    }
  }

  bool operator()(const VectorXd& x, VectorXd& r, MatrixXd* jacobian) const {
    const Arm arm = armAt(x);
    r.resize(3 * static_cast<Eigen::Index>(readings_.size()));
    if (jacobian) jacobian->resize(r.size(), kCount);
    for (std::size_t k = 0; k < readings_.size(); ++k) {
      const Eigen::Index row = 3 * static_cast<Eigen::Index>(k);
      const auto tip = tipOf(arm, readings_[k].posture, jacobian != nullptr);
      if (tip.kinematics.status != deflection::KinematicsStatus::kConverged) return false;
      r.segment<3>(row) = (tip.kinematics.X_BD.p - readings_[k].p_BT) / kSigma;
      if (jacobian) jacobian->middleRows<3>(row) = tip.position_B * valuesIn(arm).asDiagonal() / kSigma;
    }
    return true;
  }

 private:
  deflection::TipDerivatives tipOf(const Arm& arm, const deflection::Posture& posture, bool derive) const {
    if (derive) return deflection::differentiateTip(arm, posture, variables_, kKinematics);
    return {deflection::solveFlexibleKinematics(arm, posture, kKinematics), {}, {}};
  }

  Arm armAt(const VectorXd& x) const {
    Arm arm = truth_;
    for (std::size_t k = 0; k < paths_.size(); ++k)
      deflection::locate(arm, paths_[k]) *= std::exp(x[static_cast<Eigen::Index>(k)]);
    return arm;
  }

  /// The unknowns themselves: what a derivative by the logarithm is multiplied with.
  VectorXd valuesIn(Arm arm) const {
    VectorXd values(kCount);
    for (std::size_t k = 0; k < paths_.size(); ++k)
      values[static_cast<Eigen::Index>(k)] = deflection::locate(arm, paths_[k]);
    return values;
  }

  Arm truth_;
  std::vector<Reading> readings_;
  std::vector<deflection::ParameterPath> paths_;
  std::vector<deflection::Variable> variables_;
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
  campaign.truth = VectorXd::Zero(kCount);
  return campaign;
}

}  // namespace tubeplan::benchmarks
