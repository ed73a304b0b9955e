// Tests of design files of measurement campaigns: files that are read, and files that are refused.
#include "app/formats/cell/campaign_reader.hpp"

#include <cmath>

#include "app/formats/cell/cell_reader.hpp"
#include "tests/app/test_files.hpp"
#include "tests/units.hpp"

namespace tubeplan::app {
namespace {

using calibration::CampaignPlace, calibration::MeasurementKind;

class CampaignReader : public FolderTest {
 protected:
  const Cell cell = readCell((shippedCells() / "bench.yaml").string());

  [[nodiscard]] CampaignFile read(const std::string& text, bool has_sheet = false) const {
    return readCampaignFile(write("design.yaml", text), cell.arm, cell.units, has_sheet);
  }
  void expectRefused(const std::string& text, const std::vector<std::string>& words) const {
    const std::string message = messageOf([&] { (void)read(text); });
    for (const auto& word : words) expectSays(message, word);
  }
};

TEST_F(CampaignReader, ReadsEveryKey) {
  const auto file = read(
      "name: mine\nkind: touch\npoints: unknown\nat: anywhere\npostures: 40\npostures_per_point: 2\nloads: [0, 30]\n"
      "region: {from: [0, -10, 20], to: [60, 10, 50]}\nsetups: 3\nsplit: 0.3\nsigma: 0.01\n");
  const auto& design = file.design;
  EXPECT_EQ(design.name, "mine");
  EXPECT_EQ(design.kind, MeasurementKind::kTouch);
  EXPECT_FALSE(design.points_known);
  EXPECT_EQ(design.place, CampaignPlace::kAnywhere);
  EXPECT_EQ(file.postures, 40);
  EXPECT_EQ(design.postures_per_point, 2);
  ASSERT_EQ(design.loads.size(), 2u);
  EXPECT_NEAR(design.loads[1], 30 * kPound, 1e-12);
  EXPECT_TRUE(design.region_W->min().isApprox(Eigen::Vector3d(0, -10, 20) * kInch));
  EXPECT_TRUE(design.region_W->max().isApprox(Eigen::Vector3d(60, 10, 50) * kInch));
  EXPECT_EQ(design.setups, 3);
  EXPECT_EQ(design.held_out, 0.3);
  EXPECT_NEAR(design.sigma, 0.01 * kInch, 1e-18);
  const auto distance = read("kind: distance\nanchor: [1, 2, 3]\n").design;
  EXPECT_TRUE(distance.anchor_W->isApprox(Eigen::Vector3d(1, 2, 3) * kInch));
}

TEST_F(CampaignReader, TakesWhatSuitsTheKindForWhatIsLeftOut) {
  const auto position = read("kind: position\n");
  EXPECT_EQ(position.design.name, "design");
  EXPECT_EQ(position.postures, std::nullopt);
  EXPECT_EQ(position.design.loads.size(), 3u);
  EXPECT_NEAR(position.design.sigma, 0.003 * kInch, 1e-12);
  EXPECT_EQ(read("kind: touch\n", true).design.place, CampaignPlace::kHoles);
  EXPECT_EQ(read("kind: touch\n", false).design.place, CampaignPlace::kPlane);
  EXPECT_EQ(read("kind: touch\npoints: unknown\n", true).design.place, CampaignPlace::kAnywhere);
  EXPECT_NEAR(read("kind: touch\n").design.sigma, 0.005 * kInch, 1e-12);
  EXPECT_EQ(read("kind: position\nat: holes\n", true).design.loads, std::vector<double>{0});
  EXPECT_EQ(read("kind: deflection\n").design.loads.front(), 20 * kPound) << "no load bends nothing";
}

TEST_F(CampaignReader, ReadsTheRowsThatAreReadAndTheNoiseOfEachCoordinate) {
  const auto tilt = read("kind: tilt\nrows: [forearm, base-link]\n").design;
  ASSERT_EQ(tilt.rows.size(), 2u);
  EXPECT_EQ(cell.arm.rows.at(static_cast<std::size_t>(tilt.rows[0])).name, "forearm");
  EXPECT_EQ(cell.arm.rows.at(static_cast<std::size_t>(tilt.rows[1])).name, "base-link");
  const auto tracked = read("kind: position\nsigmas: [0.001, 0.005, 0.005]\ncorrelations: [0.9, 0, -0.1]\n").design;
  EXPECT_TRUE(tracked.sigma_W->isApprox(Eigen::Vector3d(0.001, 0.005, 0.005) * kInch));
  EXPECT_TRUE(tracked.correlation_W->isApprox(Eigen::Vector3d(0.9, 0, -0.1)));
  EXPECT_NEAR(tracked.sigma, std::sqrt(17e-6) * kInch, 1e-15);
  expectRefused("kind: tilt\nrows: [forarm]\n", {"design.yaml:2", "'forarm'", "latch-link", "did you mean 'forearm'?"});
  expectRefused("kind: tilt\nrows: []\n", {"one or more rows of the arm"});
  expectRefused("kind: tilt\nrows: [forearm, forearm]\n", {"forearm", "listed twice"});
  expectRefused("kind: position\nrows: [forearm]\n", {"`rows`", "kind tilt"});
  expectRefused("kind: position\nsigmas: [0.001, 0, 0.005]\n", {"sigmas", "above zero"});
  expectRefused("kind: distance\nanchor: [1, 2, 3]\nsigmas: [1, 1, 1]\n", {"`sigmas`", "for readings of x, y, z"});
  expectRefused("kind: position\ncorrelations: [0, 0, 0]\n", {"`correlations`", "add sigmas"});
  expectRefused("kind: position\nsigmas: [1, 1, 1]\ncorrelations: [0.9, 0.9, -0.9]\n", {"positive definite"});
  expectRefused("kind: position\nsigmas: [1, 1, 1]\ncorrelations: [0.9, 0.9]\n", {"three correlations"});
}

TEST_F(CampaignReader, RefusesWhatItDoesNotKnow) {
  expectRefused("at: holes\n", {"no key 'kind'"});
  expectRefused("kind: positon\n", {"design.yaml:1:7", "'positon'", "position, touch, deflection, distance, axis, ",
                                    "did you mean 'position'?"});
  expectRefused("kind: position\nload: [1]\n", {"'load'", "did you mean 'loads'?"});
  expectRefused("kind: touch\npoints: maybe\n", {"'maybe'", "known or unknown"});
  expectRefused("kind: touch\nat: everywhere\n", {"'everywhere'", "anywhere, plane or holes"});
}

TEST_F(CampaignReader, RefusesNumbersThatCannotBe) {
  expectRefused("kind: position\nloads: [0, -5]\n", {"design.yaml:2:12", "-5", "zero or more"});
  expectRefused("kind: position\nloads: []\n", {"loads", "one or more loads"});
  expectRefused("kind: position\npostures: 0\n", {"postures", "from 1 to"});
  expectRefused("kind: position\nsplit: 1\n", {"split", "0 to below 1"});
  expectRefused("kind: position\nsigma: -1\n", {"sigma", "zero or more"});
  expectRefused("kind: position\nsetups: 1.5\n", {"setups", "a whole number"});
  expectRefused("kind: position\nregion: {from: [0, 0, 0], to: [1, 0, 1]}\n", {"region.to", "above `from`"});
}

TEST_F(CampaignReader, RefusesKeysThatTheKindDoesNotHave) {
  expectRefused("kind: position\npoints: known\n", {"`points`", "kind touch"});
  expectRefused("kind: deflection\npostures_per_point: 2\n", {"`postures_per_point`", "kind touch"});
  expectRefused("kind: position\nanchor: [1, 2, 3]\n", {"anchor", "kind distance"});
  expectRefused("kind: distance\n", {"need an anchor", "add anchor"});
  expectRefused("kind: axis\nanchor: [1, 2, 3]\n", {"need a direction", "add direction"});
  expectRefused("kind: position\ndirection: [0, 0, 1]\n", {"direction", "kind axis"});
  expectRefused("kind: axis\nanchor: [1, 2, 3]\ndirection: [0, 0, 0]\n", {"not all zero"});
  expectRefused("kind: steps\nturn_sigma: 0.1\n", {"turn_sigma", "for readings of angles"});
  expectRefused("kind: tilt\nturn_sigma: -0.1\n", {"turn_sigma", "zero or more"});
}

}  // namespace
}  // namespace tubeplan::app
