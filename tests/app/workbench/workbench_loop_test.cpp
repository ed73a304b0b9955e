// Comparing, adding an effect, undoing and exporting in the workbench give the same results as the commands.
#include "app/formats/cell/cell_reader.hpp"
#include "tests/app/program.hpp"
#include "tests/app/workbench/running_server.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class WorkbenchLoop : public WorkbenchTest {
 protected:
  /// Returns a document written by a command, without the keys `version` and `inputs`.
  [[nodiscard]] json written(const std::string& name) const {
    json document = json::parse(contentOf(folder / name));
    document.erase("version");
    document.erase("inputs");
    return document;
  }
};

TEST_F(WorkbenchLoop, comparingGivesTheCommandsOwnDocument) {
  serve("bench.yaml");
  simulate();
  done("/api/compare");
  json document = get("/api/results/compare").body;
  EXPECT_EQ(document["model"], 0);
  const std::string arm = contentOf(opened() / "cobra-arm.yaml");
  for (const char* other : {"cobra-arm.yaml", "cobra.yaml"})  // an arm file; a cell whose arm file would overwrite it
    EXPECT_EQ(post("/api/cell/save", {{"file", other}, {"overwrite", true}}).status, 422) << other;
  EXPECT_EQ(contentOf(opened() / "cobra-arm.yaml"), arm);
  write("readings.csv", get("/api/export/measurements.csv").text);
  const std::string command = "'" TUBEPLAN_PROGRAM "' compare '" + (opened() / "bench.yaml").string() + "' '" +
                              (folder / "readings.csv").string() + "' --json '" + (folder / "c.json").string() +
                              "' >/dev/null";
  (void)std::system(command.c_str());
  document.erase("model");
  document.erase("revision");
  EXPECT_EQ(document, written("c.json"));
  EXPECT_NE(get("/api/export/compare.html").text.find("<html"), std::string::npos);
}

TEST_F(WorkbenchLoop, addingFitsAndClimbsAndCanBeUndone) {
  serve("bench.yaml");
  simulate();
  done("/api/identify");
  done("/api/add", {{"causes", {"joint-offset@theta3"}}});
  json state = get("/api/state").body;
  ASSERT_EQ(state["models"].size(), 3u);
  EXPECT_EQ(state["models"][2]["origin"], "effect");
  EXPECT_EQ(state["models"][2]["effects"][0]["effect"], "joint-offset");
  const double offset = state["models"][2]["effects"][0]["parameters"]["offset"]["value"];
  EXPECT_NEAR(offset, 0.3, 0.1);
  const json ladder = get("/api/results/ladder").body["models"];
  ASSERT_EQ(ladder.size(), 4u);  // models: rigid, as given, fitted, with the offset
  EXPECT_LT(ladder[3]["rms"]["heldout"], ladder[2]["rms"]["heldout"]);
  EXPECT_EQ(get("/api/results/identify").body["model"], 2);

  EXPECT_EQ(post("/api/undo").body["model"], 1);
  EXPECT_EQ(get("/api/results/identify").body["model"], 1);
  EXPECT_EQ(post("/api/undo").body["model"], 0);
  EXPECT_EQ(post("/api/undo").body["measurements"], nullptr) << "the simulated readings are a step too";
  EXPECT_EQ(post("/api/undo").status, 409);
  EXPECT_EQ(post("/api/redo").body["measurements"]["readings"], 30);
  EXPECT_EQ(post("/api/redo").body["model"], 1);
  done("/api/add", {{"formula", "theta3 += c*sin(2*theta1)"}});
  state = get("/api/state").body;
  EXPECT_EQ(state["models"].size(), 3u);  // the step that could be redone is discarded
  EXPECT_EQ(state["models"][2]["origin"], "formula");
  EXPECT_EQ(state["models"][2]["effects"][0]["formula"], "theta3 += c*sin(2*theta1)");
  EXPECT_EQ(state["can_redo"], false);
}

