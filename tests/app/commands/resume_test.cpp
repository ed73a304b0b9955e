// A plan that was interrupted or killed can be resumed and then writes the same files; a plan that starts from an
// earlier one reuses those results that are still valid.
#include <fcntl.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <thread>

#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class Resume : public ProgramTest {
 protected:
  /// Starts the program and sends it the signal once progress.json exists; returns the status from waitpid().
  [[nodiscard]] int interrupted(const std::string& arguments, const std::string& out, int signal_number) const {
    const std::string command = "cd '" + folder.string() + "' && exec '" TUBEPLAN_PROGRAM "' " + arguments + " --out " +
                                out + " >stopped.txt 2>&1 </dev/null";
    const pid_t child = ::fork();
    if (child == 0) {
      ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      ::_exit(127);
    }
    int status = 0;
    while (!std::filesystem::exists(folder / out / "progress.json")) {
      if (::waitpid(child, &status, WNOHANG) == child) return status;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ::kill(child, signal_number);
    ::waitpid(child, &status, 0);
    return status;
  }

  void expectSameFiles(const std::string& one, const std::string& other) const {
    for (const char* file : {"plan.json", "path.csv", "cell.yaml", "report.html", "worklist.csv", "memory.json"})
      EXPECT_EQ(contentOf(folder / one / file), contentOf(folder / other / file)) << file;
  }

  [[nodiscard]] json planOf(const std::string& name) const {
    return json::parse(contentOf(folder / name / "plan.json"));
  }

  static std::string mockupPlan(const std::string& more) { return "plan " + shipped("mockup.yaml") + " " + more; }
};

TEST_F(Resume, AnInterruptedPlanGoesOnToTheSameBytes) {
  const std::string question = mockupPlan("--tubes spread:520 --seed 3");
  const int status = interrupted(question, "stopped", SIGINT);
  ASSERT_TRUE(WIFEXITED(status)) << "ended by a signal";
  ASSERT_EQ(WEXITSTATUS(status), 130) << contentOf(folder / "stopped.txt");
  const std::string said = contentOf(folder / "stopped.txt");
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  expectSays(said, "stopped; the reach of ");
  expectSays(said, "the same command continues from there");
  EXPECT_FALSE(std::filesystem::exists(folder / "stopped/plan.json"));

  // Resuming with other arguments is refused, and the progress file is kept.
  const std::string kept = contentOf(folder / "stopped/progress.json");
  const Outcome other = run(mockupPlan("--tubes spread:220 --seed 4 --resume --out stopped"));
  EXPECT_EQ(other.exit_code, 2);
  expectSays(other.err, "another seed (3, now 4)");
  const Outcome list = run(mockupPlan("--tubes spread:510 --seed 3 --load 5 --resume --out stopped"));
  EXPECT_EQ(list.exit_code, 2);
  expectSays(list.err, "another list of tubes (520 tubes");
  expectSays(list.err, "another load (0 N, now 22.");
  EXPECT_EQ(contentOf(folder / "stopped/progress.json"), kept);

  const Outcome resumed = run(question + " --resume --out stopped");
  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
  expectSays(resumed.err, "continuing from ");
  EXPECT_FALSE(std::filesystem::exists(folder / "stopped/progress.json"));
  ASSERT_EQ(run(question + " --out whole").exit_code, 0);
  expectSameFiles("stopped", "whole");
}

TEST_F(Resume, AKilledPlanGoesOnByItselfAndLeavesNoScraps) {
  const std::string question = mockupPlan("--tubes spread:500 --seed 5");
  const int status = interrupted(question, "killed", SIGKILL);
  ASSERT_TRUE(WIFSIGNALED(status));
  const Outcome resumed = run(question + " --out killed");
  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
  expectSays(resumed.err, "continuing from ");
  ASSERT_EQ(run(question + " --out whole").exit_code, 0);
  expectSameFiles("killed", "whole");
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "killed"))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"cell.yaml", "memory.json", "path.csv", "plan.json", "report.html",
                                             "worklist.csv"}));
}

