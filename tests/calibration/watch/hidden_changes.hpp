// Changes that are hidden in simulated outages, with the answer that is true.
#pragma once

#include "tests/calibration/watch/simulated_outage.hpp"

namespace tubeplan::calibration {

/// A change that is hidden in an outage. An empty `effect` stands for no change.
struct HiddenChange {
  const char* name;
  const char *effect, *at;  ///< the true answer of the watch
  bool is_ramp;
  std::function<SimulatedOutage::ChangedState(SimulatedOutage&)> make;
};

inline TrueState unchangedState(const SimulatedOutage& outage) { return {outage.truth(), outage.base()}; }

inline SimulatedOutage::ChangedState constantState(TrueState state) {
  return [state](int) { return state; };
}

inline TrueState withEffect(TrueState state, const char* effect, const char* at, double value) {
  auto made = deflection::makeEffect(state.arm, effect, at);
  made.effect.values.front() = value;
  state.arm.effects.push_back(made.effect);
  return state;
}

inline TrueState withOffset(TrueState state, const char* row_name, double degrees) {
  for (auto& row : state.arm.rows)
    if (row.name == row_name) row.joint.offset += degrees * kDegree;
  return state;
}

/// Returns the arm with its lengths beyond the first joint grown by `strain`, as by warmth.
inline TrueState grown(TrueState state, double strain) {
  bool moves = false;
  for (auto& row : state.arm.rows) {
    if (auto* dh = std::get_if<deflection::DenavitHartenberg<double>>(&row.placement); dh && moves) {
      dh->a *= 1 + strain;
      dh->d *= 1 + strain;
    }
    moves = moves || row.joint.type != deflection::JointType::kPassive;
  }
  state.arm.p_LT *= 1 + strain;
  return state;
}

inline const std::vector<HiddenChange>& hiddenChanges() {
  constexpr double kAluminium = 2.3e-5, kTenFahrenheit = 10 / 1.8;  // [1/K], [K]
  static const std::vector<HiddenChange> kChanges{
      {"none", "", "", false, [](SimulatedOutage& outage) { return constantState(unchangedState(outage)); }},
      {"base shifted by 0.02 in", "base-step", "base", false,
       [](SimulatedOutage& outage) {
         TrueState state = unchangedState(outage);
         state.X_WB.translation() += 0.02 * kInch * outage.random().vector(1).normalized();
         return constantState(state);
       }},
      {"base turned by 0.03 deg about z", "base-step", "base", false,
       [](SimulatedOutage& outage) {
         TrueState state = unchangedState(outage);
         state.X_WB.linear() = Eigen::AngleAxisd(0.03 * kDegree, Eigen::Vector3d::UnitZ()) * state.X_WB.linear();
         return constantState(state);
       }},
      {"forearm's joint slipped by 0.1 deg", "joint-offset", "theta3", false,
       [](SimulatedOutage& outage) { return constantState(withOffset(unchangedState(outage), "forearm", 0.1)); }},
      {"tool's joint softer by 30 %", "free", "tool.joint_stiffness.z", false,
       [](SimulatedOutage& outage) {
         TrueState state = unchangedState(outage);
         state.arm.rows.back().joint_stiffness.z() *= 0.7;
         return constantState(state);
       }},
      {"forearm's joint with 0.2 deg of play", "backlash", "forearm.z", false,
       [](SimulatedOutage& outage) {
         return constantState(withEffect(unchangedState(outage), "backlash", "forearm.z", 0.2 * kDegree));
       }},
      {"play growing by 0.1 deg in 25 visits", "backlash", "forearm.z", true,
       [](SimulatedOutage& outage) {
         const TrueState state = unchangedState(outage);
         return [state](int n) { return withEffect(state, "backlash", "forearm.z", 0.1 / 25 * n * kDegree); };
       }},
      {"base creeping by 0.02 in over 25 visits", "base-step", "base", true,
       [](SimulatedOutage& outage) {
         const TrueState state = unchangedState(outage);
         const Eigen::Vector3d way = outage.random().vector(1).normalized();
         return [state, way](int n) {
           TrueState now = state;
           now.X_WB.translation() += 0.02 / 25 * n * kInch * way;
           return now;
         };
       }},
      {"warmer by 10 degF", "thermal-growth", "arm", false,
       [=](SimulatedOutage& outage) {
         return constantState(grown(unchangedState(outage), kAluminium * kTenFahrenheit));
       }},
  };
  return kChanges;
}

}  // namespace tubeplan::calibration
