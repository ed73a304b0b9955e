// If the proposed measurements are simulated with the true arm, they must identify the hidden effect more often than
// the same number of random measurements.
#include "calibration/diagnosis/discrimination/discriminating_measurements.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/studies/measurements/discrimination_candidates.hpp"
#include "tests/calibration/bench_measurements.hpp"

namespace tubeplan::calibration {
namespace {

/// Measurements in a narrow range of the last joint, under two loads, which do not distinguish the possible causes.
struct Bench {
  app::Cell cell = shippedBench();
  deflection::Arm truth = cell.arm;
  std::vector<Measurement> measurements;

  Bench(const std::string& effect, const std::string& at, const std::vector<double>& values, std::uint64_t seed,
        int count = 40)
      : random(seed) {
    auto made = deflection::makeEffect(truth, effect, at).effect;
    made.values = values;
    truth.effects.push_back(made);
    for (int k = 0; k < count; ++k) {
      Measurement measurement;
      measurement.load = (k % 2) * 20 * kPound;
      measurement.sigma = 0.003 * kInch;
      measurement.q.resize(4);
      const double middle[] = {0, 75, -80, 0}, half[] = {60, 20, 20, 8};
      for (int j = 0; j < 4; ++j) {
        measurement.q[j] = (middle[j] + half[j] * uniform(random)) * kDegree;
        measurement.approach_directions.push_back(uniform(random) > 0 ? 1 : -1);
      }
      take(measurement);
    }
  }

  /// Adds the true arm's measurement at a posture, with noise of coordinates and encoders.
  void take(Measurement measurement) {
    measurement.id = std::to_string(measurements.size() + 1);
    measurement.p_W.reset();
    Eigen::Vector3d p = predictMeasurement(truth, cell.X_WB, measurement).value;
    for (double& coordinate : p) coordinate += measurement.sigma * normal(random);
    measurement.p_W = p;
    for (int j = 0; j < 4; ++j) measurement.q[j] += truth.joint(j).encoder_sigma * normal(random);
    measurements.push_back(measurement);
  }

  [[nodiscard]] Diagnosis diagnosed() const {
    DiagnosisOptions options;
    options.baseline.free = {cell.identify, false};
    return diagnose(benchStart(cell, measurements), measurements, options);
  }

  boost::random::mt19937_64 random;
  boost::random::normal_distribution<double> normal;
  boost::random::uniform_real_distribution<double> uniform{-1, 1};
};

/// Returns true if the first explanation is the truth and no other explanation in `open` remains among the
/// alternatives.
bool isNamed(const Diagnosis& diagnosis, const std::vector<Explanation>& open, const std::string& truth) {
  if (diagnosis.alternatives.empty() || nameOf(diagnosis.alternatives.front()) != truth) return false;
  return std::none_of(diagnosis.alternatives.begin(), diagnosis.alternatives.end(), [&](const Explanation& remaining) {
    return nameOf(remaining) != truth && std::any_of(open.begin(), open.end(), [&](const Explanation& explanation) {
             return nameOf(explanation) == nameOf(remaining);
           });
  });
}

std::vector<MeasurementCandidate> candidatesOf(const Bench& bench, const Diagnosis& diagnosis) {
  return app::discriminationCandidates(bench.cell, diagnosis.baseline.fitted, bench.measurements);
}

struct HiddenOne {
  const char* effect;
  const char* at;
  std::vector<double> values;
};

struct Tally {
  int open = 0, by_choice = 0, at_random = 0;
};

Tally tallyOf(const HiddenOne& hidden, int seeds) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(seeds); ++seed) {
    Bench bench(hidden.effect, hidden.at, hidden.values, seed);
    const Diagnosis before = bench.diagnosed();
    const auto candidates = candidatesOf(bench, before);
    DiscriminationOptions few;  // so few that the choice of measurements matters
    few.count = 2;
    const auto next = proposeDiscriminatingMeasurements(before, bench.measurements, candidates, few);
    if (next.status != DiscriminationStatus::kDone) continue;
    ++tally.open;
    const std::string truth = std::string(hidden.effect) + "@" + hidden.at;
    Bench other = bench;
    for (const auto& chosen : next.measurements)
      for (const auto& measurement : candidates[static_cast<std::size_t>(chosen.candidate)].measurements)
        bench.take(conditionsOf(measurement));
    const auto random =
        drawChoices(static_cast<int>(candidates.size()), static_cast<int>(next.measurements.size()), 1, seed);
    for (const int k : random.front())
      for (const auto& measurement : candidates[static_cast<std::size_t>(k)].measurements)
        other.take(conditionsOf(measurement));
    tally.by_choice += isNamed(bench.diagnosed(), next.explanations, truth);
    tally.at_random += isNamed(other.diagnosed(), next.explanations, truth);
  }
  return tally;
}

