// Simulated campaigns must keep the measurements of each set-up together, hold out whole points, vary only the
// stiffnesses of the true arm, and refuse invalid designs.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/calibration/bench_campaign.hpp"

namespace tubeplan::calibration {
namespace {

using Eigen::Vector3d;

TEST(SimulatedCampaign, SaysWhyNoPostureServes) {
  const CampaignTruth truth = benchTruth();
  CampaignDesign far = designOf(MeasurementKind::kPosition, 1e-4);
  far.region_W = Eigen::AlignedBox3d(Vector3d(10, 10, 10), Vector3d(11, 11, 11));
  const auto beyond = simulate(truth, far, 30);
  EXPECT_EQ(beyond.status, CampaignStatus::kOutOfReach);
  EXPECT_NE(beyond.reason.find("2000 with the tip outside the region"), std::string::npos) << beyond.reason;
  CampaignOptions options;
  options.is_clear = [](int, double load, const Eigen::VectorXd&) { return load < 30 * kPound; };
  const auto blocked = simulateCampaign(truth, designOf(MeasurementKind::kPosition, 1e-4), options);
  EXPECT_EQ(blocked.status, CampaignStatus::kOutOfReach);
  EXPECT_NE(blocked.reason.find("in collision with the scene"), std::string::npos) << blocked.reason;
  EXPECT_TRUE(blocked.measurements.empty()) << "all loads of a posture or none";
}

TEST(SimulatedCampaign, StopsWhenAsked) {
  int calls = 0;
  const auto campaign = simulateCampaign(benchTruth(), designOf(MeasurementKind::kPosition, 1e-4), {},
                                         {{}, [&calls] { return ++calls > 20; }});
  EXPECT_EQ(campaign.status, CampaignStatus::kStopped);
  EXPECT_LT(campaign.measurements.size(), 120u);
}

TEST(SimulatedCampaign, RefusesDesignsThatMeanNothing) {
  const auto problem = [](auto change, int measurements = 30) {
    CampaignDesign design = designOf(MeasurementKind::kPosition, 1e-4);
    change(design);
    return simulate(benchTruth(design.setups), design, measurements);
  };
  const auto refused = [&](auto change, int measurements = 30) {
    return problem(change, measurements).status == CampaignStatus::kRefused;
  };
  EXPECT_FALSE(refused([](auto&) {}));
  EXPECT_TRUE(refused([](auto&) {}, 0));
  EXPECT_TRUE(refused([](auto&) {}, 100001));
  EXPECT_TRUE(refused([](auto& d) { d.loads = {}; }));
  EXPECT_TRUE(refused([](auto& d) { d.loads = {0, -1}; }));
  EXPECT_TRUE(refused([](auto& d) { d.kind = MeasurementKind::kDeflection; }));
  EXPECT_TRUE(refused([](auto& d) { d.kind = MeasurementKind::kDistance; }));
  EXPECT_TRUE(refused([](auto& d) { d.sigma = -1; }));
  EXPECT_TRUE(refused([](auto& d) { d.held_out = 1; }));
  EXPECT_TRUE(refused([](auto& d) { d.setups = 11; }));
  EXPECT_TRUE(refused([](auto& d) { d.place = CampaignPlace::kHoles; }));
  EXPECT_TRUE(refused([](auto& d) {
    d.kind = MeasurementKind::kTouch;
    d.points_known = false;
    d.loads = {0};
  }));
}

TEST(SimulatedCampaign, HoldsOutWholePoints) {
  CampaignDesign design = designOf(MeasurementKind::kTouch, 1e-4);
  design.held_out = 0.3;
  const auto campaign = simulate(benchTruth(), design, 300);
  std::map<std::string, std::set<bool>> sides;
  std::set<std::string> kept;
  for (const auto& measurement : campaign.measurements) {
    sides[measurement.point].insert(measurement.is_held_out);
    if (measurement.is_held_out) kept.insert(measurement.point);
  }
  for (const auto& [point, side] : sides) EXPECT_EQ(side.size(), 1u) << point;
  EXPECT_EQ(kept.size(), 30u);
}

TEST(SimulatedCampaign, KeepsOneSetUpTogetherAndEachOnItsOwnBase) {
  CampaignDesign design = designOf(MeasurementKind::kPosition, 1e-4);
  design.setups = 3;
  const auto measurements = simulate(benchTruth(3), design, 90).measurements;
  EXPECT_TRUE(std::is_sorted(measurements.begin(), measurements.end(),
                             [](const auto& a, const auto& b) { return a.setup < b.setup; }));
  for (const char* setup : {"S1", "S2", "S3"})
    EXPECT_EQ(std::count_if(measurements.begin(), measurements.end(), [&](const auto& m) { return m.setup == setup; }),
              30);
}

TEST(CampaignTruth, SpreadsStiffnessesAlone) {
  const deflection::Arm& arm = benchCell().arm;
  TruthOptions options;
  options.parameters = deflection::parametersOf(arm);
  options.spread = 0.1;
  std::vector<double> logarithms;
  for (options.seed = 1; options.seed <= 200; ++options.seed) {
    deflection::Arm truth = drawTruth(arm, benchCell().X_WB, options).arm;
    for (const auto& parameter : options.parameters) {
      const double ratio = deflection::locate(truth, parameter.path) / parameter.value;
      const bool is_stiffness = parameter.name.find(".joint_stiffness.") != std::string::npos ||
                                parameter.name.find(".beam.") != std::string::npos;
      if (is_stiffness) {
        logarithms.push_back(std::log(ratio));
      } else {
        EXPECT_TRUE(ratio == 1 || parameter.value == 0) << parameter.name;
      }
    }
  }
  EXPECT_EQ(logarithms.size(), 200u * 8) << "four joint stiffnesses, E and Iz of two beams";
  EXPECT_NEAR(deviation(logarithms), 0.1, 0.1 * 4 / std::sqrt(2. * static_cast<double>(logarithms.size())))
      << "four standard errors";
}

TEST(CampaignTruth, WithoutErrorsIsTheCellItself) {
  const auto truth = drawTruth(benchCell().arm, mockupCell().X_WB);
  ASSERT_EQ(truth.bases.size(), 1u);
  EXPECT_EQ(truth.bases.front().X_WB.matrix(), mockupCell().X_WB.matrix());
  EXPECT_EQ(truth.bases.front().setup, "");
}

}  // namespace
}  // namespace tubeplan::calibration
