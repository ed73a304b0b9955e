// A saved session is restored completely or not at all, and no session is discarded unless the user requests it.
#include "app/storage/atomic_file.hpp"
#include "app/workbench/project.hpp"
#include "tests/app/workbench/running_server.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class SessionKeeping : public WorkbenchTest {
 protected:
  [[nodiscard]] std::filesystem::path state() const { return folder / "state"; }

  void serveKept(const std::string& cell, const std::vector<std::string>& measurements = {}, bool fresh = false) {
    server.reset();
    WorkbenchOptions options;
    options.cell = (opened() / cell).string();
    options.measurement_files = measurements;
    options.folder = opened().string();
    options.state = state().string();
    options.fresh = fresh;
    server = std::make_unique<RunningServer>(options);
    client = server->client();
  }

  void makeWork() {
    simulate();
    done("/api/compare");
    done("/api/add", {{"causes", {"joint-offset@theta3"}}});
    EXPECT_EQ(post("/api/measurements/set-aside", {{"ids", {"4"}}}).status, 200);
    done("/api/compare");
  }
};

/// Returns the state without the keys that change with every start: jobs, folder, moment and the words for the steps,
/// of which only the models are kept.
json lasting(json state) {
  for (const char* key : {"jobs", "folder", "moment", "undo_words", "redo_words"}) state.erase(key);
  return state;
}

TEST_F(SessionKeeping, theNextProgramGoesOnWhereTheLastOneWas) {
  serveKept("bench.yaml");
  makeWork();
  const json state = lasting(get("/api/state").body), result = get("/api/results/compare").body;
  const std::string cell = get("/api/export/cell.yaml").text, measurements = get("/api/export/measurements.csv").text;
  serveKept("bench.yaml");
  EXPECT_EQ(lasting(get("/api/state").body), state);
  EXPECT_EQ(get("/api/results/compare").body, result);
  EXPECT_EQ(get("/api/export/cell.yaml").text, cell);
  EXPECT_EQ(get("/api/export/measurements.csv").text, measurements);
  EXPECT_EQ(post("/api/undo").body["model"], 0);  // the undo stack is restored too
  done("/api/compare");
}

TEST_F(SessionKeeping, whatIsNoSessionIsNotListedAmongThem) {
  std::filesystem::create_directories(state());
  for (const char* head : {R"({"format":1})", R"({"format":null})", "[]", "", "\xff", R"({"question":7})"})
    write("state/other-" + std::to_string(std::string(head).size()) + ".tubeplan", head);
  write("state/long.tubeplan", "{\"format\":\"" + std::string(1u << 20, 'x'));
  serveKept("bench.yaml");
  const Reply files = get("/api/files");
  EXPECT_EQ(files.status, 200) << files.text;
  EXPECT_EQ(files.body["recent"].size(), 0u);
}

TEST_F(SessionKeeping, thePlanIsMadeAgainTheSame) {
  serveKept("mockup.yaml");
  done("/api/plan", {{"tubes", "R2C3,R4C6,R6C9"}, {"dwell", 3}, {"start", "park"}});
  json plan = get("/api/results/plan").body;
  const json path = get("/api/plan/path").body;
  serveKept("mockup.yaml");
  const json job = get("/api/state").body["jobs"].back();
  EXPECT_EQ(job["kind"], "plan");
  EXPECT_EQ(ended(job["id"])["status"], "done");
  EXPECT_EQ(get("/api/plan/path").body, path);
  json again = get("/api/results/plan").body;
  for (const char* of_the_run : {"revision", "timing", "seconds"}) {
    plan.erase(of_the_run);
    again.erase(of_the_run);
  }
  EXPECT_EQ(again, plan);
}

TEST_F(SessionKeeping, touchesComeBack) {
  const auto touch = [&](int hole) { return post("/api/touch", {{"hole", hole}}); };
  serveKept("mockup.yaml");
  for (const int hole : {10, 40, 80}) ASSERT_EQ(touch(hole).status, 200);
  const json touches = get("/api/touches").body;
  done("/api/calibrate");
  const json base = get("/api/results/calibrate").body["base"];
  serveKept("mockup.yaml");
  const json back = get("/api/touches").body;
  ASSERT_EQ(back["touches"].size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(back["touches"][k]["name"], touches["touches"][k]["name"]);
    EXPECT_EQ(back["touches"][k]["simulated"], true);
    for (std::size_t j = 0; j < 4; ++j)  // stored with twelve digits, as in any file of measurements
      EXPECT_NEAR(back["touches"][k]["joints"][j], touches["touches"][k]["joints"][j], 1e-9);
  }
  EXPECT_EQ(get("/api/results/calibrate").body["base"], base);
}