TEST_F(WorkbenchLoop, anyStepIsGoneBackToAndEffectsAndFreeNumbersAreSwitchedOff) {
  serve("bench.yaml");
  simulate();
  done("/api/add", {{"causes", {"joint-offset@theta3"}}});
  const json with = get("/api/results/ladder").body["models"].back();
  EXPECT_EQ(post("/api/models/go", {{"model", 7}}).status, 404);
  EXPECT_EQ(post("/api/remove", {{"causes", {"joint-offset@theta2"}}}).status, 422);
  EXPECT_EQ(post("/api/remove", {{"causes", {"free@forearm.dh.a"}}}).status, 422);

  done("/api/remove", {{"causes", {"joint-offset@theta3"}}});
  json state = get("/api/state").body;
  ASSERT_EQ(state["models"].size(), 3u);
  EXPECT_TRUE(state["models"][2]["effects"].empty());
  EXPECT_EQ(state["models"][2]["free"], state["models"][0]["free"]) << "its numbers go with it";
  const json ladder = get("/api/results/ladder").body["models"];
  ASSERT_EQ(ladder.size(), 4u);  // models: rigid, as given, with the offset, without the offset
  EXPECT_GT(ladder[3]["rms"]["heldout"], 2 * ladder[2]["rms"]["heldout"].get<double>());
  EXPECT_NEAR(ladder[3]["rms"]["fitted"], ladder[1]["rms"]["fitted"], 1e-6);

  const std::string held = state["models"][2]["free"][0];
  done("/api/remove", {{"causes", {"free@" + held}}});
  const json free = get("/api/state").body["models"][3]["free"];
  EXPECT_EQ(free.size() + 1, state["models"][2]["free"].size());
  EXPECT_EQ(std::find(free.begin(), free.end(), held), free.end());

  state = post("/api/models/go", {{"model", 1}}).body;
  EXPECT_EQ(state["model"], 1);
  EXPECT_EQ(state["models"].size(), 4u);
  EXPECT_EQ(get("/api/results/ladder").body["models"].back(), with);
  EXPECT_EQ(post("/api/models/go", {{"model", 3}}).body["can_redo"], false);
}

TEST_F(WorkbenchLoop, measurementsSetAsideAreSeenByNoFitUntilTheyAreTakenBack) {
  serve("bench.yaml");
  EXPECT_EQ(post("/api/measurements/set-aside", {{"ids", {"1"}}}).status, 404);
  simulate();
  done("/api/compare");
  const json all = get("/api/results/compare").body;
  json state = post("/api/measurements/set-aside", {{"ids", {"1", "3"}}}).body;
  EXPECT_EQ(state["measurements"]["readings"], 30);
  EXPECT_EQ(state["measurements"]["set_aside"], 2);
  EXPECT_TRUE(state["results"]["compare"].is_null());
  done("/api/compare");
  const json fewer = get("/api/results/compare").body;
  ASSERT_EQ(fewer["readings"].size(), 28u);
  EXPECT_EQ(fewer["readings"][0]["id"], "2");
  const json rows = get("/api/measurements").body["rows"];
  EXPECT_EQ(rows[0]["set_aside"], true);
  EXPECT_EQ(rows[1]["set_aside"], false);
  state = post("/api/measurements/set-aside", {{"ids", {"1", "3"}}, {"aside", false}}).body;
  EXPECT_EQ(state["measurements"]["set_aside"], 0);
  done("/api/compare");
  EXPECT_EQ(get("/api/results/compare").body["rms"], all["rms"]);

  EXPECT_EQ(post("/api/measurements/set-aside", {{"ids", {"no-such-reading"}}}).status, 422);
  std::vector<std::string> ids;
  for (const auto& row : rows) ids.push_back(row["id"]);
  EXPECT_EQ(post("/api/measurements/set-aside", {{"ids", ids}}).status, 422);
}

