// `tubeplan job` from outside: a tube from the plan to its mark, refusals, and exit codes.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class JobCommand : public ProgramTest {
 protected:
  JobCommand() {
    (void)write("job.yaml",
                "job: test\nunits: {length: in, angle: deg, force: lbf}\nsteam_generators:\n  - {name: A, hot: '" +
                    (shippedCells() / "mockup.yaml").string() +
                    "', cold: mirrored}\ntools: [{name: bobbin}]\npackages:\n"
                    "  - {name: rows, tubes: R9-11C18-22, tool: bobbin, confirm: position}\n");
    EXPECT_EQ(run("job create job.yaml --out a.job").exit_code, 0);
  }

  [[nodiscard]] json answer(const std::string& arguments, int code = 0) const {
    const Outcome outcome = run(arguments + " --json -");
    EXPECT_EQ(outcome.exit_code, code) << outcome.err;
    return json::parse(outcome.out.empty() ? "null" : outcome.out);
  }
};

TEST_F(JobCommand, ATubeFromThePlanToItsMark) {
  const json next = answer("job next a.job --leg hot");
  const std::string tube = next["tube"];
  EXPECT_EQ(tube, "A/hot/R9C18");
  EXPECT_EQ(next["left"], 15);
  EXPECT_EQ(run("job mark a.job " + tube + " --as done --by Tom").exit_code, 2);  // not confirmed
  const std::string position = std::to_string(next["x"].get<double>()) + "," + std::to_string(next["y"].get<double>());
  const std::string mirrored = std::to_string(-next["x"].get<double>()) + "," + std::to_string(next["y"].get<double>());
  EXPECT_EQ(answer("job confirm a.job " + tube + " --by Maria --position=" + mirrored, 1)["same"], false);
  EXPECT_EQ(answer("job status a.job")["wrong_tubes"].size(), 1u);
  EXPECT_EQ(answer("job confirm a.job " + tube + " --by Maria --position=" + position)["same"], true);
  const json marked = answer("job mark a.job " + tube + " --as done --by Tom");
  const json status = answer("job status a.job");
  EXPECT_EQ(status["total"]["done"], 1);
  EXPECT_EQ(status["total"]["planned"], 30);
  EXPECT_EQ(status["total"]["unresolved"], 29);
  EXPECT_EQ(answer("job log a.job")["events"].size(), 3u);
  EXPECT_EQ(run("job undo a.job --event " + marked["event"].dump() + " --by Tom --reason 'extent too short'").exit_code,
            0);
  EXPECT_EQ(answer("job status a.job")["total"]["done"], 0);
}

TEST_F(JobCommand, WhatItCannotTakeIsRefusedAndRecordsNothing) {
  const char* refused[] = {"job mark a.job R9C18 --as skipped --by Tom",         // no leg
                           "job mark a.job A/hot/R9C18 --as jumped --by Tom",    // no such mark
                           "job mark a.job A/hot/R9C18 --as skipped",            // nobody
                           "job mark a.job A/hot/R1C57 --as skipped --by Tom",   // in no package
                           "job mark a.job A/hot/R9C18 --as excluded --by Tom",  // no reason
                           "job mark a.job A/hot/R9C18 --as skipped --by Tom --csv x.csv",
                           "job next a.job --sg C",
                           "job confirm a.job A/hot/R9C18 --by Maria",
                           "job undo a.job --event 7 --by Tom --reason none",
                           "job export a.job --package rows --csv x.csv",
                           "job status nothere.job",
                           "job status job.yaml",
                           "job create job.yaml --out a.job",
                           "job report a.job",
                           "job report a.job --out x.html --shift day",  // the job names no shifts
                           "job report a.job --out x.html --date tomorrow",
                           "job report a.job --out a.job",
                           "job report a.job --out y.html --pdf a.job",
                           "job log a.job --csv a.job",
                           "job status a.job --json a.job",
                           "job status a.job --shift day",
                           "job fly a.job"};
  for (const char* words : refused) {
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exit_code, 2) << words;
    EXPECT_FALSE(outcome.err.empty()) << words;
  }
  EXPECT_TRUE(answer("job log a.job")["events"].empty());
  EXPECT_FALSE(std::filesystem::exists(folder / "x.html"));
}

