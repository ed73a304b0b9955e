// `tubeplan identify` finds the base from touches of holes of the tube sheet, and names a hole that was recorded under
// the name of another.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/formats/sheet/touch_input.hpp"
#include "tests/app/program.hpp"
#include "tests/calibration/estimation/cobra_touches.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class IdentifyHoles : public ProgramTest {
 protected:
  IdentifyHoles() : cell(readCell((shippedCells() / "mockup.yaml").string())) {}

  /// Returns touches of holes all over the sheet, without coordinates. The hole with index `wrong` is recorded under
  /// the name of a hole in the next column; if `wrong` is -1, all names are right.
  [[nodiscard]] std::string touches(int wrong) const {
    constexpr std::pair<int, int> kHoles[] = {{5, 25},  {8, 57},  {6, 90},  {20, 40},
                                              {24, 75}, {38, 57}, {15, 15}, {16, 100}};
    std::vector<std::pair<double, double>> places;
    for (const auto& [row, column] : kHoles) {
      const auto* tube = cell.sheet->find(row, column);
      places.emplace_back(tube->x / kInch, tube->y / kInch);
    }
    const auto touched = calibration::touchedCell(places);
    std::string text = "id,kind,point,theta1_deg,theta2_deg,theta3_deg,theta4_deg,sigma_in\n";
    int k = 0;
    for (const auto& touch : calibration::touchesOf(touched, 0.005, 5)) {
      const auto [row, column] = kHoles[k];
      const Eigen::VectorXd q = touch.q / kDegree;
      text += fmt::format("{},touch,R{}C{},{:.6f},{:.6f},{:.6f},{:.6f},0.005\n", touch.id, row,
                          column + (k == wrong ? 1 : 0), q[0], q[1], q[2], q[3]);
      ++k;
    }
    return text;
  }

  /// Returns the result of `identify`, and expects this exit code: 0 if the touches fit, 1 if the residuals of a fit of
  /// only the base exceed the noise.
  [[nodiscard]] json identified(int exit_code = 0) const {
    const Outcome outcome = run("identify " + shipped("mockup.yaml") + " touches.csv --folds 0 --json -");
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    return json::parse(outcome.out);
  }

  Cell cell;
};

TEST_F(IdentifyHoles, TheBaseIsFoundFromTheirNames) {
  (void)write("touches.csv", touches(-1));
  const json result = identified();
  EXPECT_TRUE(result["warnings"].empty()) << result["warnings"];
  EXPECT_TRUE(result["outliers"].empty()) << result["outliers"];
  const auto& base = result["bases"][0]["base"]["position"];
  EXPECT_NEAR(base[0], 0.8, 0.05);
  EXPECT_NEAR(base[1], 42.4, 0.05);
  EXPECT_NEAR(base[2], -43.5, 0.05);
}

TEST_F(IdentifyHoles, AMistakenHoleIsNamedAndSoIsTheOneThatFits) {
  constexpr const char* kNamed[] = {"R5C26 fits R5C25", "R8C58 fits R8C57", "R6C91 fits R6C90", "R20C41 fits R20C40",
                                    "R24C76 fits R24C75"};
  for (int wrong = 0; wrong < 5; ++wrong) {
    (void)write("touches.csv", touches(wrong));
    const json result = identified(1);
    ASSERT_FALSE(result["warnings"].empty()) << wrong;
    expectSays(result["warnings"][0].get<std::string>(), kNamed[wrong]);
    EXPECT_EQ(result["outliers"][0]["id"], "T" + std::to_string(wrong + 1));
    EXPECT_NEAR(result["outliers"][0]["size"].get<double>(), 1.0625, 0.1);
  }
}

}  // namespace
}  // namespace tubeplan::app