TEST(DiscriminatingMeasurements, GetTheHiddenEffectNamedMoreOftenThanRandomOnes) {
  Tally all;
  for (const HiddenOne& hidden :
       {HiddenOne{"encoder-eccentricity", "theta4", {0.0012, 0.0012}}, HiddenOne{"joint-scale", "theta2", {0.0006}}}) {
    const Tally tally = tallyOf(hidden, 3);
    all.open += tally.open;
    all.by_choice += tally.by_choice;
    all.at_random += tally.at_random;
  }
  EXPECT_GE(all.open, 5);
  EXPECT_GE(all.by_choice, all.open - 1);
  EXPECT_GT(all.by_choice, all.at_random);
}

TEST(DiscriminatingMeasurements, AreToldWhatTheyWouldDo) {
  Bench bench("encoder-eccentricity", "theta4", {0.0012, 0.0012}, 1);
  const Diagnosis diagnosis = bench.diagnosed();
  ASSERT_EQ(diagnosis.verdict, Verdict::kAmbiguous);
  const auto candidates = candidatesOf(bench, diagnosis);
  DiscriminationOptions options;
  options.count = 3;
  const auto few = proposeDiscriminatingMeasurements(diagnosis, bench.measurements, candidates, options);
  options.count = 9;
  const auto many = proposeDiscriminatingMeasurements(diagnosis, bench.measurements, candidates, options);
  ASSERT_EQ(few.measurements.size(), 3U);
  ASSERT_EQ(many.measurements.size(), 9U);
  std::set<int> distinct;
  for (const auto& measurement : many.measurements) distinct.insert(measurement.candidate);
  EXPECT_EQ(distinct.size(), many.measurements.size());
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(few.measurements[k].candidate, many.measurements[k].candidate);
  EXPECT_GT(few.measurements.front().separation, 3);
  EXPECT_GT(many.probability, few.probability);
  // The expected divergence between two explanations must not be negative, and must not decrease with more
  // measurements, whichever of the two is true.
  for (const auto& pair : few.pairs) EXPECT_GE(pair.expected, pair.now - 1e-9);
  for (std::size_t k = 0; k < few.pairs.size(); ++k) EXPECT_GE(many.pairs[k].expected, few.pairs[k].expected - 1e-9);
}

TEST(DiscriminatingMeasurements, OfOnePostureCannotSplitWhatDiffersElsewhere) {
  // If a joint stays at one angle in all candidates, no candidate can distinguish different errors of its encoder.
  Bench bench("encoder-eccentricity", "theta4", {0.0012, 0.0012}, 1);
  const Diagnosis diagnosis = bench.diagnosed();
  auto candidates = candidatesOf(bench, diagnosis);
  for (auto& candidate : candidates)
    for (auto& measurement : candidate.measurements) measurement.q = bench.measurements.front().q;
  const auto next = proposeDiscriminatingMeasurements(diagnosis, bench.measurements, candidates);
  EXPECT_FALSE(next.never.empty());
  EXPECT_FALSE(next.alternative_measurements.empty());
}

TEST(DiscriminatingMeasurements, AreNoneWhereNothingIsOpen) {
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::kAdequate;
  const auto next = proposeDiscriminatingMeasurements(diagnosis, {}, {});
  EXPECT_EQ(next.status, DiscriminationStatus::kNothingToDiscriminate);
  EXPECT_TRUE(next.measurements.empty());
  EXPECT_TRUE(openExplanations(diagnosis, 8).empty());
}

}  // namespace
}  // namespace tubeplan::calibration