TEST_F(SessionKeeping, anotherCellOrOtherMeasurementsAreBegunAnewAndTheSessionStays) {
  serveKept("bench.yaml");
  makeWork();
  serveKept("bench.yaml", {}, true);
  EXPECT_EQ(get("/api/state").body["models"].size(), 1u);
  json recent = get("/api/files").body["recent"];
  ASSERT_EQ(recent.size(), 1u);
  EXPECT_EQ(recent[0]["models"], "2");
  EXPECT_EQ(post("/api/project/open", {{"recent", recent[0]["file"]}}).body["models"].size(), 2u);

  const auto bench = contentOf(opened() / "bench.yaml");
  write("opened/bench.yaml", bench + "\n# changed\n");
  serveKept("bench.yaml");
  EXPECT_EQ(get("/api/state").body["models"].size(), 1u);
  EXPECT_EQ(get("/api/files").body["recent"].size(), 2u);
}

TEST_F(SessionKeeping, workIsNotDroppedUnasked) {
  serveKept("bench.yaml");
  EXPECT_EQ(get("/api/state").body["project"]["unsaved"], false);
  makeWork();
  EXPECT_EQ(get("/api/state").body["project"]["unsaved"], true);
  EXPECT_EQ(post("/api/cell/open", {{"file", "mockup.yaml"}}).status, 409);
  EXPECT_EQ(get("/api/state").body["models"].size(), 2u);
  EXPECT_EQ(post("/api/project/save", {{"file", "mine"}}).body["project"]["unsaved"], false);
  EXPECT_EQ(post("/api/project/save", {{"file", "mine"}}).status, 409);
  EXPECT_EQ(post("/api/project/save", {{"file", "mine"}, {"overwrite", true}}).status, 200);
  EXPECT_EQ(post("/api/project/save", {{"file", "../mine"}}).status, 422);
  EXPECT_EQ(post("/api/cell/open", {{"file", "mockup.yaml"}}).body["models"].size(), 1u);
  const json state = post("/api/project/open", {{"file", "mine.tubeplan"}}).body;
  EXPECT_EQ(state["models"].size(), 2u);
  EXPECT_EQ(state["measurements"]["set_aside"], 1);
  EXPECT_EQ(state["project"]["unsaved"], false);
  EXPECT_EQ(get("/api/files").body["projects"], json({"mine.tubeplan"}));
}

TEST_F(SessionKeeping, aProjectIsServedByItself) {
  serveKept("bench.yaml");
  makeWork();
  ASSERT_EQ(post("/api/project/save", {{"file", "mine"}}).status, 200);
  std::filesystem::remove(opened() / "bench.yaml");  // the project contains the cell
  std::filesystem::remove(opened() / "cobra-arm.yaml");
  serveKept("mine.tubeplan");
  EXPECT_EQ(get("/api/state").body["models"].size(), 2u);
  done("/api/compare");
}

TEST_F(SessionKeeping, aDamagedSessionIsPutAside) {
  serveKept("bench.yaml");
  makeWork();
  const auto file = server->workbench().keeper().file();
  server.reset();
  std::string text = contentOf(file);
  text[text.size() / 2] ^= 1;
  writeFileAtomically(file, text, "test");
  serveKept("bench.yaml");
  EXPECT_EQ(get("/api/state").body["models"].size(), 1u);
  EXPECT_EQ(contentOf(std::filesystem::path(file).replace_filename(file.stem().string() + "-unreadable-1.tubeplan")),
            text);
}

TEST_F(SessionKeeping, twoProgramsOnOneCellKeepASessionEach) {
  serveKept("bench.yaml");
  simulate(12);
  WorkbenchOptions options;
  options.cell = (opened() / "bench.yaml").string();
  options.state = state().string();
  RunningServer other(options);
  EXPECT_NE(other.workbench().keeper().file(), server->workbench().keeper().file());
  EXPECT_EQ(other.workbench().session().measurements, nullptr);
}

TEST_F(SessionKeeping, withoutAStateFolderNothingIsKept) {
  serve("bench.yaml");
  EXPECT_EQ(get("/api/state").body["project"]["kept"], false);
  EXPECT_EQ(get("/api/files").body["recent"].size(), 0u);
}

}  // namespace
}  // namespace tubeplan::app
