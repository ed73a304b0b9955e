// In every command, proofs and step counts state the base for which they hold and how its pose was determined.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

/// A way to determine the base pose, and the words by which every command states it.
struct PlacedAs {
  const char *name, *touches, *status, *words;
  bool is_warned_of;
};

constexpr const char* kNominalWords = "for the nominal base; not calibrated";

class BaseStandings : public ProgramTest {
 protected:
  BaseStandings() {
    for (const char* name : {"mockup.yaml", "mockup-true.yaml", "cobra-arm.yaml", "cobra-arm-true.yaml"})
      write(name, contentOf(shippedCells() / name));
    // This cell states that its arm is exact, so touches of another arm do not fit it.
    write("exact.yaml", contentOf(shippedCells() / "mockup.yaml") + "uncertainty: none\n");
    EXPECT_EQ(run("simulate mockup.yaml --design bowl --readings 4 --loads 0 --seed 3 --out fits").exit_code, 0);
    write("wrong.csv", withOneHoleMoved(contentOf(folder / "fits/measurements.csv")));
  }

  /// Returns the touches with ids, kinds, points, loads and joints only, as when holes are named by hand. The last
  /// touch names another hole of the same column, so that no base pose fits the touches.
  static std::string withOneHoleMoved(const std::string& touches) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(touches);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream fields(line);
      rows.emplace_back();
      for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(field);
    }
    std::string& hole = rows.back().at(2);
    hole = (hole.starts_with("R3C") ? "R9" : "R3") + hole.substr(hole.find('C'));
    std::string text;
    for (const auto& row : rows) {
      for (std::size_t k = 0; k < row.size(); ++k)
        if (!isCoordinate(rows.front().at(k))) text += (k ? "," : "") + row[k];
      text += "\n";
    }
    return text;
  }

  static bool isCoordinate(const std::string& column) {
    return column == "x_in" || column == "y_in" || column == "z_in";
  }

  [[nodiscard]] json jsonOf(const std::string& arguments) const {
    return json::parse(run(arguments + " --json -").out, nullptr, false);
  }

  [[nodiscard]] json documentIn(const std::string& file) const {
    return json::parse(contentOf(folder / file), nullptr, false);
  }

  static void expectOf(const PlacedAs& base, const json& document) {
    EXPECT_EQ(document["base"]["status"], base.status);
    EXPECT_EQ(document["base"]["words"], base.words);
    EXPECT_EQ(document["base"]["placed"], std::string(base.status) != "nominal");
    EXPECT_EQ(document["base"]["position"].size(), 3u) << "the pose stays where it was";
    EXPECT_EQ(document["warnings"].dump().find("are valid only if") != std::string::npos, base.is_warned_of)
        << document["warnings"];
  }
};

TEST_F(BaseStandings, AreNamedByEveryCommandAndFile) {
  const PlacedAs bases[] = {
      {"nominal", "", "nominal", kNominalWords, true},
      {"calibrated", " --touches fits/measurements.csv", "calibrated", "for the base calibrated from 4 touches", false},
      {"misfit", " --touches auto --truth mockup-true.yaml", "misfit",
       "for the base calibrated from 3 touches that do not fit", true}};
  for (const auto& base : bases) {
    SCOPED_TRACE(base.name);
    const std::string out = base.name;
    const std::string cell = std::string(base.status) == "misfit" ? "exact.yaml" : "mockup.yaml";
    const Outcome plan = run("plan " + cell + " --tubes spread:3 --out " + out + base.touches);
    ASSERT_EQ(plan.exit_code, 0) << plan.err;
    expectSays(plan.out, std::string("proved ") + base.words);
    expectSays(plan.out.substr(0, plan.out.find('\n')), base.words);
    expectOf(base, documentIn(out + "/plan.json"));
    expectSays(documentIn(out + "/plan.json")["sentence"], base.words);
    expectSays(contentOf(folder / out / "report.html"), base.words);
    const Outcome verified = run("verify " + cell + " " + out);
    EXPECT_EQ(verified.exit_code, 0) << verified.out;
    expectSays(verified.out, std::string("proved ") + base.words);
    expectOf(base, jsonOf("verify " + cell + " " + out));
  }
}

TEST_F(BaseStandings, AreNamedByScores) {
  const PlacedAs bases[] = {
      {"mockup.yaml", "", "calibrated", "for the base calibrated from 3 touches", false},
      {"mockup-true.yaml", "", "misfit", "for the base calibrated from 3 touches that do not fit", true}};
  for (const auto& base : bases) {
    SCOPED_TRACE(base.name);
    const std::string question = std::string("score exact.yaml --tubes spread:3 --truth ") + base.name;
    expectSays(run(question).out, base.words);
    expectOf(base, jsonOf(question));
  }
}

