// Simulated readings of the shipped bench cell's arm at random postures under three loads, with stated approach
// directions; one effect, unknown to the fit, may be added to the arm.
#pragma once

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/measurements/reading_placement.hpp"
#include "calibration/measurements/reading_prediction.hpp"
#include "calibration/placed_arm.hpp"
#include "deflection/effects/effect.hpp"
#include "tests/deflection/cobra.hpp"
#include "tests/units.hpp"

namespace tubeplan::calibration {

inline app::Cell shippedBench() {
  return app::readCell((std::filesystem::path(TUBEPLAN_SOURCE_DIR) / "app/cells/bench.yaml").string());
}

/// Returns readings of the arm with the given effect (none if `effect` is empty), with encoder noise and with noise of
/// 0.003 in at the tip.
inline std::vector<Measurement> benchReadings(const app::Cell& cell, const std::string& effect, const std::string& at,
                                              const std::vector<double>& values, int count, std::uint64_t seed) {
  auto arm = cell.arm;
  if (!effect.empty()) {
    auto made = deflection::makeEffect(arm, effect, at).effect;
    made.values = values;
    arm.effects.push_back(made);
  }
  boost::random::mt19937_64 random(seed);
  boost::random::normal_distribution<double> normal;
  boost::random::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Measurement> readings;
  for (int k = 0; k < count; ++k) {
    Measurement reading;
    reading.id = std::to_string(k + 1);
    reading.load = (k % 3) * 20 * kPound;
    reading.sigma = 0.003 * kInch;
    reading.q.resize(4);
    const double middle[] = {0, 75, -80, 0}, half[] = {60, 30, 40, 40};
    for (int j = 0; j < 4; ++j) {
      reading.q[j] = (middle[j] + half[j] * uniform(random)) * kDegree;
      reading.approach_directions.push_back(uniform(random) > 0 ? 1 : -1);
    }
    Eigen::Vector3d p = predictReading(arm, cell.X_WB, reading).value;
    for (double& coordinate : p) coordinate += reading.sigma * normal(random);
    reading.p_W = p;
    for (int j = 0; j < 4; ++j) reading.q[j] += arm.joint(j).encoder_sigma * normal(random);
    readings.push_back(reading);
  }
  return readings;
}

inline PlacedArm benchStart(const app::Cell& cell, const std::vector<Measurement>& readings) {
  return placeForReadings(cell.arm, cell.X_WB, cell.base_known, readings);
}

}  // namespace tubeplan::calibration
