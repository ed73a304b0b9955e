// An arm that is exported in any convention and read back is unchanged. A controller's calibration is imported, and a
// plan with the calibrated arm is proved.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

class ArmExport : public ProgramTest {
 protected:
  /// Writes a rigid arm with nearly parallel middle axes. Bodies are on the last link only, whose frame is the same in
  /// every convention.
  void SetUp() override {
    const char* origins[] = {"[0, 0, 0.18], rpy: [0, 0, 0]",           "[0, 0, 0], rpy: [1.5702, 0.0003, 0]",
                             "[-0.61, 0, 0], rpy: [0.0002, 0.001, 0]", "[-0.57, 0, 0.17], rpy: [-0.0005, 0.0004, 0]",
                             "[0, -0.12, 0], rpy: [1.5709, 0, 0]",     "[0, 0.12, 0], rpy: [-1.5707, 0, 0]"};
    std::string arm = "units: {length: m, angle: rad, force: N}\nlinks:\n";
    for (int k = 0; k < 6; ++k)
      arm += fmt::format(
          "  - name: link{0}\n    origin: {{position: {1}}}\n    joint: {{name: q{0}, type: revolute, limits: [-6.28, "
          "6.28], max_speed: 1, max_acceleration: 2, encoder_sigma: 3e-5}}\n",
          k + 1, origins[k]);
    write("arm.yaml", arm + "tool: {tip: [0, 0, 0.15]}\n");
    write("cell.yaml", cellOf("arm.yaml"));
  }

  static std::string cellOf(const std::string& arm) {
    return "arm: " + arm + R"(
base: {position: [0.1, 0.55, -0.75], rpy: [0, 0, -1.5708], known: true}
tubesheet:
  layout: {type: square, pitch: 0.03, first_row: 0.06, radius: 0.5, rows: 10, columns: 12}
  hole_diameter: 0.02
  leg: hot
  viewed_from: below
calibration_tool:
  steps: [{diameter: 0.0148, tolerance: 0.00225}, {diameter: 0.018, tolerance: 0.00025}]
  lengths: [0.01, 0.01]
scene:
  - {name: tubesheet, keep_side: {point: [0, 0, 0], normal: [0, 0, -1]}, allow: [tool-tip]}
link_shapes:
  link6: [{name: tool-tip, capsule: {from: [0, 0, 0.08], to: [0, 0, 0.15], radius: 0.006}}]
clearance: 0.005
)";
  }

  nlohmann::json figures(const std::string& file) {
    return nlohmann::json::parse(run("arm show " + file + " --json -").out);
  }
};

TEST_F(ArmExport, everyConventionIsTheSameArm) {
  const double reach = figures("arm.yaml")["reach"];
  for (const std::string convention : {"modified", "standard", "origin"}) {
    const std::string out = convention + ".yaml";
    const Outcome exported = run("arm export arm.yaml --convention " + convention + " --out " + out);
    ASSERT_EQ(exported.exit_code, 0) << exported.err;
    EXPECT_NEAR(figures(out)["reach"].get<double>(), reach, 1e-6);
    write("cell-" + out, cellOf(out));
    for (const std::string joints : {"0.1,-1,1.2,0.3,-0.4,0.5", "2,-2,0.5,-1,1,0"}) {
      const std::string pose = " --joints=" + joints + " --json -";
      const auto one = nlohmann::json::parse(run("pose cell.yaml" + pose).out),
                 other = nlohmann::json::parse(run("pose cell-" + out + pose).out);
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(one["rigid"]["position"][k].get<double>(), other["rigid"]["position"][k].get<double>(), 1e-9);
    }
    const Outcome planned = run("plan cell-" + out + " --tubes spread:3 --out plan-" + convention);
    EXPECT_EQ(planned.exit_code, 0) << planned.err;
  }
}

