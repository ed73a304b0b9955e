// Campaigns with inclinometers on rows of the arm must give exact measurements, and these measurements must reveal
// hidden effects.
#include <gtest/gtest.h>

#include <set>

#include "app/studies/measurements/discrimination_candidates.hpp"
#include "calibration/diagnosis/diagnosis.hpp"
#include "calibration/measurements/measurement_placement.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "deflection/effects/effect.hpp"
#include "tests/calibration/bench_campaign.hpp"

namespace tubeplan::calibration {
namespace {

CampaignDesign tiltsOfRows(const deflection::Arm& arm, const std::vector<const char*>& rows) {
  CampaignDesign design = designOf(MeasurementKind::kTilt, 0);
  design.turn_sigma = kAngleSigma;
  for (const char* row : rows) design.rows.push_back(deflection::findRow(arm, row).value());
  return design;
}

TEST(RowCampaigns, ASimulatedPostureIsReadOnEveryRowUnderEveryLoad) {
  const CampaignTruth truth = benchTruth();
  CampaignDesign design = tiltsOfRows(truth.arm, {"base-link", "forearm"});
  design.turn_sigma = 0;
  const auto campaign = simulate(truth, design, 60);
  ASSERT_EQ(campaign.status, CampaignStatus::kDone) << campaign.reason;
  for (std::size_t k = 0; k < campaign.measurements.size(); ++k) {
    const Measurement& measurement = campaign.measurements[k];
    EXPECT_EQ(measurement.row, design.rows[k % 2]);
    EXPECT_EQ(measurement.load, design.loads[k / 2 % 3]);
    EXPECT_EQ(measurement.q, campaign.measurements[k - k % 6].q);
    EXPECT_EQ(rowsOf(measurement), 2) << "an axis upright is not read";
    const auto expected = predictMeasurement(truth.arm, truth.bases.front().X_WB, measurement).value;
    EXPECT_LE((expected - kindOf(measurement).measured(measurement)).norm(), 1e-9);
  }
  design.kind = MeasurementKind::kPosition;
  EXPECT_EQ(simulate(truth, design, 60).status, CampaignStatus::kRefused);
}

/// Returns the diagnosis of an arm with a hidden effect from tilts measured on the listed rows, or on the tool if the
/// list is empty.
Diagnosis diagnosisOfTilts(const deflection::Arm& arm, const std::string& effect, const std::string& at,
                           const std::vector<double>& values, const std::vector<const char*>& rows,
                           std::uint64_t seed) {
  deflection::Arm truth = arm;
  truth.effects.push_back(deflection::makeEffect(arm, effect, at).effect);
  truth.effects.back().values = values;
  auto measurements = simulate(drawTruth(truth, benchCell().X_WB), tiltsOfRows(arm, rows), 120, seed).measurements;
  for (auto& measurement : measurements) measurement.sigma = kTurnLever * measurement.turn_sigma;
  DiagnosisOptions options;
  options.baseline.free = {{"tool.joint_stiffness.z"}, false};
  return diagnose(placeForMeasurements(arm, benchCell().X_WB, true, measurements), measurements, options);
}

const FoundEffect* findEffect(const Explanation& explanation, const std::string& effect, const std::string& at) {
  for (const auto& found : explanation.effects)
    if (found.effect == effect && found.at == at) return &found;
  return nullptr;
}

/// Expects that the effect with its true value is among the alternatives, and that the error falls to the noise.
/// Returns the number of alternatives with this effect alone.
int expectNamed(const Diagnosis& found, const std::string& effect, const std::string& at, double value) {
  bool is_named = false;
  int alone = 0;
  for (const auto& explanation : found.alternatives) {
    const auto* named = findEffect(explanation, effect, at);
    if (!named) continue;
    is_named = true;
    alone += explanation.effects.size() == 1;
    EXPECT_NEAR(named->fitted.values.front(), value, 0.05 * value);
  }
  EXPECT_TRUE(is_named) << found.alternatives.size() << " alternatives";
  EXPECT_LT(found.heldout_after.rms, 1.15 * found.noise_floor);
  EXPECT_GT(found.heldout_before.rms, 2 * found.noise_floor);
  return alone;
}

const std::vector<const char*> kFourRows{"base-link", "latch-link", "forearm", "tool"};

// Every alternative must contain a compliance of theta2's joint or of its cable, because both rotate theta2 under load.
// A compliance of the preceding joint, whose axis is vertical, hardly changes the tilts.
TEST(RowCampaigns, NameAHiddenCompliance) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const auto found = diagnosisOfTilts(benchCell().arm, "joint-compliance", "latch-link.z", {1e-5}, kFourRows, seed);
    expectNamed(found, "joint-compliance", "latch-link.z", 1e-5);
    for (const auto& explanation : found.alternatives)
      EXPECT_TRUE(findEffect(explanation, "joint-compliance", "latch-link.z") ||
                  findEffect(explanation, "cable-stretch", "theta2"));
  }
}

TEST(RowCampaigns, NameAHiddenSagByGravity) {
  deflection::Arm weightless = benchCell().arm;
  for (auto& row : weightless.rows) row.weight = {};
  int alone = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    alone += expectNamed(diagnosisOfTilts(weightless, "gravity-sag", "theta2", {0.003, 0, 0.002}, kFourRows, seed),
                         "gravity-sag", "theta2", 0.003);
  EXPECT_GE(alone, 5) << "one in twenty may have something beside it";
}

// Further measurements must be proposed on the rows that were measured so far, at postures that the arm can reach.
TEST(RowCampaigns, AreGoneOnWithOnTheSameRows) {
  const auto& cell = benchCell();
  const CampaignDesign design = tiltsOfRows(cell.arm, {"base-link", "forearm"});
  const auto measurements = simulate(drawTruth(cell.arm, cell.X_WB), design, 60).measurements;
  const PlacedArm placed = placeForMeasurements(cell.arm, cell.X_WB, true, measurements);
  const auto candidates = app::discriminationCandidates(cell, placed, measurements);
  ASSERT_GT(candidates.size(), 10u);
  std::set<int> rows;
  for (const auto& candidate : candidates)
    for (const auto& measurement : candidate.measurements) {
      ASSERT_TRUE(measurement.row);
      rows.insert(*measurement.row);
      EXPECT_EQ(measurement.kind, MeasurementKind::kTilt);
      const auto expected = expectedMeasurement(placed, measurement);
      ASSERT_TRUE(expected);
      EXPECT_EQ(rowsOf(*expected), 2);
      EXPECT_TRUE(predictMeasurement(cell.arm, cell.X_WB, *expected).value.allFinite());
      EXPECT_EQ(measurement.turn_sigma, kAngleSigma);
    }
  EXPECT_EQ(rows, std::set<int>(design.rows.begin(), design.rows.end()));
}

}  // namespace
}  // namespace tubeplan::calibration
