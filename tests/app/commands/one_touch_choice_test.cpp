// All commands that choose touches for the base choose the same touches from the same holes; `touches` predicts the
// sigmas that `calibrate` states.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/formats/measurements/measurement_input.hpp"
#include "app/formats/sheet/touch_input.hpp"
#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

/// Statements on the uncertainty of the arm's parameters, as lines of a cell file.
constexpr const char* kDoubts[] = {"", "uncertainty: none\n", "uncertainty: {stiffness: 0.3, weight: 0.1}\n"};

class OneTouchChoice : public ProgramTest {
 protected:
  void writeCells(const std::string& doubt) const {
    write("cobra-arm.yaml", contentOf(shippedCells() / "cobra-arm.yaml"));
    write("cell.yaml", contentOf(shippedCells() / "mockup.yaml") + doubt);
  }

  [[nodiscard]] json jsonOf(const std::string& question) const {
    const Outcome outcome = run(question + " --json -");
    EXPECT_EQ(outcome.exit_code, 0) << question << "\n" << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }

  /// Returns the touches proposed for work at `holes` holes, which are spread over the sheet and are also the
  /// candidates.
  [[nodiscard]] json proposed(int holes) const {
    const std::string count = std::to_string(holes);
    return jsonOf("touches cell.yaml --goal base --tubes spread:" + count + " --candidates " + count);
  }

  static std::set<std::string> holesOf(const json& proposal) {
    std::set<std::string> holes;
    for (const auto& touch : proposal["next_readings"]) holes.insert(touch["point"].get<std::string>());
    return holes;
  }

  [[nodiscard]] std::set<std::string> touchedIn(const std::string& file) const {
    const Cell cell = readCell((folder / "cell.yaml").string());
    std::set<std::string> holes;
    for (const auto& touch : parseMeasurementText(contentOf(folder / file), file, cell)) holes.insert(touch.point);
    return holes;
  }
};

TEST_F(OneTouchChoice, OfAllWhoPlaceABase) {
  for (const char* doubt : kDoubts) {
    SCOPED_TRACE(doubt);
    writeCells(doubt);
    const json proposal = proposed(24);
    const auto holes = holesOf(proposal);
    ASSERT_EQ(holes.size(), 3U);
    const Outcome plan = run("plan cell.yaml --touches auto --truth cell.yaml --tubes spread:2 --out planned");
    ASSERT_EQ(plan.exit_code, 0) << plan.err;
    EXPECT_EQ(touchedIn("planned/touches.csv"), holes) << "plan --touches auto";
    const json campaign = jsonOf("campaign cell.yaml --runs 2 --choice best --tubes spread:20");
    EXPECT_EQ(campaign["settings"][0]["touched_holes"].get<std::set<std::string>>(), holes) << "campaign --choice best";
    const json base = jsonOf("calibrate cell.yaml planned/touches.csv");
    ASSERT_EQ(base["verdict"], "adequate");
    for (std::size_t k = 0; k < 6; ++k) {
      const double stated = base["sigma"][k < 3 ? "position" : "rotation"][k % 3];
      EXPECT_NEAR(proposal["base"]["numbers"][k]["sigma"]["after"], stated, 0.05 * stated) << k;
    }
    std::filesystem::remove_all(folder / "planned");
  }
}

TEST_F(OneTouchChoice, OfASensitivity) {
  for (const char* doubt : kDoubts) {
    SCOPED_TRACE(doubt);
    writeCells(doubt);
    const json found = jsonOf("sensitivity cell.yaml --tubes spread:40");
    EXPECT_EQ(found["touches"].get<std::set<std::string>>(), holesOf(proposed(40)));
  }
}

}  // namespace
}  // namespace tubeplan::app