TEST_F(WorkbenchLoop, marksAreUndoneAndRedoneWithTheResultsThatBelongToThem) {
  serve("bench.yaml");
  simulate();
  done("/api/compare");
  const json all = get("/api/results/compare").body["rms"];
  EXPECT_EQ(post("/api/measurements/set-aside", {{"ids", {"1", "3"}}}).body["undo_words"], "marks of readings");
  done("/api/compare");
  const json fewer = get("/api/results/compare").body["rms"];
  json state = post("/api/undo").body;
  EXPECT_EQ(state["measurements"]["set_aside"], 0);
  EXPECT_EQ(get("/api/results/compare").body["rms"], all) << "nothing is computed again";
  const int change = state["measurements"]["change"];
  EXPECT_EQ(state["redo_words"], "marks of readings");
  state = post("/api/redo").body;
  EXPECT_EQ(state["measurements"]["set_aside"], 2);
  EXPECT_GT(state["measurements"]["change"], change);
  EXPECT_EQ(get("/api/results/compare").body["rms"], fewer);
}

TEST_F(WorkbenchLoop, aTouchIsUndoneWithoutTheModelBeforeIt) {
  serve("mockup.yaml");
  for (const int hole : {10, 40, 80}) ASSERT_EQ(post("/api/touch", {{"hole", hole}}).status, 200);
  done("/api/calibrate");
  ASSERT_EQ(post("/api/touch", {{"hole", 60}}).body["undo_words"], "touches");
  json state = post("/api/undo").body;
  EXPECT_EQ(state["touches"], 3);
  EXPECT_EQ(state["model"], 1);
  state = post("/api/undo").body;
  EXPECT_EQ(state["model"], 0);
  EXPECT_EQ(state["touches"], 3);
  EXPECT_EQ(post("/api/undo").body["touches"], 2);
  ASSERT_EQ(post("/api/touch", {{"hole", 20}}).status, 200);
  EXPECT_EQ(post("/api/redo").body["model"], 1) << "the model above the current one stays on the stack";
}

TEST_F(WorkbenchLoop, aModelOfOneEffectAtManyPlacesHasAShortLabelAndCanBeRenamed) {
  serve("bench.yaml");
  simulate();
  done("/api/add", {{"causes", {"joint-offset@theta2", "joint-offset@theta3", "joint-offset@theta4"}}});
  EXPECT_EQ(get("/api/state").body["models"][1]["label"], "+ joint-offset at 3 places");
  EXPECT_EQ(post("/api/models/rename", {{"model", 1}, {"label", "zeros"}}).body["models"][1]["label"], "zeros");
  EXPECT_EQ(post("/api/models/rename", {{"model", 1}, {"label", " "}}).status, 422);
  EXPECT_EQ(post("/api/models/rename", {{"model", 9}, {"label", "x"}}).status, 404);
  EXPECT_EQ(post("/api/undo").body["model"], 0);
  EXPECT_EQ(post("/api/redo").body["models"][1]["label"], "zeros");
}

TEST_F(WorkbenchLoop, aTouchThatIsSetAsidePlacesNoBase) {
  serve("mockup.yaml");
  done("/api/simulate", {{"design", "bowl"}, {"readings", 15}, {"loads", {0}}, {"seed", 3}});
  done("/api/calibrate");
  EXPECT_EQ(get("/api/results/calibrate").body["residuals"].size(), 15u);
  EXPECT_EQ(post("/api/undo").body["model"], 0);
  EXPECT_EQ(post("/api/measurements/set-aside", {{"ids", {"1"}}}).status, 200);
  done("/api/calibrate");
  const json residuals = get("/api/results/calibrate").body["residuals"];
  ASSERT_EQ(residuals.size(), 14u);
  for (const auto& touch : residuals) EXPECT_NE(touch["id"], "1");
}

