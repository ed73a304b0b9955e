// `tubeplan watch` from outside: quiet on the calibration's own touches, an alarm after the base has moved.
#include <boost/algorithm/string.hpp>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class WatchCommand : public ProgramTest {
 protected:
  WatchCommand() {
    EXPECT_EQ(run("plan " + shipped("mockup.yaml") + " --tubes R10C40 --touches auto --truth " +
                  shipped("mockup.yaml") + " --out p")
                  .exit_code,
              0);
  }

  /// Returns the table of the calibration's touches `times` times, with new ids and with x shifted by `shift` [in].
  std::string visits(int times, double shift, int& id) {
    std::vector<std::string> lines, columns;
    boost::split(lines, contentOf(folder / "p/touches.csv"), boost::is_any_of("\n"));
    boost::split(columns, lines.front(), boost::is_any_of(","));
    const auto x = static_cast<std::size_t>(std::ranges::find(columns, "x_in") - columns.begin());
    std::string text = id == 0 ? lines.front() + "\n" : "";
    for (int k = 0; k < times; ++k)
      for (std::size_t line = 1; line < lines.size() && !lines[line].empty(); ++line) {
        std::vector<std::string> fields;
        boost::split(fields, lines[line], boost::is_any_of(","));
        fields[0] = "V" + std::to_string(++id);
        for (std::size_t axis = 0; axis < 3; ++axis)
          fields[x + axis] = std::to_string(std::stod(fields[x + axis]) + noise_(random_) + (axis == 0 ? shift : 0));
        text += boost::join(fields, ",") + "\n";
      }
    return text;
  }

 private:
  std::mt19937_64 random_{1};
  std::normal_distribution<double> noise_{0, 0.005};  // [in]
};

TEST_F(WatchCommand, IsQuietUntilTheBaseMoves) {
  int id = 0;
  const std::string before = visits(4, 0, id);
  (void)write("quiet.csv", before);
  const Outcome quiet = run("watch p/cell.yaml quiet.csv --assume as-is --json -");
  EXPECT_EQ(quiet.exit_code, 0) << quiet.err << quiet.out;
  EXPECT_EQ(json::parse(quiet.out)["status"], "quiet");
  (void)write("moved.csv", before + visits(6, 0.15, id));
  const Outcome moved = run("watch p/cell.yaml moved.csv --assume as-is --json -");
  EXPECT_EQ(moved.exit_code, 1) << moved.err;
  const json alarm = json::parse(moved.out)["alarm"];
  EXPECT_EQ(alarm["kind"], "base-step");
  EXPECT_EQ(alarm["since"], "V13");
  EXPECT_NEAR(std::abs(alarm["base_step"]["shift"][0].get<double>()), 0.15, 0.1);
}

TEST_F(WatchCommand, TheAnswerDoesNotDependOnTheUnitOfTheReadings) {
  int id = 0;
  std::string inches = visits(4, 0, id);
  inches += visits(6, 0.15, id);
  std::vector<std::string> lines, columns;
  boost::split(lines, inches, boost::is_any_of("\n"));
  boost::split(columns, lines.front(), boost::is_any_of(","));
  int converted = 0;
  std::string millimetres = boost::replace_all_copy(lines.front(), "_in", "_mm") + "\n";
  for (std::size_t line = 1; line < lines.size() && !lines[line].empty(); ++line) {
    std::vector<std::string> fields;
    boost::split(fields, lines[line], boost::is_any_of(","));
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (columns[c].ends_with("_in") && !fields[c].empty()) {
        fields[c] = std::to_string(25.4 * std::stod(fields[c]));
        ++converted;
      }
    millimetres += boost::join(fields, ",") + "\n";
  }
  ASSERT_GT(converted, 0);
  (void)write("in.csv", inches);
  (void)write("mm.csv", millimetres);
  const json one = json::parse(run("watch p/cell.yaml in.csv --assume as-is --json -").out);
  const json other = json::parse(run("watch p/cell.yaml mm.csv --assume as-is --json -").out);
  for (const char* key : {"reading", "since", "kind", "test"}) EXPECT_EQ(one["alarm"][key], other["alarm"][key]) << key;
  EXPECT_NEAR(one["alarm"]["base_step"]["shift"][0].get<double>(),
              other["alarm"]["base_step"]["shift"][0].get<double>(), 1e-4);
}

TEST_F(WatchCommand, ReadingsThatAreNotInTheOrderOfTimeAreRefused) {
  int id = 0;
  std::vector<std::string> lines;
  const std::string table = visits(2, 0, id);
  boost::split(lines, table, boost::is_any_of("\n"));
  std::string timed = lines.front() + ",time_min\n";
  for (std::size_t line = 1; line < lines.size() && !lines[line].empty(); ++line)
    timed += lines[line] + "," + std::to_string(100 - line) + "\n";
  (void)write("timed.csv", timed);
  const Outcome outcome = run("watch p/cell.yaml timed.csv --assume as-is");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("timed.csv:3"), std::string::npos) << outcome.err;
}

TEST_F(WatchCommand, VisitsInWhichNoStepEnteredRaiseTheAlarm) {
  std::vector<std::string> lines, columns;
  boost::split(lines, contentOf(folder / "p/touches.csv"), boost::is_any_of("\n"));
  boost::split(columns, lines.front(), boost::is_any_of(","));
  const auto kind = static_cast<std::size_t>(std::ranges::find(columns, "kind") - columns.begin());
  ASSERT_LT(kind, columns.size());
  std::string table = lines.front() + ",steps\n";
  int id = 0;
  for (const int steps : {3, 3, 0, 0, 0, 0})
    for (std::size_t line = 1; line < lines.size() && !lines[line].empty(); ++line) {
      std::vector<std::string> fields;
      boost::split(fields, lines[line], boost::is_any_of(","));
      fields[0] = "V" + std::to_string(++id);
      fields[kind] = "steps";
      table += boost::join(fields, ",") + "," + std::to_string(steps) + "\n";
    }
  (void)write("steps.csv", table);
  const Outcome outcome = run("watch p/cell.yaml steps.csv --assume as-is --json -");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["alarm"]["test"], "counts");
}

TEST_F(WatchCommand, AnUncalibratedBaseIsRefused) {
  EXPECT_EQ(run("watch " + shipped("mockup.yaml") + " p/touches.csv").exit_code, 2);
}

}  // namespace
}  // namespace tubeplan::app