TEST_F(JobCommand, TheHandOverIsWrittenBeforeAndAfterThePlan) {
  const json before = answer("job report a.job --out before.html");
  EXPECT_TRUE(before["plan"].is_null());
  EXPECT_TRUE(before["shift"].is_null());
  EXPECT_EQ(run("job mark a.job A/hot/R9C18 --as skipped --by Tom --at 2025-04-02T06:15:30Z").exit_code, 0);
  const json plan = answer("job plan a.job --out plans");
  EXPECT_NE(contentOf(folder / "plans/schedule.html").find("\"lower_bound_s\""), std::string::npos);
  const json after = answer("job report a.job --out after.html");
  for (const char* key : {"legs", "times", "schedule", "end_s"}) EXPECT_EQ(after["plan"][key], plan[key]) << key;
  EXPECT_EQ(after["shift"]["words"], "2025-04-02");
  for (const json& leg : after["legs"]) EXPECT_GT(leg["time_left_s"], 0);
  const std::string page = contentOf(folder / "after.html");
  EXPECT_NE(page.find("\"page\":\"hand-over\""), std::string::npos);
}

/// Returns the options in a help text, and the arguments in capitals.
std::set<std::string> optionsIn(const std::string& help) {
  static const std::regex kOption(R"(\n  (?:-h,)?(--[a-z-]+|[A-Z]+) )");
  std::set<std::string> options;
  for (std::sregex_iterator match(help.begin(), help.end(), kOption), end; match != end; ++match)
    options.insert((*match)[1]);
  return options;
}

/// The actions of two commands, as the help of the command lists them.
TEST_F(JobCommand, TheHelpOfAnActionIsAboutThatActionAlone) {
  const std::set<std::string> kChecked{"--help", "--kinematics", "--leg", "--convention", "--format"};
  for (const std::string command : {"job", "arm"}) {
    const std::string all = run(command + " --help").out;
    std::set<std::string> of_all = optionsIn(all), of_any{"ACTION"}, texts;
    std::smatch names;
    ASSERT_TRUE(std::regex_search(all, names, std::regex(R"(ACTION TEXT:\{([^}]*)\})")));
    std::istringstream list(names[1].str());
    for (std::string action; std::getline(list, action, ',');) {
      SCOPED_TRACE(command + " " + action);
      const Outcome help = run(fmt::format("{} {} --help", command, action));
      EXPECT_EQ(help.exit_code, 0);
      EXPECT_EQ(run(fmt::format("help {} {}", command, action)).out, help.out);
      expectSays(help.out, fmt::format("Usage: tubeplan {} {} [OPTIONS] FILE", command, action));
      EXPECT_TRUE(texts.insert(help.out).second);
      const std::set<std::string> options = optionsIn(help.out);
      EXPECT_TRUE(std::ranges::includes(of_all, options));
      of_any.insert(options.begin(), options.end());
      for (const std::string& option : of_all) {
        // options whose values are checked first are refused for these
        const bool is_checked = kChecked.contains(option) || !option.starts_with("--");
        const std::string value = option == "--position" ? "1,2" : "1";
        const Outcome given = run(fmt::format("{} {} none {}={}", command, action, option, value));
        const bool is_refused = given.err.find("this is an option of") != std::string::npos;
        EXPECT_TRUE(is_checked || is_refused != options.contains(option)) << option << given.err;
      }
    }
    EXPECT_EQ(of_any, of_all);
  }
}

TEST_F(JobCommand, TheShippedJobBalances) {
  EXPECT_EQ(run("job create " + shipped("outage/job.yaml") + " --out spring.job").exit_code, 0);
  const json status = answer("job status spring.job");
  for (const auto& row : status["packages"])
    EXPECT_EQ(row["planned"], row["done"].get<int>() + row["excluded"].get<int>() + row["unresolved"].get<int>());
  EXPECT_EQ(status["packages"].size(), 7u);  // bobbin on two hot legs, periphery on four legs, retests on one
  EXPECT_EQ(status["packages"][0]["planned"], 4674);
  EXPECT_EQ(status["packages"][0]["excluded"], 140);
}

}  // namespace
}  // namespace tubeplan::app