TEST_F(WorkbenchLoop, anEarlierModelsComparisonIsStillThere) {
  serve("bench.yaml");
  simulate();
  done("/api/compare");
  done("/api/add", {{"causes", {"joint-offset@theta3"}}});
  done("/api/compare");
  EXPECT_EQ(get("/api/state").body["results"]["compare"]["models"], json({0, 1}));
  const json before = get("/api/results/compare?model=0").body, after = get("/api/results/compare?model=1").body;
  EXPECT_EQ(before["model"], 0);
  EXPECT_EQ(after["model"], 1);
  EXPECT_GT(before["rms"]["after"], after["rms"]["after"]);
  EXPECT_EQ(get("/api/results/compare?model=7").status, 404);
  EXPECT_EQ(get("/api/results/compare?model=one").status, 404);
}

TEST_F(WorkbenchLoop, leverageIsTheTipsMotionByAJoint) {
  serve("bench.yaml");
  simulate(3);
  const json document = get("/api/leverage?at=theta3,forearm.z").body;
  const json rows = get("/api/measurements").body["rows"];
  for (const auto& row : rows) {
    json joints = row["joints"];
    const auto tip = [&] {
      return post("/api/pose", {{"joints", joints}, {"load", row["load"]}}).body["tip"]["flexible"];
    };
    const json at = tip();
    joints[2] = joints[2].get<double>() + 0.01;
    const json moved = tip();
    const json lever = document["readings"][row["id"].get<std::string>()];
    ASSERT_EQ(lever.size(), 6u);
    for (std::size_t k = 0; k < 3; ++k)  // the tolerance allows for the change of bending under load
      EXPECT_NEAR((moved[k].get<double>() - at[k].get<double>()) / 0.01, lever[k].get<double>(), 0.02) << row["id"];
  }
  EXPECT_EQ(get("/api/leverage?at=theta9").status, 422);
}

// Levers and moments refer to the world frame, so an unknown base is fitted to the measurements; they then nearly equal
// those on the known base.
TEST_F(WorkbenchLoop, leverageAndMomentsOfABaseThatIsNotKnownAreTheMeasurements) {
  serve("bench.yaml");
  simulate();
  const std::string csv = get("/api/export/measurements.csv").text;
  const json levers = get("/api/leverage?at=theta1").body, moments = get("/api/moments").body;
  const std::string known = contentOf(opened() / "bench.yaml");
  write("opened/guessed.yaml", changed(changed(known, "position: [0, 0, 0]", "position: [9, -4, 2]"),
                                       "rpy: [0, 0, 0], known: true", "rpy: [20, 10, 30], known: false"));
  ASSERT_EQ(post("/api/cell/open", {{"file", "guessed.yaml"}, {"discard", true}}).status, 200);
  ASSERT_EQ(replyOf(client->Post("/api/measurements?name=again.csv", csv, "text/csv")).status, 200);
  const json levers_found = get("/api/leverage?at=theta1").body, moments_found = get("/api/moments").body;
  for (const auto& part : levers_found["base"]) EXPECT_NEAR(part.get<double>(), 0, 0.5);
  // The compliance of the model differs from the truth, and the fitted base absorbs part of the difference, so the
  // values agree only within 3 %.
  const auto expectNear = [](const json& one, const json& other) {
    double largest = 0, largest_difference = 0;
    for (const auto& [id, numbers] : one["readings"].items())
      for (std::size_t k = 0; k < numbers.size(); ++k) {
        const double number = numbers[k];
        largest = std::max(largest, std::abs(number));
        largest_difference = std::max(largest_difference, std::abs(number - other["readings"][id][k].get<double>()));
      }
    EXPECT_LT(largest_difference, 0.03 * largest);
  };
  expectNear(levers, levers_found);
  expectNear(moments, moments_found);
}

