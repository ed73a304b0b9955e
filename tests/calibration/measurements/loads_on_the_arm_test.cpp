// For measurements under tip forces and moments, and for arms with side chains, derivatives are exact and 95 %
// intervals contain the truth as often as they should.
#include <gtest/gtest.h>

#include "calibration/estimation/identification.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "deflection/rotation.hpp"
#include "tests/calibration/bench_campaign.hpp"
#include "tests/calibration/estimation/freeing.hpp"

namespace tubeplan::calibration {
namespace {

using Eigen::Vector3d;

/// Returns the bench's arm with a second arm on its base link, whose weight is noticeable only by the deflection that
/// it causes.
deflection::Arm withSideChain() {
  deflection::Arm arm = benchCell().arm;
  deflection::SideChain<double> chain{2, {}};
  chain.rows.resize(2);
  chain.rows[0].name = "left-shoulder";
  chain.rows[0].placement = deflection::Origin<double>{{0.2, 0, 0.1}, {0, 0.3, 0}};
  chain.rows[0].joint = {.name = "left1", .type = deflection::JointType::kRevolute, .lower = -2, .upper = 2};
  chain.rows[1].name = "left-elbow";
  chain.rows[1].placement = deflection::DenavitHartenberg<double>{1.5, 0.5, 0, 0};
  chain.rows[1].joint = {.name = "left2", .type = deflection::JointType::kRevolute, .lower = -2, .upper = 2};
  chain.rows[1].weight.lumps = {{150, {0.6, 0, 0}}};
  arm.side_chains = {chain};
  return arm;
}

PlacedArm placed(const deflection::Arm& arm) { return {arm, {{"", benchCell().X_WB, true}}}; }

/// Counts the 95 % intervals that miss the true value, over all seeds.
struct LoadedCoverage {
  int outside = 0, all = 0;
  void add(const Identification& found, const deflection::Arm& truth) {
    ASSERT_EQ(found.status, IdentificationStatus::kDone) << found.reason;
    for (const auto& number : found.numbers) {
      if (number.unknown.owner == Unknown::Owner::kBase) continue;
      const double value = deflection::findParameter(truth, number.unknown.name)->value;
      outside += value < number.lower || value > number.upper;
      ++all;
    }
  }
};

TEST(LoadsOnTheArm, DerivativesByTheBaseTurnTheWrenchToo) {
  const auto& X_WB = benchCell().X_WB;
  for (const auto& arm : {benchCell().arm, withSideChain()}) {
    Measurement m;
    m.q = Eigen::Vector4d(0.5, 1.2, -1, -0.3);
    m.side_q = Eigen::VectorXd::Constant(arm.side_chains.empty() ? 0 : 2, 0.7);
    m.load = 60;
    m.wrench = TipWrench{{40, -70, 20}, {15, 5, -25}};
    PredictionRequest request;
    request.by_base = true;
    const auto prediction = predictMeasurement(arm, X_WB, m, request);
    ASSERT_TRUE(prediction.ok);
    for (int axis = 0; axis < 3; ++axis) {
      constexpr double kStep = 1e-4;
      const auto turned = [&](double h) {
        Eigen::Isometry3d X = X_WB;
        X.linear() = deflection::rotationFromVector<double>(h * Vector3d::Unit(axis)) * X.linear();
        return predictMeasurement(arm, X, m).value;
      };
      const Eigen::VectorXd slope = (turned(kStep) - turned(-kStep)) / (2 * kStep);
      EXPECT_LE((slope - prediction.by_base.col(3 + axis)).norm(), 1e-6 * slope.norm()) << axis;
    }
  }
}

TEST(LoadsOnTheArm, PushesShowWhatGravityCannot) {
  LoadedCoverage coverage;
  const std::vector<std::string> names{"tool.joint_stiffness.z", "forearm.joint_stiffness.z",
                                       "mezzanine-platform.joint_stiffness.x"};
  double blind_p = 0, loaded_width = 0, pushed_width = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CampaignTruth truth = benchTruth(1, 3.5e-5);
    truth.bases.front().X_WB = benchCell().X_WB;
    CampaignDesign design = designOf(MeasurementKind::kPosition, kPositionSigma);
    const auto loaded = simulate(truth, design, 45, seed);
    design.push = 180;
    auto campaign = simulate(truth, design, 45, seed);
    ASSERT_EQ(campaign.status, CampaignStatus::kDone) << campaign.reason;
    const PlacedArm start = placed(withEncoders(benchCell().arm, 3.5e-5));
    PlacedArm known = start;
    known.arm = truth.arm;
    for (const auto& name : names)
      deflection::locate(known.arm, deflection::findParameter(known.arm, name)->path) =
          deflection::findParameter(start.arm, name)->value;
    const auto pushed = identify(known, campaign.measurements, freeing(names));
    coverage.add(pushed, truth.arm);
    pushed_width += pushed.numbers[0].upper - pushed.numbers[0].lower;
    const auto by_weight = identify(known, loaded.measurements, freeing(names));
    loaded_width += by_weight.numbers[0].upper - by_weight.numbers[0].lower;
    for (auto& measurement : campaign.measurements) measurement.wrench.reset();
    blind_p = std::max(blind_p, identify(known, campaign.measurements, freeing(names)).p_value);
  }
  EXPECT_EQ(coverage.all, 120);
  EXPECT_LE(coverage.outside, 14);  // 6 expected; more than 14 have a probability below 0.002
  EXPECT_LT(blind_p, 1e-6) << "without its column a push is a misfit";
  EXPECT_LT(pushed_width, loaded_width) << "what pushes sideways says more of the tool's joint";
}

TEST(LoadsOnTheArm, WeightOfASideChainIsFound) {
  LoadedCoverage coverage;
  double ignored_p = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const CampaignTruth truth{withEncoders(withSideChain(), 3.5e-5), {{"", benchCell().X_WB}}};
    const auto campaign = simulate(truth, designOf(MeasurementKind::kPosition, kPositionSigma), 45, seed);
    ASSERT_EQ(campaign.status, CampaignStatus::kDone) << campaign.reason;
    PlacedArm start = placed(truth.arm);
    start.arm.side_chains[0].rows[1].weight.lumps[0].weight = 40;
    coverage.add(identify(start, campaign.measurements,
                          freeing({"left-elbow.weight.lumps.1", "mezzanine-platform.joint_stiffness.x"})),
                 truth.arm);
    start.arm.side_chains.clear();
    ignored_p = std::max(
        ignored_p, identify(start, campaign.measurements, freeing({"mezzanine-platform.joint_stiffness.x"})).p_value);
  }
  EXPECT_EQ(coverage.all, 60);
  EXPECT_LE(coverage.outside, 9);  // 3 expected; more than 9 have a probability below 0.002
  EXPECT_LT(ignored_p, 1e-6);
}

}  // namespace
}  // namespace tubeplan::calibration
