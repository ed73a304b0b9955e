// Arms that lack the accelerations, speeds or bodies of the shipped arms are refused or planned with a warning; joints
// with unusual names have columns of their own.
#include <fmt/format.h>

#include <algorithm>

#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

class OtherArms : public ProgramTest {
 protected:
  void SetUp() override {
    for (const char* name : {"puma.yaml", "puma-arm.yaml"}) (void)write(name, contentOf(shippedCells() / name));
  }
  void change(const std::string& file, const std::string& from, const std::string& to) const {
    (void)write(file, changed(contentOf(folder / file), from, to));
  }
};

TEST_F(OtherArms, ATrajectoryNeedsTheAccelerationOfEveryJoint) {
  change("puma-arm.yaml", "max_speed: 60, max_acceleration: 120", "max_speed: 60");
  const Outcome refused = run("plan puma.yaml --tubes spread:12 --trajectory --out made");
  EXPECT_EQ(refused.exit_code, 2);
  expectSays(refused.err, "joint 'J1' has no max_acceleration");
  EXPECT_EQ(run("plan puma.yaml --tubes spread:12 --out made").exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "made/trajectory.yaml"));
}

TEST_F(OtherArms, APlanNeedsWhatItsTimesFollowFrom) {
  change("puma-arm.yaml", ", max_speed: 60, max_acceleration: 120", "");
  const Outcome refused = run("plan puma.yaml --tubes spread:12 --out made");
  EXPECT_EQ(refused.exit_code, 2);
  expectSays(refused.err, "joint 'J1' has neither max_speed nor max_acceleration");
}

TEST_F(OtherArms, WithoutBodiesNothingIsSaidToBeClear) {
  const std::string cell = contentOf(folder / "puma.yaml");
  const auto shapes = cell.find("link_shapes:"), after = cell.find("clearance:");
  ASSERT_LT(shapes, after);
  (void)write("puma.yaml", changed(cell.substr(0, shapes), ", allow: [tool-tip]", "") + cell.substr(after));
  const Outcome planned = run("plan puma.yaml --tubes spread:12 --out made");
  ASSERT_EQ(planned.exit_code, 0) << planned.err;
  for (const std::string& text : {planned.out, run("verify puma.yaml made").out}) {
    expectSays(text, "no link_shapes");
    EXPECT_EQ(text.find("inf"), std::string::npos) << text;
  }
}

TEST_F(OtherArms, ASlideCalledAsACoordinateHasAColumnOfItsOwn) {
  (void)write(
      "arm.yaml",
      "units: {length: m, angle: deg, force: N}\nlinks:\n"
      "  - {name: a, origin: {position: [0, 0, 0], rpy: [0, 90, 0]}, joint: {name: x, type: prismatic, limits: [0, "
      "1]}}\n"
      "  - {name: b, origin: {position: [0, 0, 0], rpy: [0, -90, 0]}, joint: {name: 'z,up', type: prismatic, limits: "
      "[0, 1]}}\ntool: {tip: [0, 0, 0.1]}\n");
  (void)write("cell.yaml", "name: c\narm: arm.yaml\nbase: {position: [0, 0, 0], rpy: [0, 0, 0], known: false}\n");
  const Outcome table = run("readings cell.yaml --template");
  EXPECT_EQ(table.exit_code, 0) << table.err;
  expectSays(table.out, "joint_x_m,\"z,up_m\",x_m");
  std::string rows = table.out.substr(0, table.out.find('\n') + 1);
  const auto columns = std::count(rows.begin(), rows.end(), ',') - 1;  // one comma is part of a name
  ASSERT_EQ(columns, 9) << rows;
  for (int k = 1; k <= 8; ++k)
    rows += fmt::format("r{0},position,,0,{1},{2},{1},0,{3},0.001\n", k, 0.1 * k, 0.01 * k * k, 0.1 + 0.01 * k * k);
  (void)write("readings.csv", rows);
  const Outcome compared = run("compare cell.yaml readings.csv");
  EXPECT_NE(compared.exit_code, 2) << compared.err;
  expectSays(compared.out, "as an error of x: mean ");
}

TEST_F(OtherArms, WhereNothingIsFreeTheCellIsNamed) {
  ASSERT_EQ(run("simulate " + shipped("bench.yaml") + " --design bench --readings 20 --seed 1 --out made").exit_code,
            0);
  for (const char* name : {"bench.yaml", "cobra-arm.yaml"}) (void)write(name, contentOf(shippedCells() / name));
  std::string cell = contentOf(folder / "bench.yaml");
  const auto list = cell.find("\nidentify:");
  ASSERT_NE(list, std::string::npos);
  const auto end = cell.find("\n", list + 1);
  (void)write("bench.yaml", cell.substr(0, list) + cell.substr(end));
  EXPECT_NE(run("diagnose bench.yaml made/measurements.csv").exit_code, 2);
  const Outcome refused = run("identify bench.yaml made/measurements.csv");
  EXPECT_EQ(refused.exit_code, 2) << refused.out;
  expectSays(refused.err, "bench.yaml: no parameter is free");
}

}  // namespace
}  // namespace tubeplan::app