TEST_F(WorkbenchLoop, effectsThatCannotBeAreRefusedAtOnce) {
  serve("bench.yaml");
  simulate(12);
  const auto status = [&](const json& body) { return post("/api/add", body).status; };
  EXPECT_EQ(status(json::object()), 422);
  EXPECT_EQ(status({{"causes", {"gremlin@theta3"}}}), 422);
  EXPECT_EQ(status({{"causes", {"backlash@theta9"}}}), 422);
  EXPECT_EQ(status({{"causes", "backlash"}}), 422);
  EXPECT_EQ(status({{"formula", "theta3 += ((("}}), 422);
  EXPECT_EQ(status({{"formula", "theta3 += system(\"ls\")"}}), 422);
  EXPECT_EQ(post("/api/simulate", {{"design", "../bench.yaml"}}).status, 422);
  EXPECT_EQ(post("/api/simulate", {{"hide", {"backlash@nowhere"}}}).status, 422);
  EXPECT_EQ(post("/api/simulate", {{"readings", 1e9}}).status, 422);
  EXPECT_EQ(post("/api/field", {{"of", "gold"}}).status, 422);
}

TEST_F(WorkbenchLoop, anExportedModelIsTheModel) {
  serve("bench.yaml");
  simulate();
  done("/api/identify");
  done("/api/compare");
  EXPECT_EQ(post("/api/cell/save", {{"file", "mine.yaml"}}).body["written"], json({"mine.yaml", "mine-arm.yaml"}));
  EXPECT_EQ(post("/api/cell/save", {{"file", "mine.yaml"}}).status, 409);
  EXPECT_EQ(post("/api/cell/save", {{"file", "mine.yaml"}, {"overwrite", true}}).status, 200);
  EXPECT_EQ(post("/api/cell/save", {{"file", "../mine.yaml"}}).status, 422);
  EXPECT_EQ(post("/api/cell/save", {{"file", "mine.txt"}}).status, 422);
  write("readings.csv", get("/api/export/measurements.csv").text);
  const std::string command = "'" TUBEPLAN_PROGRAM "' compare '" + (opened() / "mine.yaml").string() + "' '" +
                              (folder / "readings.csv").string() + "' --json '" + (folder / "c.json").string() +
                              "' >/dev/null";
  (void)std::system(command.c_str());
  json document = get("/api/results/compare").body;
  document.erase("model");
  document.erase("revision");
  EXPECT_EQ(document, written("c.json"));
  const auto areTaken = [&] {
    write("cell.yaml", get("/api/export/cell.yaml").text);
    write("cell-arm.yaml", get("/api/export/cell-arm.yaml").text);
    return readCell((folder / "cell.yaml").string()).arm.jointCount() == 4;
  };
  EXPECT_TRUE(areTaken());
  post("/api/undo");
  EXPECT_TRUE(areTaken()) << "the model as it was given";
  EXPECT_EQ(get("/api/export/nothing.zip").status, 404);
  EXPECT_EQ(get("/api/export/plan.json").status, 404);
}

TEST_F(WorkbenchLoop, allBrowsersSeeTheSame) {
  serve("bench.yaml");
  std::mutex mutex;
  std::string heard;
  std::atomic<bool> stop = false;
  std::thread listener([&] {
    auto own = server->client();
    (void)own->Get("/api/events", [&](const char* data, std::size_t length) {
      const std::lock_guard lock(mutex);
      heard.append(data, length);
      return !stop.load();
    });
  });
  simulate(12);
  done("/api/compare");
  const json state = get("/api/state").body;
  const std::string revision = "\"revision\":" + std::to_string(state["revision"].get<int>());
  bool is_reported = false;
  for (int k = 0; k < 400 && !is_reported; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const std::lock_guard lock(mutex);
    const std::size_t last = heard.rfind("event: state");
    is_reported = last != std::string::npos && heard.find(revision, last) != std::string::npos;
  }
  EXPECT_TRUE(is_reported) << revision;
  {
    const std::lock_guard lock(mutex);
    EXPECT_NE(heard.find("event: job"), std::string::npos);
    EXPECT_NE(heard.find("\"status\":\"done\""), std::string::npos);
  }
  EXPECT_EQ(replyOf(server->client()->Get("/api/state")).body, get("/api/state").body);
  stop = true;
  server->workbench().events().stateChanged();
  listener.join();
}

}  // namespace
}  // namespace tubeplan::app