TEST_F(Resume, RefusesWhatIsNotThereOrDamaged) {
  const std::string question = mockupPlan("--tubes R20C40,R22C44 --out made");
  const Outcome nothing = run(question + " --resume");
  EXPECT_EQ(nothing.exit_code, 2);
  expectSays(nothing.err, "no stopped plan (progress.json) in ");
  EXPECT_FALSE(std::filesystem::exists(folder / "made"));
  ASSERT_EQ(run(question).exit_code, 0);
  const std::string memory = contentOf(folder / "made/memory.json"), plan = contentOf(folder / "made/plan.json");
  // Resuming a finished plan writes the same plan again.
  const Outcome again = run(question + " --resume");
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(contentOf(folder / "made/plan.json"), plan);
  // A damaged progress file is refused: with one digit of a joint value altered, cut in half, or made of empty objects.
  std::string altered = memory;
  const std::size_t digit = altered.find("\"q\":[") + 9;
  altered[digit] = altered[digit] == '1' ? '2' : '1';
  for (const std::string& damaged : {altered, memory.substr(0, memory.size() / 2), std::string("{}\n{}\n")}) {
    (void)write("made/progress.json", damaged);
    const Outcome outcome = run(question);
    EXPECT_EQ(outcome.exit_code, 2);
    expectSays(outcome.err, "progress.json");
    expectSays(outcome.err, "remove that file");
  }
  // Without --resume, the progress file of another request is discarded with a message, and planning starts again.
  (void)write("made/progress.json", memory);
  const Outcome anew = run(question + " --seed 8");
  EXPECT_EQ(anew.exit_code, 0) << anew.err;
  expectSays(anew.err, "started again: ");
  EXPECT_EQ(planOf("made")["seed"], 8);
  EXPECT_EQ(contentOf(folder / "made/progress-1.json"), memory);
}

