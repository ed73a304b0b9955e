#include "app/formats/arm/controller_calibration.hpp"

#include <gtest/gtest.h>

#include "app/formats/arm/arm_reader.hpp"
#include "deflection/row_conventions.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

const std::string kConf =
    "# written by the controller\n[mounting]\n"
    "delta_theta = [ 1e-4, -0.25, 0.75, -0.5 ]\n"
    "delta_a = [ 2e-4, 0.001, 0.09, 0 ]\n"
    "delta_d = [ 5e-4, 11.5, -92.5,\n 81.0 ] # cancel\n"
    "delta_alpha = [ -3e-4, -0.005, -0.004, 0 ]\n"
    "joint_checksum = [ 0x6e0f, 0xa32a, 0xf636, 0x9ec2 ]\n"
    "calibration_status = 2 # 0 == notInitialized / 1 == notLinearised / 2 == Linearised\n"
    "[other]\ndelta_a = [ 9 ]\n";

const std::string kNominal =
    "# the maker's table\nunits: {length: mm, angle: deg, force: N}\nconvention: standard\nlinks:\n"
    "  - name: base\n    dh: {alpha: 90, a: 0, d: 150}\n    joint: {name: q1, type: revolute}\n"
    "  - name: shoulder\n    dh: {alpha: 0, a: -600, d: 0}\n    joint: {name: q2, type: revolute, limits: [-360, "
    "360]}\n"
    "  - name: elbow\n    dh: {alpha: 0, a: -550, d: 0, theta: 10}\n    joint: {name: q3, type: revolute}\n"
    "  - name: wrist\n    dh: {alpha: 0, a: 0, d: 170}\n    joint: {name: q4, type: revolute}\n"
    "tool: {tip: [0, 0, 100]}\n";

YamlFile nominalOf(const std::string& text) { return {"nominal.yaml", text, parseYaml(text, "nominal.yaml")}; }

TEST(ControllerCalibration, isAddedToTheNominalTable) {
  const auto calibration = parseControllerCalibration(kConf, "calibration.conf");
  EXPECT_TRUE(calibration.remarks.empty());
  const std::string text = withControllerCalibration(nominalOf(kNominal), calibration);
  expectSays(text, "# the maker's table");
  const ArmSource before = readArm(parseYaml(kNominal, "n")), after = readArm(parseYaml(text, "a"));
  for (std::size_t k = 0; k < 4; ++k) {
    const auto from = deflection::standardNumbers(before.arm.rows, k),
               to = deflection::standardNumbers(after.arm.rows, k);
    EXPECT_NEAR(to.theta - from.theta, calibration.theta[k], 1e-12) << k;
    EXPECT_NEAR(to.d - from.d, calibration.d[k], 1e-12) << k;
    EXPECT_NEAR(to.a - from.a, calibration.a[k], 1e-12) << k;
    EXPECT_NEAR(to.alpha - from.alpha, calibration.alpha[k], 1e-12) << k;
  }
  EXPECT_EQ(after.arm.rows[1].joint.upper, before.arm.rows[1].joint.upper);
  EXPECT_NEAR(calibration.d[3], 81, 0);
}

TEST(ControllerCalibration, whatTheFileLacksIsNamed) {
  const struct {
    const char *from, *to, *says;
  } kWrong[] = {{"delta_alpha", "delta_beta", "no delta_alpha in [mounting]"},
                {"[mounting]", "[mount]", "no delta_theta in [mounting]"},
                {"0.09, 0 ]", "0.09 ]", "calibration.conf:4: delta_a: found 3 numbers"},
                {"-0.25,", "-0.25 0.1,", "calibration.conf:3: delta_theta"},
                {"-0.25,", "nan,", "calibration.conf:3: delta_theta"},
                {"[ 1e-4, -0.25, 0.75, -0.5 ]", "[ ]", "a list of numbers"},
                {"[ 1e-4, -0.25, 0.75, -0.5 ]", "7", "a list of numbers"}};
  for (const auto& [from, to, says] : kWrong)
    expectSays(messageOf([&, &f = from, &t = to] {
                 (void)parseControllerCalibration(changed(kConf, f, t), "calibration.conf");
               }),
               says);
  const auto doubtful = parseControllerCalibration(changed(kConf, "status = 2", "status = 0"), "c");
  ASSERT_EQ(doubtful.remarks.size(), 1u);
}

TEST(ControllerCalibration, anArmThatItIsNotOfIsRefused) {
  const auto calibration = parseControllerCalibration(kConf, "calibration.conf");
  const struct {
    const char *from, *to, *says;
  } kWrong[] = {
      {"convention: standard\n", "", "do not use the standard Denavit-Hartenberg convention"},
      {"    joint: {name: q4, type: revolute}\n", "", "found 3 joints"},
      {"joint: {name: q4, type: revolute}", "joint: {name: q4, type: prismatic}",
       "does not have both `dh` and a revolute joint"},
  };
  for (const auto& [from, to, says] : kWrong) {
    // A row that is not a revolute joint must have the key theta.
    std::string text = changed(kNominal, from, to);
    if (text.find("name: q4") == std::string::npos) text = changed(text, "d: 170}", "d: 170, theta: 0}");
    if (text.find("prismatic") != std::string::npos) text = changed(text, "d: 170}", "d: 170, theta: 0}");
    expectSays(messageOf([&] { (void)withControllerCalibration(nominalOf(text), calibration); }), says);
  }
}

}  // namespace
}  // namespace tubeplan::app
