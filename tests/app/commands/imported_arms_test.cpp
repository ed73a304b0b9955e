// Arms of five makers are imported from URDF, given a tool and placed below a tube sheet; their plans are proved. The
// arms are unchanged by an export and import.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "app/formats/arm/arm_reader.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using Eigen::Vector3d;

struct Robot {
  const char* name;
  double ahead, below;  ///< horizontal and vertical distance from the base to the sheet [m]
};
void PrintTo(const Robot& robot, std::ostream* out) { *out << robot.name; }

constexpr double kTool = 0.15;  // [m]

std::string textOf(const Vector3d& v) { return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z()); }

class ImportedArm : public ProgramTest, public testing::WithParamInterface<Robot> {
 protected:
  void SetUp() override {
    write("robot.urdf", contentOf(std::filesystem::path(TUBEPLAN_SOURCE_DIR) / "tests/app/urdf" /
                                  (std::string(GetParam().name) + ".urdf")));
    const Outcome imported = run("arm import robot.urdf --out arm.yaml --cell cell.yaml");
    ASSERT_EQ(imported.exit_code, 0) << imported.err;
  }

  /// Mounts a tool along the tool axis, with a solid body that may enter the holes.
  void putToolOn() {
    std::string text = contentOf(folder / "arm.yaml");
    const auto arm = readArm(parseYaml(text, "arm.yaml")).arm;
    const Vector3d flange = arm.p_LT, axis = arm.tool_axis_L;
    text = std::regex_replace(text, std::regex(R"(tool: \{tip: \[[^\]]*\])"),
                              "tool: {tip: " + textOf(flange + kTool * axis));
    write("arm.yaml", text);
    std::string cell = contentOf(folder / "cell.yaml");
    if (cell.find("link_shapes:") == std::string::npos) cell += "link_shapes:\n";
    write("cell.yaml",
          cell + fmt::format("  {}:\n    - {{name: tool-tip, capsule: {{from: {}, to: {}, radius: 0.0074}}}}\n",
                             arm.rows.back().name, textOf(flange + 0.05 * axis),
                             textOf(flange + (kTool - 0.008) * axis)));
  }

  void standBelowSheet() {
    std::string cell = std::regex_replace(contentOf(folder / "cell.yaml"), std::regex(R"(position: \[0, 0, 0\])"),
                                          fmt::format("position: [{}, 0, {}]", -GetParam().ahead, -GetParam().below),
                                          std::regex_constants::format_first_only);
    write("cell.yaml", cell + R"(tubesheet:
  layout: {type: square, pitch: 0.025, first_row: 0.025, radius: 0.2, rows: 11, columns: 11}
  hole_diameter: 0.0193
  leg: hot
  viewed_from: below
calibration_tool:
  steps: [{diameter: 0.0148, tolerance: 0.00225}, {diameter: 0.01636, tolerance: 0.00147}, {diameter: 0.0188, tolerance: 0.00025}]
  lengths: [0.0127, 0.0127, 0.0127]
scene:
  - {name: tubesheet, keep_side: {point: [0, 0, 0], normal: [0, 0, -1]}, allow: [tool-tip]}
clearance: 0.005
)");
  }
};

TEST_P(ImportedArm, IsPlannedAndProvedUnderASheet) {
  putToolOn();
  standBelowSheet();
  const Outcome planned = run("plan cell.yaml --tubes spread:20 --seed 1 --out out");
  ASSERT_EQ(planned.exit_code, 0) << planned.out << planned.err;
  const auto plan = nlohmann::json::parse(contentOf(folder / "out/plan.json"));
  EXPECT_EQ(plan["tubes"].size(), 20u);
  const Outcome verified = run("verify cell.yaml out");
  EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
}

TEST_P(ImportedArm, IsTheSameOnceExportedAndImportedAgain) {
  ASSERT_EQ(run("arm export arm.yaml --out again.urdf").exit_code, 0);
  ASSERT_EQ(run("arm import again.urdf --out again.yaml").exit_code, 0);
  ASSERT_EQ(run("arm show arm.yaml --json first.json").exit_code, 0);
  ASSERT_EQ(run("arm show again.yaml --json second.json").exit_code, 0);
  const auto first = nlohmann::json::parse(contentOf(folder / "first.json")),
             second = nlohmann::json::parse(contentOf(folder / "second.json"));
  ASSERT_FALSE(first["rows"].empty());
  ASSERT_EQ(first["rows"].size(), second["rows"].size());
  for (std::size_t k = 0; k < first["rows"].size(); ++k) {
    const auto a = first["rows"][k].flatten(), b = second["rows"][k].flatten();
    for (const auto& [at, value] : a.items())
      if (value.is_number())
        EXPECT_NEAR(value.get<double>(), b.value(at, 1e300), 1e-6) << at;
      else
        EXPECT_EQ(value, b.at(at)) << at;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, ImportedArm,
                         testing::Values(Robot{"ur5", 0.45, 0.75}, Robot{"irb120", 0.35, 0.75},
                                         Robot{"panda", 0.4, 0.85}, Robot{"iiwa14", 0.5, 1.0},
                                         Robot{"m10ia", 0.8, 1.3}),
                         [](const auto& robot) { return std::string(robot.param.name); });

}  // namespace
}  // namespace tubeplan::app