TEST_F(Resume, AFewTubesMoreAndLessKeepTheRestOfThePlan) {
  ASSERT_EQ(run(mockupPlan("--tubes spread:60 --out old")).exit_code, 0);
  const json old = planOf("old");
  std::string list = "row,column\n";
  for (std::size_t k = 0; k < old["tubes"].size(); ++k)
    if (k != 10 && k != 30) list += old["tubes"][k]["row"].dump() + "," + old["tubes"][k]["column"].dump() + "\n";
  (void)write("new.csv", list + "21,50\n12,33\n");
  const Outcome outcome = run(mockupPlan("--tubes new.csv --from old --out new"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::size_t tubes = old["tubes"].size();
  expectSays(outcome.out, "the reach of " + std::to_string(tubes - 2) + " of " + std::to_string(tubes) + " tubes");
  expectSays(outcome.out, "2 tubes added, 2 removed");
  std::smatch travels;
  ASSERT_TRUE(std::regex_search(outcome.out, travels, std::regex("(\\d+) of (\\d+) travels")));
  EXPECT_GE(std::stoi(travels[1]), std::stoi(travels[2]) - 16);
  const Outcome proof = run("verify " + shipped("mockup.yaml") + " new");
  EXPECT_EQ(proof.exit_code, 0) << proof.out;
  // Tubes that both plans visit have the same joint values to the last digit, except where the arm changes its branch.
  std::map<std::string, json> joints;
  for (const auto& tube : old["tubes"]) joints[tube["name"]] = tube["joints"];
  int same = 0, shared = 0;
  const json made = planOf("new");
  for (const auto& tube : made["tubes"])
    if (const auto found = joints.find(tube["name"]); found != joints.end()) {
      ++shared;
      same += found->second == tube["joints"];
    }
  EXPECT_EQ(shared, static_cast<int>(tubes) - 2);
  EXPECT_GE(same, shared - 10);
}

/// Returns a work list of the tubes of a plan from the visit `first` on.
std::string listFrom(const json& plan, std::size_t first) {
  std::string list = "row,column\n";
  for (std::size_t k = first; k < plan["tubes"].size(); ++k)
    list += plan["tubes"][k]["row"].dump() + "," + plan["tubes"][k]["column"].dump() + "\n";
  return list;
}

std::string readingsOf(const json& joints) {
  std::string text;
  for (const json& value : joints) text += (text.empty() ? "" : ",") + value.dump();
  return text;
}

TEST_F(Resume, WhatIsLeftIsPlannedFromWhereTheArmStands) {
  ASSERT_EQ(run(mockupPlan("--tubes spread:60 --out old")).exit_code, 0);
  const json old = planOf("old");
  (void)write("left.csv", listFrom(old, 20));
  const json& stands = old["tubes"][19];
  // The arm stands at the hole of the last tube visited: said by the tube's name, or by its readings.
  const std::string name = stands["name"], readings = readingsOf(stands["joints"]);
  for (const std::string& start : {name, readings}) {
    const Outcome outcome = run(mockupPlan("--tubes left.csv --from old --out new --start=" + start));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    expectSays(outcome.out, ", the order");
    const json made = planOf("new");
    std::set<std::string> visited, remaining;
    for (const auto& tube : made["tubes"]) visited.insert(tube["name"]);
    for (std::size_t k = 20; k < old["tubes"].size(); ++k) remaining.insert(old["tubes"][k]["name"]);
    EXPECT_EQ(visited, remaining);
    EXPECT_EQ(made["start"], stands["joints"]);
    EXPECT_EQ(made["start_at"]["row"], stands["row"]);
    EXPECT_EQ(made["start_at"]["column"], stands["column"]);
    const Outcome proof = run("verify " + shipped("mockup.yaml") + " new");
    EXPECT_EQ(proof.exit_code, 0) << proof.out;
  }
  // A retreat that is said to be from another tube is another plan's.
  std::string altered = contentOf(folder / "new/plan.json");
  const std::size_t at = altered.find("\"row\"", altered.find("\"start_at\""));
  (void)write("new/plan.json", altered.replace(at, 6, "\"row\": 1, \"was\":"));
  const Outcome proof = run("verify " + shipped("mockup.yaml") + " new");
  EXPECT_EQ(proof.exit_code, 1) << proof.out;
}

TEST_F(Resume, AStartThatDoesNotFitIsRefused) {
  ASSERT_EQ(run(mockupPlan("--tubes R20C40,R22C44,R24C40 --out old")).exit_code, 0);
  const auto startedAt = [&](const std::string& start, const std::string& more) {
    return run(mockupPlan("--tubes R24C40 --out new --start=" + start + more));
  };
  EXPECT_EQ(startedAt("R20C41", " --from old").exit_code, 2);   // no tube of that plan
  EXPECT_EQ(startedAt("R20C400", " --from old").exit_code, 2);  // no tube of the sheet
  EXPECT_EQ(startedAt("R20C40", "").exit_code, 2);              // no plan
  const Outcome load = startedAt("R20C40", " --from old --load 5");
  EXPECT_EQ(load.exit_code, 2);
  expectSays(load.err, "another load");
  EXPECT_EQ(startedAt("0,0,0,0,0,0", " --from old").exit_code, 2);  // another arm
  EXPECT_EQ(startedAt("0,500,0,0", " --from old").exit_code, 2);    // past a limit
  const Outcome collides = startedAt("-90,0,0,0", " --from old");
  EXPECT_EQ(collides.exit_code, 1);
  expectSays(collides.err, "the start posture: ");
  EXPECT_FALSE(std::filesystem::exists(folder / "new/plan.json"));
  (void)write("none.csv", "row,column\n");
  EXPECT_EQ(run(mockupPlan("--tubes none.csv --from old --out new")).exit_code, 2);
}

TEST_F(Resume, FromAPlanOfAnotherBaseOnlyTheOrderIsKept) {
  ASSERT_EQ(run(mockupPlan("--tubes spread:20 --out old")).exit_code, 0);
  for (const char* name : {"mockup.yaml", "cobra-arm.yaml"}) (void)write(name, contentOf(shippedCells() / name));
  (void)write("mockup.yaml",
              changed(contentOf(folder / "mockup.yaml"), "position: [0, 43.0, -44.0]", "position: [0.1, 43.0, -44.0]"));
  const Outcome outcome = run("plan mockup.yaml --tubes spread:20 --from old --out new");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expectSays(outcome.err, "of old only the order is reused (another base");
  expectSays(outcome.out, "the reach of 0 of ");
  const Outcome proof = run("verify mockup.yaml new");
  EXPECT_EQ(proof.exit_code, 0) << proof.out;
  EXPECT_EQ(run("plan mockup.yaml --tubes spread:20 --from nowhere --out new").exit_code, 2);
}

TEST_F(Resume, FromAPlanOfAToolThatMayLeanMoreNoPostureIsKept) {
  for (const char* name : {"puma.yaml", "puma-arm.yaml"}) (void)write(name, contentOf(shippedCells() / name));
  ASSERT_EQ(run("plan puma.yaml --tubes spread:12 --out old").exit_code, 0);
  (void)write("puma.yaml", changed(contentOf(folder / "puma.yaml"), "lengths: [0.0127,", "lengths: [0.08,"));
  const Outcome outcome = run("plan puma.yaml --tubes spread:12 --from old --out new");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expectSays(outcome.err, "of old only the order is reused (another tilt allowed");
  const json plan = planOf("new");
  for (const auto& tube : plan["tubes"]) EXPECT_LE(tube["tilt"].get<double>(), 1.62) << tube["name"];
}

TEST_F(Resume, WhatDiffersOfAnotherWayOfTravelIsSaidInWords) {
  ASSERT_EQ(run(mockupPlan("--tubes spread:4 --travel line --standoff 1.1 --out old")).exit_code, 0);
  const Outcome outcome = run(mockupPlan("--tubes spread:4 --from old --out new"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expectSays(outcome.err, "another compensation (via-point, standoff 0.02794 m, now via-point, standoff 0.0254 m)");
  expectSays(outcome.err, "another travel (line, now joints)");
}

}  // namespace
}  // namespace tubeplan::app
