// In the step table of `tubeplan ladder`, more steps of the tool enter the holes with a better model.
#include <nlohmann/json.hpp>
#include <numeric>

#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class LadderSteps : public ProgramTest {
 protected:
  LadderSteps() {
    for (const char* name : {"mockup.yaml", "mockup-true.yaml", "cobra-arm.yaml", "cobra-arm-true.yaml", "bench.yaml"})
      write(name, contentOf(shippedCells() / name));
  }

  void measure() const {
    const Outcome outcome =
        run("simulate mockup-true.yaml --design bowl --readings 36 --held-out 0.3 --seed 3 --out set");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }

  [[nodiscard]] json ladder(const std::string& arguments) const {
    const Outcome outcome = run("ladder set/measurements.csv " + arguments + " --json -");
    EXPECT_EQ(outcome.exit_code, 0) << arguments << "\n" << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }

  /// Returns the mean number of steps that enter; expects the counts to add up to all holes.
  static double meanSteps(const json& steps, int holes) {
    EXPECT_EQ(steps["holes"], holes);
    double sum = 0;
    int counted = 0, k = 0;
    for (const char* name : {"zero", "one", "two", "three"}) {
      EXPECT_EQ(steps[name], steps["counts"][static_cast<std::size_t>(k)]) << name;
      counted += steps[name].get<int>();
      sum += k++ * steps[name].get<double>();
    }
    EXPECT_EQ(counted, holes) << steps;
    EXPECT_LE(steps["no_posture"], steps["zero"]);
    return sum / holes;
  }
};

TEST_F(LadderSteps, moreOfTheModelIsMoreSteps) {
  measure();
  const json found =
      ladder("mockup.yaml mockup-true.yaml --rigid --truth mockup-true.yaml --holes 150 --report page.html");
  ASSERT_EQ(found["models"].size(), 3u);
  EXPECT_EQ(found["models"][0]["name"], "mockup.yaml, rigid");
  EXPECT_EQ(found["step_table"]["real_arm"], "mockup-true.yaml");
  EXPECT_EQ(found["step_table"]["unmodelled_sigma"], 0);
  const double rigid = meanSteps(found["models"][0]["steps"], 150), drawn = meanSteps(found["models"][1]["steps"], 150),
               true_arm = meanSteps(found["models"][2]["steps"], 150);
  EXPECT_LT(rigid, drawn);
  EXPECT_LT(drawn, true_arm);
  // A model that equals the true arm centres the tool in every hole; only the tool's tilt can then keep a step out.
  EXPECT_EQ(found["models"][2]["steps"]["zero"], 0);
  EXPECT_LT(found["models"][2]["steps"]["centring_error"]["p95"], 1e-6);
  const std::string page = contentOf(folder / "page.html");
  expectSays(page, "\"steps\":" + found["models"][0]["steps"]["counts"].dump());
}

TEST_F(LadderSteps, withoutATruthTheBestModelStandsInWithTheNoiseFloor) {
  measure();
  const std::string cells = "mockup.yaml mockup-true.yaml --holes 120";
  const json found = ladder(cells);
  const std::string real = found["step_table"]["real_arm"];
  EXPECT_TRUE(real.starts_with("mockup-true.yaml, with an unmodelled error")) << real;
  const double floor = found["models"][1]["rms"]["noise_floor"], sigma = found["step_table"]["unmodelled_sigma"];
  EXPECT_NEAR(sigma * std::sqrt(3.), floor, 1e-9);
  EXPECT_LT(meanSteps(found["models"][0]["steps"], 120), meanSteps(found["models"][1]["steps"], 120));
  EXPECT_LT(found["models"][1]["steps"]["three"], 120) << "the unmodelled error costs steps";
  EXPECT_EQ(ladder(cells)["models"][0]["steps"], found["models"][0]["steps"]) << "the same seed, the same holes";
  EXPECT_NE(ladder(cells + " --seed 2")["models"][0]["steps"], found["models"][0]["steps"]);
  const Outcome text = run("ladder set/measurements.csv " + cells);
  expectSays(text.out, "holes by number of inserted steps");
  expectSays(text.out, "true arm: mockup-true.yaml");
}

TEST_F(LadderSteps, aCellWithoutASheetHasNoneUnlessOneIsNamed) {
  measure();
  const std::string cell = contentOf(folder / "mockup.yaml");
  write("plain.yaml", cell.substr(0, cell.find("tubesheet:")));
  const json found = ladder("plain.yaml --holes 50");
  expectSays(found["step_table"]["reason"], "--sheet CELL");
  EXPECT_FALSE(found["models"][0].contains("steps"));
  expectSays(run("ladder set/measurements.csv plain.yaml").out, "no step table: ");
  const std::string under = " --truth mockup-true.yaml --holes 50";
  EXPECT_EQ(ladder("plain.yaml --sheet mockup.yaml" + under)["models"][0]["steps"],
            ladder("mockup.yaml" + under)["models"][0]["steps"])
      << "the same model under the same sheet";
}

TEST_F(LadderSteps, aTruthUnderAnotherSheetIsRefused) {
  measure();
  write("narrow.yaml", changed(contentOf(folder / "mockup-true.yaml"), "radius: 60.39, rows: 49, columns: 114",
                               "radius: 30, rows: 25, columns: 56"));
  const Outcome outcome = run("ladder set/measurements.csv mockup.yaml --truth narrow.yaml --json -");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  expectSays(outcome.err, "this tube sheet (fingerprint ");
}

}  // namespace
}  // namespace tubeplan::app