TEST_F(BaseStandings, AreNamedByRepeatedScores) {
  struct Repeated {
    const char* cell;
    bool is_misfit;  ///< the cell states no uncertainty, and the true arm's errors far exceed the touch noise
  };
  for (const auto& [cell, is_misfit] : {Repeated{"mockup.yaml", false}, Repeated{"exact.yaml", true}}) {
    SCOPED_TRACE(cell);
    const std::string question =
        std::string("score ") + cell + " --truth mockup-true.yaml --runs 4 --unmodelled " + (is_misfit ? "0.03" : "0");
    const std::string words = "for the base that each run calibrates from 3 touches";
    expectSays(run(question).out, words);
    const json document = jsonOf(question), base = document["base"];
    EXPECT_EQ(base["status"], "each-run");
    EXPECT_EQ(base["words"], words);
    EXPECT_EQ(base["placed"], true);
    EXPECT_EQ(base["touches"], 3);
    EXPECT_EQ(base["misfits"] > 0, is_misfit) << base;
    EXPECT_EQ(document["warnings"].empty(), base["misfits"] == 0) << document["warnings"];
  }
}

TEST_F(BaseStandings, ACampaignIsForTheBaseOfEachRun) {
  constexpr const char* kWords = "for the base that each run calibrates from ";
  for (const std::string touches : {"3", "4", "3,5"}) {
    SCOPED_TRACE(touches);
    const std::string out = "many" + touches;
    const Outcome outcome =
        run("campaign mockup.yaml --runs 2 --tubes spread:20 --touches " + touches + " --out " + out);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json document = documentIn(out + "/campaign.json");
    const bool differ = touches.find(',') != std::string::npos;
    EXPECT_EQ(document["base"]["status"], "each-run");
    EXPECT_EQ(document["base"]["placed"], true);
    EXPECT_EQ(document["base"]["touches"], differ ? 0 : std::stoi(touches));
    EXPECT_EQ(document["base"]["words"], kWords + (differ ? "touches" : touches + " touches"));
    for (const auto& setting : document["settings"]) {
      EXPECT_EQ(setting["base"]["status"], "each-run");
      EXPECT_EQ(setting["base"]["touches"], setting["touches"]);
      EXPECT_EQ(setting["warnings"].empty(), setting["base"]["misfits"] == 0) << setting["warnings"];
    }
    expectSays(outcome.out, document["base"]["words"]);
    expectSays(contentOf(folder / out / "report.html"), document["settings"][0]["base"]["words"]);
  }
}

TEST_F(BaseStandings, ACampaignCountsTheRunsWhoseTouchesDoNotFit) {
  const Outcome outcome =
      run("campaign exact.yaml --truth mockup-true.yaml --unmodelled 0.03 --runs 4 --tubes spread:20 --out misfits");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json setting = documentIn("misfits/campaign.json")["settings"][0];
  EXPECT_GT(setting["base"]["misfits"], 0);
  ASSERT_EQ(setting["warnings"].size(), 1U);
  expectSays(outcome.out, setting["warnings"][0]);
  expectSays(contentOf(folder / "misfits" / "report.html"), setting["warnings"][0]);
}

TEST_F(BaseStandings, ARefusedCalibrationLeavesTheNominalBaseAndSaysSo) {
  for (const char* question : {"calibrate mockup.yaml wrong.csv --out placed.yaml",
                               "plan mockup.yaml --tubes spread:3 --touches wrong.csv --out refused"}) {
    SCOPED_TRACE(question);
    const Outcome outcome = run(question);
    EXPECT_EQ(outcome.exit_code, 1);
    expectSays(outcome.out + outcome.err, std::string("existing plans remain valid ") + kNominalWords);
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "placed.yaml"));
  EXPECT_FALSE(std::filesystem::exists(folder / "refused/plan.json"));
}

TEST_F(BaseStandings, OfACellThatAPlanWroteArePlannedAlike) {
  constexpr double kAlike = 4e-3;  // tolerance, limited by the digits in a file
  for (const char* touches : {"fits/measurements.csv", "auto --truth mockup-true.yaml"}) {
    SCOPED_TRACE(touches);
    const std::string tubes = " --tubes spread:5 --out ";
    ASSERT_EQ(run(std::string("plan mockup.yaml --touches ") + touches + tubes + "touched").exit_code, 0);
    ASSERT_EQ(run("plan touched/cell.yaml" + tubes + "again").exit_code, 0);
    const json touched = documentIn("touched/plan.json"), again = documentIn("again/plan.json");
    EXPECT_EQ(touched["base"]["words"], again["base"]["words"]);
    EXPECT_EQ(touched["probabilities"]["model_error"].is_null(), again["probabilities"]["model_error"].is_null());
    ASSERT_EQ(touched["tubes"].size(), again["tubes"].size());
    for (const auto& tube : touched["tubes"]) {
      const auto same = std::find_if(again["tubes"].begin(), again["tubes"].end(), [&](const json& other) {
        return other["row"] == tube["row"] && other["column"] == tube["column"];
      });
      ASSERT_NE(same, again["tubes"].end()) << tube["name"];
      for (std::size_t k = 0; k < tube["probability_by_steps"].size(); ++k)
        EXPECT_NEAR(tube["probability_by_steps"][k], (*same)["probability_by_steps"][k], kAlike) << tube["name"];
    }
  }
}

}  // namespace
}  // namespace tubeplan::app
