// Common faults of measured data, applied to simulated measurements, for tests that all results computed from the same
// faulty measurements agree with one another.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "tests/calibration/campaign.hpp"

namespace tubeplan::calibration {

inline std::size_t drawnPlace(const std::vector<Measurement>& measurements, std::mt19937_64& random) {
  return std::uniform_int_distribution<std::size_t>(1, measurements.size() - 1)(random);
}

inline void moveAtRandom(Measurement& measurement, double by, std::mt19937_64& random) {
  std::normal_distribution<double> normal(0, by);
  for (double& p : *measurement.p_W) p += normal(random);
}

/// A fault of measured data, and the function that applies it to good measurements.
struct MeasurementFault {
  const char* name;
  int repeats;  ///< number of measurements of each posture
  std::function<void(std::vector<Measurement>&, std::mt19937_64&)> apply;
};

/// Returns the list of faults; the first two leave the measurements unchanged.
inline const std::vector<MeasurementFault>& measurementFaults() {
  static const std::vector<MeasurementFault> kFaults{
      {"nothing", 1, [](std::vector<Measurement>&, std::mt19937_64&) {}},
      {"nothing, read twice", 2, [](std::vector<Measurement>&, std::mt19937_64&) {}},
      {"the joints of the row before", 1,
       [](std::vector<Measurement>& measurements, std::mt19937_64& random) {
         const std::size_t k = drawnPlace(measurements, random);
         measurements[k].q = measurements[k - 1].q;
         measurements[k].load = measurements[k - 1].load;
         measurements[k].approach_directions = measurements[k - 1].approach_directions;
       }},
      {"half of the joints of the rows before", 1,
       [](std::vector<Measurement>& measurements, std::mt19937_64&) {
         for (std::size_t k = 1; k < measurements.size(); k += 2) {
           measurements[k].q = measurements[k - 1].q;
           measurements[k].load = measurements[k - 1].load;
           measurements[k].approach_directions = measurements[k - 1].approach_directions;
         }
       }},
      {"places in another order", 2,
       [](std::vector<Measurement>& measurements, std::mt19937_64& random) {
         std::vector<Eigen::Vector3d> places;
         for (const auto& measurement : measurements) places.push_back(*measurement.p_W);
         std::shuffle(places.begin(), places.end(), random);
         for (std::size_t k = 0; k < measurements.size(); ++k) measurements[k].p_W = places[k];
       }},
      {"one place 100 sigmas off", 1,
       [](std::vector<Measurement>& measurements, std::mt19937_64& random) {
         moveAtRandom(measurements[drawnPlace(measurements, random)], 100 * kMeasurementSigma, random);
       }},
      {"every tenth place 100 sigmas off", 2,
       [](std::vector<Measurement>& measurements, std::mt19937_64& random) {
         for (std::size_t k = 0; k < measurements.size(); k += 10)
           moveAtRandom(measurements[k], 100 * kMeasurementSigma, random);
       }},
      {"places twice as noisy as stated", 2,
       [](std::vector<Measurement>& measurements, std::mt19937_64& random) {
         for (auto& measurement : measurements) moveAtRandom(measurement, std::sqrt(3.) * kMeasurementSigma, random);
       }},
      {"places thirty times as noisy as stated", 2,
       [](std::vector<Measurement>& measurements, std::mt19937_64& random) {
         for (auto& measurement : measurements) moveAtRandom(measurement, 30 * kMeasurementSigma, random);
       }},
      {"a joint's sign", 2,
       [](std::vector<Measurement>& measurements, std::mt19937_64&) {
         for (auto& measurement : measurements) measurement.q[2] *= -1;
       }},
      {"places 2 % too long", 1,
       [](std::vector<Measurement>& measurements, std::mt19937_64&) {
         for (auto& measurement : measurements) *measurement.p_W *= 1.02;
       }},
  };
  return kFaults;
}

/// Returns forty simulated measurements of an arm, with one fault applied to them.
inline std::vector<Measurement> campaignWithFault(const deflection::Arm& arm, std::uint64_t seed,
                                                  const MeasurementFault& fault) {
  std::mt19937_64 random(seed);
  CampaignPlan plan;
  plan.postures = 40 / fault.repeats;
  plan.repeats = fault.repeats;
  std::vector<Measurement> made = makeCampaign(arm, seed, plan);
  fault.apply(made, random);
  return made;
}

}  // namespace tubeplan::calibration