TEST_F(ArmExport, aControllersTableIsImportedPlannedAndProved) {
  write(
      "nominal.yaml", R"(units: {length: m, angle: rad, force: N}
convention: standard
links:
)" + [] {
        std::string rows;
        const char* table[] = {"alpha: 1.5707963267948966, a: 0, d: 0.18",
                               "alpha: 0, a: -0.61, d: 0",
                               "alpha: 0, a: -0.57, d: 0",
                               "alpha: 1.5707963267948966, a: 0, d: 0.17",
                               "alpha: -1.5707963267948966, a: 0, d: 0.12",
                               "alpha: 0, a: 0, d: 0.11"};
        for (int k = 0; k < 6; ++k)
          rows += fmt::format(
              "  - name: link{0}\n    dh: {{{1}}}\n    joint: {{name: q{0}, type: revolute, limits: [-6.28, 6.28], "
              "max_speed: "
              "1, max_acceleration: 2, encoder_sigma: 3e-5}}\n",
              k + 1, table[k]);
        return rows;
      }() + "tool: {tip: [0, 0, 0.15]}\n");
  // Nearly parallel axes have distant common normals: their offsets d are hundreds of metres and cancel to 0.6 mm.
  write("calibration.conf",
        "[mounting]\ndelta_theta = [0, 0, 0, 0, 0, 0]\ndelta_a = [0, 0, 0, 0, 0, 0]\n"
        "delta_d = [0, 300, -500, 200.0006, 0, 0]\ndelta_alpha = [0, 1e-6, 2e-6, 0, 0, 0]\ncalibration_status = 2\n");
  const Outcome imported = run("arm import calibration.conf --nominal nominal.yaml --out real.yaml");
  ASSERT_EQ(imported.exit_code, 0) << imported.err;
  EXPECT_LT(figures("real.yaml")["reach"].get<double>(), 2.5);
  write("cell-real.yaml", cellOf("real.yaml"));
  ASSERT_EQ(run("plan cell-real.yaml --tubes spread:3 --out plan").exit_code, 0);
  EXPECT_EQ(run("verify cell-real.yaml plan").exit_code, 0);
}

TEST_F(ArmExport, TheExportedFileAloneErrsByWhatIsPrinted) {
  ASSERT_EQ(run("arm export arm.yaml --out robot.urdf").exit_code, 0);
  ASSERT_EQ(run("arm import robot.urdf --out arm.yaml --cell cell.yaml").exit_code, 0);
  write("cell.yaml", contentOf(folder / "cell.yaml") + "identify: [tool.tip, geometry]\n");
  write("design.yaml", "{kind: position, loads: [0], postures: 80, sigma: 2e-5}");
  ASSERT_EQ(run("simulate cell.yaml --design design.yaml --hide joint-scale@q2:0.002 --hide joint-offset@q4:0.01 "
                "--base-error 0.05,0.02 --out made")
                .exit_code,
            0);
  ASSERT_EQ(run("improve cell.yaml made/measurements.csv --out better.yaml").exit_code, 0);
  const auto errorAlone = [&] {
    EXPECT_EQ(run("arm import out.urdf --out alone.yaml --cell alone-cell.yaml").exit_code, 0);
    return nlohmann::json::parse(
               run("identify alone-cell.yaml made/measurements.csv --stage tool.tip --json -").out)["rms"]["after_base"]
        .get<double>();
  };
  const Outcome as_it_is = run("arm export better.yaml --into robot.urdf --out out.urdf");
  expectSays(as_it_is.err, "joint-scale@q2");
  const double without = errorAlone();
  const Outcome again =
      run("arm export better.yaml --measurements made/measurements.csv --into robot.urdf --out out.urdf");
  ASSERT_EQ(again.exit_code, 0) << again.err;
  std::smatch stated;
  ASSERT_TRUE(std::regex_search(again.out, stated, std::regex("exported model fitted again: ([0-9.e-]+) m")))
      << again.out;
  EXPECT_NEAR(errorAlone() / std::stod(stated[1]), 1, 0.01);
  EXPECT_LT(errorAlone(), without);
}

TEST_F(ArmExport, whatCannotBeIsRefused) {
  write("soft.yaml",
        changed(contentOf(folder / "arm.yaml"), "  - name: link4", "    joint_stiffness: {x: 1000}\n  - name: link4"));
  const struct {
    const char *arguments, *says;
  } kWrong[] = {
      {"arm export soft.yaml --convention standard --out o.yaml", "joint_stiffness"},
      {"arm export arm.yaml --convention craig --out o.yaml", "craig"},
      {"arm show arm.yaml --convention standard", "--convention"},
      {"arm import calibration.conf --out o.yaml", "--nominal"},
      {"arm import calibration.conf --measurements m.csv --out o.yaml", "--measurements"},
      {"arm import calibration.conf --nominal arm.yaml --cell c.yaml --out o.yaml", "--cell"},
  };
  write("calibration.conf", "[mounting]\n");
  for (const auto& [arguments, says] : kWrong) {
    const Outcome refused = run(arguments);
    EXPECT_EQ(refused.exit_code, 2) << arguments;
    expectSays(refused.err, says);
  }
}

}  // namespace
}  // namespace tubeplan::app
