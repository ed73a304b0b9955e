// Rigid chains of random geometry, for tests that search for all postures of a goal.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "deflection/inverse/rigid_branches.hpp"
#include "deflection/rigid_tip.hpp"

namespace tubeplan::deflection::testing {

inline constexpr double kQuarter = std::numbers::pi / 2;

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  double operator()(double most) { return std::uniform_real_distribution<>(-most, most)(random_); }
  Eigen::Vector3d vector(double most) { return {(*this)(most), (*this)(most), (*this)(most)}; }

 private:
  std::mt19937_64 random_;
};

/// Random chain: an arm, and its joint axes at zero readings.
struct DrawnChain {
  Arm arm;
  AxesAtZero axes;
};

inline DrawnChain chainOf(std::vector<DenavitHartenberg<double>> rows, int slide, const Eigen::Vector3d& tip) {
  DrawnChain chain;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    auto& row = chain.arm.rows.emplace_back();
    row.name = row.joint.name = "j" + std::to_string(k);
    row.placement = rows[k];
    row.joint.type = static_cast<int>(k) == slide ? JointType::kPrismatic : JointType::kRevolute;
    if (static_cast<int>(k) == slide) row.joint.lower = -1, row.joint.upper = 1;
  }
  chain.arm.p_LT = tip;
  chain.axes = axesAtZero(chain.arm);
  return chain;
}

inline DrawnChain drawnChain(int joints, int slide, Draw& draw) {
  std::vector<DenavitHartenberg<double>> rows;
  for (int k = 0; k < joints; ++k) rows.push_back({draw(3), std::abs(draw(0.5)), draw(0.3), 0});
  return chainOf(rows, slide, draw.vector(0.3));
}

inline Eigen::VectorXd drawnReadings(const DrawnChain& chain, Draw& draw) {
  Eigen::VectorXd q(chain.arm.jointCount());
  for (Eigen::Index k = 0; k < q.size(); ++k)
    q[k] = draw(chain.arm.joint(k).type == JointType::kPrismatic ? 1 : std::numbers::pi);
  return q;
}

inline double postureDifference(const DrawnChain& chain, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  double most = 0;
  for (Eigen::Index k = 0; k < a.size(); ++k) {
    const double off = a[k] - b[k];
    most = std::max(
        most,
        std::abs(chain.axes.slides[static_cast<std::size_t>(k)] ? off : std::remainder(off, 2 * std::numbers::pi)));
  }
  return most;
}

}  // namespace tubeplan::deflection::testing
