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

TEST_F(WatchCommand, AnUncalibratedBaseIsRefused) {
  EXPECT_EQ(run("watch " + shipped("mockup.yaml") + " p/touches.csv").exit_code, 2);
}

}  // namespace
}  // namespace tubeplan::app
