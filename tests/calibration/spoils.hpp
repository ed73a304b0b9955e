// Common faults of measured data, applied to simulated readings, for tests that all results computed from the same
// faulty readings agree with one another.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "tests/calibration/campaign.hpp"

namespace tubeplan::calibration {

inline std::size_t drawnPlace(const std::vector<Measurement>& readings, std::mt19937_64& random) {
  return std::uniform_int_distribution<std::size_t>(1, readings.size() - 1)(random);
}

inline void moveAtRandom(Measurement& reading, double by, std::mt19937_64& random) {
  std::normal_distribution<double> normal(0, by);
  for (double& p : *reading.p_W) p += normal(random);
}

/// A fault of measured data, and the function that applies it to good readings.
struct Spoil {
  const char* name;
  int repeats;  ///< number of readings of each posture
  std::function<void(std::vector<Measurement>&, std::mt19937_64&)> apply;
};

/// Returns the list of faults; the first two leave the readings unchanged.
inline const std::vector<Spoil>& spoils() {
  static const std::vector<Spoil> kSpoils{
      {"nothing", 1, [](std::vector<Measurement>&, std::mt19937_64&) {}},
      {"nothing, read twice", 2, [](std::vector<Measurement>&, std::mt19937_64&) {}},
      {"the joints of the row before", 1,
       [](std::vector<Measurement>& readings, std::mt19937_64& random) {
         const std::size_t k = drawnPlace(readings, random);
         readings[k].q = readings[k - 1].q;
         readings[k].load = readings[k - 1].load;
         readings[k].approach_directions = readings[k - 1].approach_directions;
       }},
      {"half of the joints of the rows before", 1,
       [](std::vector<Measurement>& readings, std::mt19937_64&) {
         for (std::size_t k = 1; k < readings.size(); k += 2) {
           readings[k].q = readings[k - 1].q;
           readings[k].load = readings[k - 1].load;
           readings[k].approach_directions = readings[k - 1].approach_directions;
         }
       }},
      {"places in another order", 2,
       [](std::vector<Measurement>& readings, std::mt19937_64& random) {
         std::vector<Eigen::Vector3d> places;
         for (const auto& reading : readings) places.push_back(*reading.p_W);
         std::shuffle(places.begin(), places.end(), random);
         for (std::size_t k = 0; k < readings.size(); ++k) readings[k].p_W = places[k];
       }},
      {"one place 100 sigmas off", 1,
       [](std::vector<Measurement>& readings, std::mt19937_64& random) {
         moveAtRandom(readings[drawnPlace(readings, random)], 100 * kReadingSigma, random);
       }},
      {"every tenth place 100 sigmas off", 2,
       [](std::vector<Measurement>& readings, std::mt19937_64& random) {
         for (std::size_t k = 0; k < readings.size(); k += 10) moveAtRandom(readings[k], 100 * kReadingSigma, random);
       }},
      {"places twice as noisy as stated", 2,
       [](std::vector<Measurement>& readings, std::mt19937_64& random) {
         for (auto& reading : readings) moveAtRandom(reading, std::sqrt(3.) * kReadingSigma, random);
       }},
      {"places thirty times as noisy as stated", 2,
       [](std::vector<Measurement>& readings, std::mt19937_64& random) {
         for (auto& reading : readings) moveAtRandom(reading, 30 * kReadingSigma, random);
       }},
      {"a joint's sign", 2,
       [](std::vector<Measurement>& readings, std::mt19937_64&) {
         for (auto& reading : readings) reading.q[2] *= -1;
       }},
      {"places 2 % too long", 1,
       [](std::vector<Measurement>& readings, std::mt19937_64&) {
         for (auto& reading : readings) *reading.p_W *= 1.02;
       }},
  };
  return kSpoils;
}

/// Returns forty simulated readings of an arm, with one fault applied to them.
inline std::vector<Measurement> spoiltCampaign(const deflection::Arm& arm, std::uint64_t seed, const Spoil& spoil) {
  std::mt19937_64 random(seed);
  CampaignPlan plan;
  plan.postures = 40 / spoil.repeats;
  plan.repeats = spoil.repeats;
  std::vector<Measurement> made = makeCampaign(arm, seed, plan);
  spoil.apply(made, random);
  return made;
}

}  // namespace tubeplan::calibration
