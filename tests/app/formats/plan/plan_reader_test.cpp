// Tests of plan files: valid content is read, invalid content is refused with its position in the file.
#include "app/formats/plan/plan_reader.hpp"

#include <nlohmann/json.hpp>

#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

/// A plan for two tubes of the mock-up, with every ninth row of its path.
class PlanReader : public FolderTest {
 protected:
  void SetUp() override {
    const std::string both = contentOf(std::filesystem::path(TUBEPLAN_SOURCE_DIR) / "tests/fuzz/corpus/plan/two_tubes");
    const auto path = both.find("time_s,");
    plan = json::parse(both.substr(0, path));
    rows = both.substr(path);
  }

  [[nodiscard]] PlanFiles read() const {
    (void)write("plan.json", plan.dump());
    (void)write("path.csv", rows);
    return readPlanFiles(folder, cell);
  }

  /// Returns the message that refuses the plan with `value` at the JSON pointer `place`.
  [[nodiscard]] std::string refusalOf(const std::string& place, const char* value) {
    const json::json_pointer pointer(place);
    const json kept = plan;
    plan[pointer] = json::parse(value);
    const std::string message = messageOf([&] { (void)read(); });
    plan = kept;
    return message;
  }

  /// Returns the message that refuses the plan with the first `from` in its path replaced by `to`.
  [[nodiscard]] std::string refusalOfRow(const std::string& from, const std::string& to) {
    const std::string kept = rows;
    rows = changed(rows, from, to);
    const std::string message = messageOf([&] { (void)read(); });
    rows = kept;
    return message;
  }

  Cell cell = readCell((shippedCells() / "mockup.yaml").string());
  json plan;
  std::string rows;
};

TEST_F(PlanReader, ReadsWhatStandsThereInInternalUnits) {
  const PlanFiles files = read();
  ASSERT_EQ(files.plan.tubes.size(), 2u);
  EXPECT_DOUBLE_EQ(files.plan.tubes[0].hole_W.x(), plan["tubes"][0]["hole"][0].get<double>() * 0.0254);
  EXPECT_GT(files.plan.path.size(), 10u);
  EXPECT_EQ(files.path_echoes.size(), files.plan.path.size());
  EXPECT_EQ(files.compensation, "via-point");
  EXPECT_EQ(files.leg, "hot");
}

TEST_F(PlanReader, TakesAPathThatAnotherProgramSaved) {
  const PlanFiles before = read();
  std::string saved;
  for (const char c : rows) saved += c == '\n' ? std::string("\r\n") : std::string(1, c);
  rows = "\xEF\xBB\xBF" + saved;
  EXPECT_EQ(read().path_fingerprint, before.path_fingerprint);
}

TEST_F(PlanReader, RefusesValuesThatNoPlanHas) {
  expectSays(refusalOf("/tubes/0/row", "2.5"), "plan.json tubes[0].row: found '2.5', expected a whole number");
  expectSays(refusalOf("/tubes/0/row", "true"), "tubes[0].row");
  expectSays(refusalOf("/tubes/1/column", "1e10"), "tubes[1].column");
  expectSays(refusalOf("/tubes/1/joints", "[1, 2, 3]"), "tubes[1].joints: found '[1,2,3]', expected 4 numbers");
  expectSays(refusalOf("/tubes/1/joints/2", "null"), "tubes[1].joints[2]: found 'null', expected a finite number");
  expectSays(refusalOf("/tubes", "7"), "plan.json tubes: found '7', expected a list");
  expectSays(refusalOf("/tubes/0/leg", "1"), "tubes[0].leg: found '1', expected a string");
  expectSays(refusalOf("/unreachable", "[{}]"), "unreachable[0]: the key 'row' is missing");
  expectSays(refusalOf("/sheet", "[]"), "plan.json sheet: found '[]', expected an object with the key fingerprint");
  expectSays(refusalOf("/start", "[0, 0]"), "plan.json start");
}

/// Each of these values must be refused, because the verification would prove less than it appears to prove.
TEST_F(PlanReader, RefusesConditionsThatWouldWeakenTheProof) {
  expectSays(refusalOf("/padding", R"({"sigmas": -3})"),
             "padding.sigmas: found '-3', expected a finite number, at least 0");
  expectSays(refusalOf("/compensation", "\"other\""), "expected none, goal-point or via-point");
  expectSays(refusalOf("/tubes/0/dwell_s", "-1"), "tubes[0].dwell_s");
  expectSays(refusalOf("/tubes/0/zone", "-1"), "tubes[0].zone");
  expectSays(refusalOf("/load", "-5"), "plan.json load");
  expectSays(refusalOf("/insertion", "-5"), "plan.json insertion");
}

TEST_F(PlanReader, RefusesRowsThatNoPathHas) {
  for (const char* segment : {"1e300", "1.5", "0", "-5", "2147483648"})
    expectSays(refusalOfRow("\n0,1,", std::string("\n0,") + segment + ","),
               std::string("path.csv:2 (segment): found '") + segment + "', expected a whole number, at least 1");
  expectSays(refusalOfRow("\n0,1,", "\nnan,1,"), "path.csv:2 (time_s): found 'nan', expected a finite number");
  expectSays(refusalOfRow(",approach,", ",dance,"), "path.csv:2 (kind): found 'dance'");
  expectSays(refusalOfRow("time_s", "time_min"), "path.csv:1: found 'time_min,segment");
  expectSays(refusalOfRow("\n0,1,", "\n0,1,1,"), "path.csv:2 (row): found 11 fields, expected 10");
}

}  // namespace
}  // namespace tubeplan::app
