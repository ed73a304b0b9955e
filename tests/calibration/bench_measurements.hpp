// Simulated measurements of the shipped bench cell's arm at random postures under three loads, with stated approach
// directions; one effect, unknown to the fit, may be added to the arm.
#pragma once

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/measurements/measurement_placement.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/placed_arm.hpp"
#include "deflection/effects/effect.hpp"
#include "tests/deflection/cobra.hpp"
#include "tests/units.hpp"

namespace tubeplan::calibration {

inline app::Cell shippedBench() {
  return app::readCell((std::filesystem::path(TUBEPLAN_SOURCE_DIR) / "app/cells/bench.yaml").string());
}

/// Returns measurements of the arm with the given effect (none if `effect` is empty), with encoder noise and with noise
/// of 0.003 in at the tip.
inline std::vector<Measurement> benchMeasurements(const app::Cell& cell, const std::string& effect,
                                                  const std::string& at, const std::vector<double>& values, int count,
                                                  std::uint64_t seed) {
  auto arm = cell.arm;
  if (!effect.empty()) {
    auto made = deflection::makeEffect(arm, effect, at).effect;
    made.values = values;
    arm.effects.push_back(made);
  }
  boost::random::mt19937_64 random(seed);
  boost::random::normal_distribution<double> normal;
  boost::random::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Measurement> measurements;
  for (int k = 0; k < count; ++k) {
    Measurement measurement;
    measurement.id = std::to_string(k + 1);
    measurement.load = (k % 3) * 20 * kPound;
    measurement.sigma = 0.003 * kInch;
    measurement.q.resize(4);
    const double middle[] = {0, 75, -80, 0}, half[] = {60, 30, 40, 40};
    for (int j = 0; j < 4; ++j) {
      measurement.q[j] = (middle[j] + half[j] * uniform(random)) * kDegree;
      measurement.approach_directions.push_back(uniform(random) > 0 ? 1 : -1);
    }
    Eigen::Vector3d p = predictMeasurement(arm, cell.X_WB, measurement).value;
    for (double& coordinate : p) coordinate += measurement.sigma * normal(random);
    measurement.p_W = p;
    for (int j = 0; j < 4; ++j) measurement.q[j] += arm.joint(j).encoder_sigma * normal(random);
    measurements.push_back(measurement);
  }
  return measurements;
}

inline PlacedArm benchStart(const app::Cell& cell, const std::vector<Measurement>& measurements) {
  return placeForMeasurements(cell.arm, cell.X_WB, cell.base_known, measurements);
}

}  // namespace tubeplan::calibration
