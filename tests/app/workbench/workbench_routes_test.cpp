// Over a real socket, every address of the workbench answers valid requests and refuses invalid ones.
#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <map>
#include <set>

#include "tests/app/program.hpp"
#include "tests/app/workbench/running_server.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class WorkbenchRoutes : public WorkbenchTest {
 protected:
  /// Waits until the job is past its waiting stage and its first stage.
  void untilAtWork(int id, const std::string& kind) {
    for (std::string stage = "waiting"; stage == "waiting" || stage == kind;) stage = stageOf(id);
  }

 private:
  std::string stageOf(int id) {
    const json state = get("/api/state").body;
    for (const auto& job : state["jobs"])
      if (job["id"] == id) return job["status"] == "running" ? job["stage"].get<std::string>() : "ended";
    return "";
  }
};

TEST_F(WorkbenchRoutes, theStateTellsWhatIsThere) {
  serve("mockup.yaml", "mockup-true.yaml");
  const json state = get("/api/state").body;
  EXPECT_EQ(state["cell"]["file"], "mockup.yaml");
  EXPECT_EQ(state["cell"]["has_sheet"], true);
  EXPECT_EQ(state["cell"]["has_truth"], true);
  EXPECT_EQ(state["cell"]["joints"].size(), 4u);
  EXPECT_EQ(state["cell"]["joints"][0]["name"], "theta1");
  EXPECT_EQ(state["models"].size(), 1u);
  EXPECT_EQ(state["measurements"], nullptr);
  EXPECT_EQ(state["can_undo"], false);
  EXPECT_EQ(get("/api/results/compare").status, 404);
  EXPECT_EQ(get("/api/measurements").status, 404);
  EXPECT_EQ(get("/api/plan/path").status, 404);
  EXPECT_EQ(post("/api/undo").status, 409);
  EXPECT_EQ(post("/api/redo").status, 409);
  EXPECT_EQ(post("/api/jobs/7/cancel").status, 404);
  EXPECT_EQ(post("/api/jobs/x/cancel").status, 404);
  EXPECT_EQ(post("/api/state").status, 405);
  for (const char* path : {"/api/compare", "/api/diagnose", "/api/identify", "/api/ladder", "/api/calibrate"})
    EXPECT_EQ(work(path)["status"], "failed") << path;
}

TEST_F(WorkbenchRoutes, tablesOfOtherPrograms) {
  serve("bench.yaml");
  const json tables = {{{"name", "log.csv"}, {"text", "Name;J1;J2;J3;J4\nP1;10;45;-35;12,5\nP2;20;45;-35;12\n"}},
                       {{"name", "points.txt"}, {"text", "P2 1 2 3\nP1 4 5 6\n"}}};
  const json found = post("/api/measurements/columns", {{"tables", tables}}).body;
  EXPECT_EQ(found["tables"][1]["columns"].size(), 4u);
  int joints = 0;
  for (const auto& target : found["targets"])
    if (target["is_required"] == true) {
      ++joints;
      EXPECT_EQ(target["found"]["table"], 0);
      EXPECT_EQ(target["found"]["unit"], "");
    }
  EXPECT_EQ(joints, 4);
  json columns = {"x_mm=points.txt:column 2", "y_mm=points.txt:column 3", "z_mm=points.txt:column 4"};
  EXPECT_EQ(post("/api/measurements/foreign", {{"tables", tables}, {"columns", columns}}).status, 422);
  for (int k = 1; k <= 4; ++k) columns.push_back(fmt::format("theta{}_deg=log.csv:J{}", k, k));
  EXPECT_EQ(post("/api/measurements/foreign", {{"tables", tables}, {"columns", columns}}).status, 422) << "no sigma";
  const auto taken = post("/api/measurements/foreign", {{"tables", tables}, {"columns", columns}, {"sigma", 0.01}});
  EXPECT_EQ(taken.status, 200) << taken.text;
  EXPECT_EQ(get("/api/state").body["measurements"]["readings"], 2);
  EXPECT_EQ(post("/api/measurements/columns", {{"tables", json::array()}}).status, 422);
  EXPECT_EQ(post("/api/measurements/columns", {{"tables", {3}}}).status, 422);
  EXPECT_EQ(get("/api/export/template.csv").status, 200);
}

TEST_F(WorkbenchRoutes, aSignatureIsDrawnAgainstWhatTheEffectFollows) {
  serve("bench.yaml");
  const json two = get("/api/signature?effect=hysteresis&at=theta4").body;
  EXPECT_EQ(two["variable"], "direction of approach of theta4");
  EXPECT_EQ(two["values"], json({-1, 1}));
  const json growth = get("/api/signature?effect=thermal-growth&at=arm").body;
  EXPECT_EQ(growth["variable"], "temperature");
  EXPECT_EQ(growth["shift"].size(), growth["values"].size());
  EXPECT_EQ(growth["shift_unit"], "in");
  EXPECT_EQ(get("/api/signature?effect=hysteresis&at=theta9").status, 422);
  EXPECT_EQ(get("/api/signature").status, 422);
}

TEST_F(WorkbenchRoutes, sheetAndScene) {
  serve("mockup.yaml");
  const json sheet = get("/api/sheet").body;
  const std::size_t holes = 8 * 12;
  for (const char* column : {"row", "column", "x", "y", "z", "u", "v", "state"})
    EXPECT_EQ(sheet["holes"][column].size(), holes) << column;
  EXPECT_EQ(sheet["viewing_side"], "below");
  EXPECT_EQ(sheet["holes"]["state_words"].size(), sheet["holes"]["states"].size());
  EXPECT_EQ(sheet["leg_words"], "hot leg");
  EXPECT_EQ(sheet["view_words"], "seen from below");
  EXPECT_NEAR(sheet["holes"]["x"][5].get<double>(), -sheet["holes"]["u"][5].get<double>(), 1e-12);
  EXPECT_NEAR(sheet["holes"]["x"][6].get<double>() - sheet["holes"]["x"][5].get<double>(), 1.0625, 1e-9);
  const json& manway = sheet["manway"];
  EXPECT_EQ(manway["center"], json({-33.1, 33.1, -42.2}));
  EXPECT_EQ(manway["diameter"], 16.0);
  EXPECT_NEAR(manway["u"].get<double>(), std::sqrt(0.5), 1e-9);  // seen from below, like the holes
  EXPECT_NEAR(manway["v"].get<double>(), std::sqrt(0.5), 1e-9);
  const json scene = get("/api/scene").body;
  ASSERT_EQ(scene["shapes"].size(), 5u);
  EXPECT_EQ(scene["shapes"][0]["kind"], "inside_of.sphere");
  EXPECT_EQ(scene["shapes"][3]["size"], json({10.0, 15.0, 3.0}));
  EXPECT_EQ(scene["arm"].size(), 6u);
  EXPECT_EQ(scene["arm"][2]["bodies"][0]["radius"], 4.0);
  serve("bench.yaml");
  EXPECT_EQ(get("/api/sheet").status, 404);
}

TEST_F(WorkbenchRoutes, thePoseIsThatOfTheCommand) {
  serve("bench.yaml");
  const json pose = post("/api/pose", {{"joints", {-36.688, 46.138, -35.856, -11.127}}, {"load", 30}}).body;
  const std::string command = "'" TUBEPLAN_PROGRAM "' pose '" + (opened() / "bench.yaml").string() +
                              "' --joints=-36.688,46.138,-35.856,-11.127 --load 30 --json '" +
                              (folder / "pose.json").string() + "' >/dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const json printed = json::parse(contentOf(folder / "pose.json"));
  for (const auto& [key, value] : printed.items())
    if (key != "version" && key != "inputs") {
      EXPECT_EQ(pose.value(key, json()), value) << key;
    }
  EXPECT_EQ(pose["tip"]["flexible"], pose["flexible"]["position"]);  // the bench's base frame is the world frame
  EXPECT_EQ(pose["frames"]["rigid"].size(), 6u);
  EXPECT_EQ(pose["clearance"], nullptr);
}

TEST_F(WorkbenchRoutes, theNearestPointsAreAsFarApartAsTheClearance) {
  serve("mockup.yaml");
  int seen = 0;
  for (const int hole : {2, 30, 44, 65, 90}) {
    const json found = post("/api/inverse", {{"hole", hole}}).body;
    for (const auto& branch : found["branches"]) {
      if (branch["status"] != "found") continue;
      const json pose = post("/api/pose", {{"joints", branch["joints"]}, {"hole", hole}}).body;
      const json& clearance = pose["clearance"];
      ASSERT_TRUE(clearance.is_object());
      EXPECT_EQ(clearance, branch["clearance"]);
      if (!clearance["to"].is_array() || clearance["distance"] < 0.01) continue;
      double squared = 0;
      for (int k = 0; k < 3; ++k)
        squared += std::pow(clearance["from"][k].get<double>() - clearance["to"][k].get<double>(), 2);
      EXPECT_NEAR(std::sqrt(squared), clearance["distance"].get<double>(), 0.02) << clearance.dump();
      ++seen;
    }
  }
  EXPECT_GT(seen, 2);
}

TEST_F(WorkbenchRoutes, inverseFindsPosturesThatCentreTheTip) {
  serve("mockup.yaml");
  const json found = post("/api/inverse", {{"hole", 40}}).body;
  ASSERT_EQ(found["status"], "found");
  const json pose = post("/api/pose", {{"joints", found["joints"]}, {"hole", 40}}).body;
  EXPECT_LT(pose["centring"]["distance"].get<double>(), 1e-4);
  // The joints cannot correct the tilt of the tool. The third step enters if the tilt over a length of 1.5 in uses up
  // no more than its clearance of 0.010 in.
  EXPECT_EQ(pose["centring"]["steps"], pose["centring"]["tilt"].get<double>() * M_PI / 180 * 1.5 <= 0.010 ? 3 : 2);
  EXPECT_EQ(post("/api/inverse", {{"hole", 96}}).status, 422);
  EXPECT_EQ(post("/api/inverse", {{"hole", -1}}).status, 422);
  EXPECT_EQ(post("/api/inverse", {{"hole", 1.5}}).status, 422);
  EXPECT_EQ(post("/api/inverse").status, 422);
}

TEST_F(WorkbenchRoutes, selectionsAndTheCatalogue) {
  serve("mockup.yaml");
  EXPECT_EQ(post("/api/select", {{"text", "R1C1,R1C3"}}).body["holes"], json({0, 2}));
  EXPECT_EQ(post("/api/select", {{"text", "all"}}).body["holes"].size(), 96u);
  EXPECT_EQ(post("/api/select", {{"text", "R99C1"}}).status, 422);
  EXPECT_EQ(post("/api/select", {{"text", "/etc/passwd.csv"}}).status, 422);
  const json catalogue = get("/api/catalogue").body["effects"];
  const auto is_backlash = [](const json& e) { return e["effect"] == "backlash" && e["at"] == "tool.z"; };
  EXPECT_EQ(std::count_if(catalogue.begin(), catalogue.end(), is_backlash), 1);
}

TEST_F(WorkbenchRoutes, measurementsAreLoadedOrRefusedWithTheReadersOwnWords) {
  serve("bench.yaml");
  simulate(12);
  const std::string csv = get("/api/export/measurements.csv").text;
  write("opened/readings.csv", csv);
  const auto upload = [&](const std::string& text) {
    return replyOf(client->Post("/api/measurements?name=mine.csv", text, "text/csv"));
  };
  EXPECT_EQ(upload(csv).body["measurements"]["name"], "mine.csv");
  EXPECT_EQ(get("/api/measurements").body["rows"].size(), 12u);
  EXPECT_EQ(post("/api/measurements/open", {{"file", "readings.csv"}}).body["measurements"]["name"], "readings.csv");
  const Reply bad = upload(changed(csv, "position", "positron"));
  EXPECT_EQ(bad.status, 422);
  EXPECT_TRUE(bad.body["error"]["where"].get<std::string>().starts_with("mine.csv:2"));
  EXPECT_EQ(upload("").status, 422);
  EXPECT_EQ(upload(std::string(1000, '\0')).status, 422);
  EXPECT_EQ(get("/api/state").body["measurements"]["name"], "readings.csv");  // a refused upload changes nothing
  EXPECT_EQ(post("/api/measurements/open", {{"file", "../readings.csv"}}).status, 422);
  EXPECT_EQ(post("/api/measurements/open", {{"file", "bench.yaml"}}).status, 422);
  EXPECT_EQ(get("/api/files").body["measurements"], json({"readings.csv"}));
  write("opened/flow.yaml", "{name: flow, arm: cobra-arm.yaml, base: {position: [0, 0, 0], rpy: [0, 0, 0]}}");
  write("opened/broken.yaml", "name: broken\narm: [\n");
  write("opened/notes.yaml", "words: the arm: of the law\n");
  const json cells = get("/api/files").body["cells"];
  for (const char* cell : {"bench.yaml", "mockup.yaml", "flow.yaml", "broken.yaml"})
    EXPECT_TRUE(std::find(cells.begin(), cells.end(), cell) != cells.end()) << cell << " in " << cells;
  for (const char* other : {"cobra-arm.yaml", "notes.yaml"})
    EXPECT_TRUE(std::find(cells.begin(), cells.end(), other) == cells.end()) << other << " in " << cells;
}

TEST_F(WorkbenchRoutes, whatACheckSuspectsIsTakenToBeSo) {
  serve("bench.yaml");
  simulate();
  std::string text = get("/api/export/measurements.csv").text;
  EXPECT_EQ(post("/api/measurements/assume", {{"assume", {"coordinates=mm"}}}).status, 409) << "simulated, not opened";
  const std::string header = text.substr(0, text.find('\n'));
  text.replace(0, header.size(), boost::replace_all_copy(header, "x_in,y_in,z_in", "x_mm,y_mm,z_mm"));
  const Reply wrong = replyOf(client->Post("/api/measurements?name=mm.csv", text, "text/csv"));
  ASSERT_EQ(wrong.status, 200) << wrong.text;
  const json check = wrong.body["measurements"]["checks"][0];
  EXPECT_EQ(check["severity"], "mistake");
  EXPECT_EQ(check["assume"], "coordinates=in");
  EXPECT_NE(check.dump().find("the unit of the coordinates is in, not mm as their columns state"), std::string::npos);
  EXPECT_EQ(post("/api/measurements/set-aside", {{"ids", {"3", "4"}}, {"aside", true}}).status, 200);
  EXPECT_EQ(post("/api/measurements/hold-out", {{"ids", {"5"}}, {"held_out", true}}).status, 200);
  EXPECT_EQ(post("/api/measurements/assume").status, 422);
  EXPECT_EQ(post("/api/measurements/assume", {{"assume", {"coordinates=parsec"}}}).status, 422);
  const json corrected = post("/api/measurements/assume", {{"assume", {check["assume"]}}}).body["measurements"];
  for (const auto& remaining_check : corrected["checks"])
    EXPECT_NE(remaining_check["severity"], "mistake") << remaining_check.dump();
  EXPECT_EQ(corrected["readings"], 30);
  EXPECT_EQ(corrected["set_aside"], 2) << "marks made by hand stay";
  EXPECT_EQ(corrected["held_out"], 1);
  done("/api/compare");
  EXPECT_LT(get("/api/results/compare").body["rms"]["after"], 0.5);

  EXPECT_EQ(get("/api/state").body["measurements"]["assumed"], json({"coordinates=in"}));

  // The last assumed unit applies; an empty list restores the original unit.
  const auto firstX = [&] { return get("/api/measurements").body["rows"][0]["position"][0].get<double>(); };
  const double in_inches = firstX();
  EXPECT_EQ(post("/api/measurements/assume", {{"assume", {"coordinates=m"}}}).status, 200);
  EXPECT_NEAR(firstX(), in_inches / 0.0254, 1e-6 * std::abs(in_inches / 0.0254));
  EXPECT_EQ(post("/api/measurements/assume", {{"assume", {"coordinates=in"}}}).status, 200);
  EXPECT_NEAR(firstX(), in_inches, 1e-9);
  const json back = post("/api/measurements/assume", {{"assume", json::array()}}).body["measurements"];
  EXPECT_EQ(back["assumed"], json::array());
  EXPECT_NEAR(firstX(), in_inches / 25.4, 1e-9);
  EXPECT_EQ(back["set_aside"], 2);
  EXPECT_EQ(post("/api/measurements/assume", {{"assume", {"coordinates=in"}}}).status, 200);

  const json open = post("/api/measurements/assume", {{"assume", {"base=unknown"}}}).body;
  EXPECT_EQ(open["models"].back()["label"], "base not known");
  EXPECT_EQ(get("/api/export/cell.yaml").text.find("known: true"), std::string::npos);
}

TEST_F(WorkbenchRoutes, momentsAreThoseThatFormulasName) {
  serve("bench.yaml");
  EXPECT_EQ(get("/api/moments").status, 404);
  write("opened/two.csv",
        "id,kind,point,load_lbf,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,sigma_in\n"
        "a,position,,0,0,0,0,0,90,0,0,0.01\nb,position,,30,0,0,0,0,90,0,0,0.01\n");
  ASSERT_EQ(post("/api/measurements/open", {{"file", "two.csv"}}).status, 200);
  const json moments = get("/api/moments").body;
  const auto named = [&](const char* name, const char* id) -> double {
    const auto at = std::find(moments["names"].begin(), moments["names"].end(), name) - moments["names"].begin();
    return moments["readings"][id][static_cast<std::size_t>(at)];
  };
  EXPECT_EQ(moments["names"].size(), 18u);
  const json pose = post("/api/pose", {{"joints", {0, 0, 0, 0}}, {"load", 0}}).body;
  const auto& frames = pose["frames"]["rigid"];
  for (const auto& frame : frames) {
    const auto row = static_cast<std::size_t>(frame["row"]);
    double lever = 0;
    for (int k = 0; k < 2; ++k)
      lever += std::pow(pose["tip"]["rigid"][k].get<double>() - frame["position"][k].get<double>(), 2);
    double gained = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      gained += std::pow(moments["readings"]["b"][3 * row + axis].get<double>() -
                             moments["readings"]["a"][3 * row + axis].get<double>(),
                         2);
    EXPECT_NEAR(std::sqrt(gained), 30 * std::sqrt(lever), 1e-6) << row;  // the load times its horizontal distance
  }
  EXPECT_NE(named("moment_tool_z", "a"), named("moment_tool_z", "b"));
}

TEST_F(WorkbenchRoutes, anotherCellCanBeOpened) {
  serve("bench.yaml");
  EXPECT_EQ(post("/api/cell/open", {{"file", "mockup.yaml"}}).body["cell"]["name"], "cobra-mockup");
  EXPECT_EQ(get("/api/sheet").status, 200);
  EXPECT_EQ(post("/api/cell/open", {{"file", "cobra-arm.yaml"}}).status, 422);
  EXPECT_EQ(post("/api/cell/open", {{"file", "/etc/passwd"}}).status, 422);
  EXPECT_EQ(get("/api/state").body["cell"]["name"], "cobra-mockup");
}

TEST_F(WorkbenchRoutes, aRobotIsExportedIntoItsOwnFile) {
  const auto part = [](const std::string& name, const std::string& type, const std::string& parent) {
    return fmt::format(
        "<link name=\"{0}\"><visual><geometry><mesh filename=\"{0}.stl\"/></geometry></visual></link>\n"
        "<joint name=\"to_{0}\" type=\"{1}\"><parent link=\"{2}\"/><child link=\"{0}\"/><origin xyz=\"0.3 0 0.1\"/>"
        "<axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint>\n",
        name, type, parent);
  };
  const std::string robot = "<robot name=\"r\"><link name=\"base\"/>\n" + part("upper", "revolute", "base") +
                            part("lower", "revolute", "upper") + part("hand", "fixed", "lower") +
                            part("left", "fixed", "hand") + part("right", "fixed", "hand") + "</robot>\n";
  serve("bench.yaml");
  const json written = post("/api/arm/import", {{"name", "r.urdf"}, {"text", robot}, {"tip", "left"}}).body["written"];
  EXPECT_EQ(written, json({"r.yaml", "r-arm.yaml", "r.urdf"}));
  EXPECT_EQ(contentOf(opened() / "r.urdf"), robot);
  ASSERT_EQ(post("/api/cell/open", {{"file", "r.yaml"}}).status, 200);
  EXPECT_EQ(get("/api/export/arm.urdf").text, robot);
  write("opened/r.urdf", changed(robot, "<axis", "<!-- mine --><axis"));
  EXPECT_NE(get("/api/export/arm.urdf").text.find("<!-- mine -->"), std::string::npos);
  write("opened/r.urdf", "<robot/>");
  EXPECT_NE(get("/api/export/arm.urdf").text.find("other elements of r.urdf"), std::string::npos);
}

TEST_F(WorkbenchRoutes, touchingHolesPlacesTheBase) {
  serve("mockup.yaml", "mockup-true.yaml");
  for (const int hole : {0, 11, 90}) EXPECT_EQ(post("/api/touch", {{"hole", hole}, {"simulate", true}}).status, 200);
  EXPECT_EQ(get("/api/state").body["touches"], 3);
  EXPECT_EQ(replyOf(client->Delete("/api/touch/1")).status, 200);
  EXPECT_EQ(replyOf(client->Delete("/api/touch/9")).status, 404);
  EXPECT_EQ(work("/api/calibrate")["status"], "failed");  // two touches do not determine a base
  EXPECT_EQ(post("/api/touch", {{"hole", 6}, {"load", -3}}).status, 422);
  EXPECT_EQ(post("/api/touch", {{"hole", 6}, {"load", 20}}).status, 200);
  const json touches = get("/api/touches").body["touches"];
  ASSERT_EQ(touches.size(), 3u);
  EXPECT_EQ(touches[2]["name"], "R1C7");
  EXPECT_EQ(touches[2]["simulated"], true);
  EXPECT_NEAR(touches[2]["load"], 20, 1e-9);
  done("/api/calibrate");
  const json calibrated = get("/api/results/calibrate").body;
  EXPECT_EQ(calibrated["residuals"].size(), 3u);
  EXPECT_TRUE(std::ranges::any_of(calibrated["warnings"], [](const json& warning) {
    return warning.get<std::string>().find("3 of 3 touches are simulated") != std::string::npos;
  }));
  EXPECT_TRUE(get("/api/export/touches.csv").text.starts_with("# simulated, not touched: T1, T3, T4\n"));
  EXPECT_EQ(get("/api/state").body["models"][1]["origin"], "calibration");
  EXPECT_EQ(get("/api/state").body["models"][1]["base"]["touches"], 3);
  EXPECT_EQ(post("/api/touch", {{"hole", 5000}}).status, 422);
}

TEST_F(WorkbenchRoutes, touchesThatPlaceNoBaseAreShownAndLeaveTheModel) {
  serve("mockup.yaml", "mockup.yaml");
  for (const int hole : {0, 11, 90, 6}) ASSERT_EQ(post("/api/touch", {{"hole", hole}, {"simulate", true}}).status, 200);
  const json last = get("/api/touches").body["touches"][3];
  std::vector<double> joints = last["joints"];
  joints[0] += 3;  // [deg]
  EXPECT_EQ(replyOf(client->Delete("/api/touch/3")).status, 200);
  EXPECT_EQ(post("/api/touch", {{"hole", 6}, {"joints", joints}}).status, 200);
  done("/api/calibrate");
  const json found = get("/api/results/calibrate").body, state = get("/api/state").body;
  EXPECT_EQ(found["status"], "refused");
  EXPECT_FALSE(found.contains("base"));
  EXPECT_EQ(found["residuals"].size(), 4u);
  EXPECT_EQ(found["odd_touch"], found["residuals"][3]["id"]);
  const json& suspects = found["suspect_readings"];
  EXPECT_TRUE(std::any_of(suspects.begin(), suspects.end(), [&](const json& suspect) {
    return suspect["touch"] == found["odd_touch"] && suspect["joint"] == "theta1" &&
           std::abs(suspect["off"].get<double>() - 3) < 1;
  })) << suspects;
  EXPECT_EQ(state["models"].size(), 1u);
  EXPECT_EQ(state["models"][0]["base"]["status"], "nominal");
}

TEST_F(WorkbenchRoutes, proposalsReachAndFields) {
  serve("mockup.yaml", "mockup-true.yaml");
  done("/api/touches", {{"tubes", "spread:6"}});
  EXPECT_TRUE(get("/api/results/touches").body.contains("base"));
  done("/api/reach");
  const json reach = get("/api/results/reach").body;
  EXPECT_EQ(reach["reachable"].size(), 96u);
  for (std::size_t k = 0; k < 96; ++k)
    EXPECT_EQ(reach["reachable"][k] == 1, reach["branches"][k] > 0) << reach["reason"][k];
  EXPECT_EQ(post("/api/field", {{"of", "sag"}, {"model", 7}}).status, 422);
  done("/api/field", {{"of", "sag"}, {"model", 0}});
  EXPECT_EQ(get("/api/results/field?model=0").body["of"], "sag");
  for (const char* of : {"sag", "centring"}) {
    done("/api/field", {{"of", of}});
    const json field = get("/api/results/field").body;
    EXPECT_EQ(field["of"], of);
    EXPECT_EQ(field["values"].size(), 96u);
    EXPECT_TRUE(std::any_of(field["values"].begin(), field["values"].end(), [](const json& v) { return v > 0.01; }));
  }
}

TEST_F(WorkbenchRoutes, aWorkListSelectsItsTubesAndSaysWhatItLeavesOut) {
  serve("mockup.yaml");
  const auto of = [&](const std::string& text) { return post("/api/tubes", {{"name", "work.csv"}, {"text", text}}); };
  const auto list = of("Row;Col;Status;Weather\n1;1;;fine\n1;2;PLG;\n1;1;;again\n");
  ASSERT_EQ(list.status, 200);
  EXPECT_EQ(list.body["tubes"].size(), 1u);  // R1C1 is named twice, and R1C2 is plugged
  const std::string notes = list.body["notes"].dump();
  EXPECT_NE(notes.find("1 plugged"), std::string::npos) << notes;
  EXPECT_NE(notes.find("Weather"), std::string::npos) << notes;
  const auto dwell_times = of("row,column,dwell_s\n1,1,30\n");
  ASSERT_EQ(dwell_times.status, 200);
  EXPECT_EQ(dwell_times.body["stays"].size(), 1u);
  EXPECT_EQ(dwell_times.body["stays"].begin().value(), 30);
  for (const char* wrong : {"", "a,b\n1,2\n", "row,column\n99,99\n", "row,column\n1\n", "row,column\none,two\n",
                            "row,column,status\n1,1,PLG\n1,1,open\n", "row,column,status\n1,99,melted\n"})
    EXPECT_EQ(of(wrong).status, 422) << wrong;
}

TEST_F(WorkbenchRoutes, aWorkListIsReadByTheColumnsThatAreNamed) {
  serve("mockup.yaml");
  const auto columnsOf = [&](const std::string& text) {
    return post("/api/tubes/columns", {{"tables", json::array({{{"name", "work.csv"}, {"text", text}}})}});
  };
  const auto states = [&](const std::string& text) { return columnsOf(text).body["states"]; };
  EXPECT_EQ(states("Row;Col\n1;1\n"), "tubes");
  EXPECT_EQ(states("Reihe;Spalte;Dauer\n1;1;20\n"), "neither");
  EXPECT_EQ(states("hole,J1,J2,J3,J4\nR1C1,10,20,30,40\n"), "joints");
  const std::string text = "Reihe;Spalte;Dauer;x\n1;1;20;3\n1;2;;3\n";
  const json columns = columnsOf(text).body;
  EXPECT_EQ(columns["tables"][0]["columns"], json::array({"Reihe", "Spalte", "Dauer", "x"}));
  EXPECT_FALSE(columns["is_understood"]);
  const auto of = [&](const json& chosen) {
    return post("/api/tubes", {{"name", "work.csv"}, {"text", text}, {"columns", chosen}});
  };
  const auto list = of({"row=work.csv:Reihe", "column=work.csv:Spalte", "dwell_s=work.csv:Dauer"});
  ASSERT_EQ(list.status, 200) << list.body.dump();
  EXPECT_EQ(list.body["tubes"].size(), 2u);
  EXPECT_EQ(list.body["stays"].size(), 1u);
  for (const json& wrong : {json::array({"row=Reihe"}), json::array({"row=Reihe", "column=Reihen"}),
                            json::array({"row=Reihe", "column=Spalte", "dwell=Dauer"}),
                            json::array({"row=Reihe", "row=Spalte", "column=x"}), json::array({"Reihe"})})
    EXPECT_EQ(of(wrong).status, 422) << wrong;
  EXPECT_EQ(columnsOf("").status, 422);
  EXPECT_EQ(post("/api/tubes/columns", {{"tables", json::array()}}).status, 422);
}

TEST_F(WorkbenchRoutes, aPlanStaysAsLongAsAskedAtItsTubes) {
  serve("mockup.yaml");
  done("/api/plan", {{"tubes", json::array({3, 40, 41})}, {"seed", 2}, {"stays", {{"40", 25}, {"77", 10}}}});
  std::map<double, int> dwell_times;
  const json plan = get("/api/results/plan").body;
  for (const json& tube : plan["tubes"]) ++dwell_times[tube.value("dwell_s", 0.0)];
  EXPECT_EQ(dwell_times[25], 1);
  EXPECT_FALSE(dwell_times.contains(10));
  for (const json& wrong : {json{{"40", -1}}, json{{"40", 1e6}}, json{{"9999", 1}}, json{{"x", 1}}, json{{"40", "1"}}})
    EXPECT_EQ(post("/api/plan", {{"tubes", json::array({3, 40})}, {"stays", wrong}}).status, 422) << wrong;
}

TEST_F(WorkbenchRoutes, aPlanCanBePlayedAndExported) {
  serve("mockup.yaml");
  done("/api/plan", {{"tubes", json::array({3, 40, 41, 77})}, {"seed", 2}});
  const json plan = get("/api/results/plan").body;
  EXPECT_EQ(plan["tubes"].size() + plan["unreachable"].size(), 4u);
  EXPECT_EQ(plan["seed"], 2);
  const json path = get("/api/plan/path").body;
  ASSERT_GT(path["time"].size(), 10u);
  EXPECT_EQ(path["joints"].size(), path["time"].size());
  EXPECT_EQ(path["tube"].size(), path["time"].size());
  EXPECT_TRUE(std::is_sorted(path["time"].begin(), path["time"].end()));
  for (const char* name : {"plan.json", "path.csv", "worklist.csv", "trajectory.yaml", "report.html"})
    EXPECT_EQ(get(std::string("/api/export/") + name).status, 200) << name;
  EXPECT_EQ(post("/api/plan", {{"tubes", "R99C99"}}).status, 422);
  EXPECT_EQ(post("/api/plan", {{"tubes", json::array({96})}}).status, 422);
  EXPECT_EQ(post("/api/plan", {{"compensation", "magic"}}).status, 422);
}

TEST_F(WorkbenchRoutes, clearanceIsKnownAlongTheTourAndNeverBelowWhatIsProved) {
  serve("mockup.yaml");
  EXPECT_EQ(get("/api/plan/clearance").status, 404);
  done("/api/plan", {{"tubes", json::array({3, 40, 41, 77})}, {"seed", 2}});
  const json path = get("/api/plan/path").body, all = get("/api/plan/clearance").body;
  const std::size_t samples = path["time"].size();
  ASSERT_EQ(all["clearance"].size(), samples);
  std::map<int, std::set<double>> of_segment;
  for (std::size_t k = 0; k < samples; ++k) {
    const int segment = path["segment"][k];
    const double clearance = all["clearance"][k], proved = path["clearance"][static_cast<std::size_t>(segment)];
    EXPECT_GE(clearance, proved - 1e-6) << "sample " << k << " of segment " << segment;
    of_segment[segment].insert(clearance);
  }
  std::size_t most = 0;
  for (const auto& [segment, values] : of_segment) most = std::max(most, values.size());
  EXPECT_GT(most, 5u);  // the clearance changes along a segment
  const json some = get("/api/plan/clearance?from=4&count=3").body;
  EXPECT_EQ(some["from"], 4);
  EXPECT_EQ(some["samples"], samples);
  EXPECT_EQ(some["clearance"], json(std::vector<json>(all["clearance"].begin() + 4, all["clearance"].begin() + 7)));
  EXPECT_EQ(get("/api/plan/clearance?from=" + std::to_string(samples)).status, 422);
  for (const char* from : {"-1", "x", "1.5", "99999999999999999999", ""})
    EXPECT_EQ(get(std::string("/api/plan/clearance?from=") + from).status, 422) << from;
}

TEST_F(WorkbenchRoutes, aPlanStopsWhenItIsAskedTo) {
  std::filesystem::copy_file(shippedCells() / "mockup.yaml", opened() / "large.yaml");
  serve("large.yaml");
  const int id = post("/api/plan", {{"tubes", "all"}}).body["id"];
  EXPECT_EQ(post("/api/plan", {{"tubes", "all"}}).status, 409);
  EXPECT_EQ(post("/api/cell/open", {{"file", "bench.yaml"}}).status, 409);
  EXPECT_EQ(post("/api/jobs/" + std::to_string(id) + "/cancel").body["id"], id);
  EXPECT_EQ(ended(id)["status"], "cancelled");
  EXPECT_EQ(get("/api/results/plan").status, 404);
}

TEST_F(WorkbenchRoutes, otherMeasurementsEndWhatIsFoundOutFromThoseBeforeAndNoPlan) {
  std::filesystem::copy_file(shippedCells() / "mockup.yaml", opened() / "large.yaml");
  serve("large.yaml");
  simulate(400);
  const std::string measurements = get("/api/export/measurements.csv").text;
  const int plan = post("/api/plan", {{"tubes", "spread:20"}}).body["id"];
  const int diagnosis = post("/api/diagnose").body["id"];  // starts after the plan
  EXPECT_EQ(client->Post("/api/measurements?name=first.csv", measurements, "text/csv")->status, 200);
  EXPECT_EQ(ended(plan)["status"], "done");
  EXPECT_EQ(get("/api/results/plan").status, 200);
  untilAtWork(diagnosis, "diagnose");
  EXPECT_EQ(client->Post("/api/measurements?name=second.csv", measurements, "text/csv")->status, 200);
  EXPECT_EQ(ended(diagnosis)["status"], "cancelled");
  EXPECT_EQ(get("/api/results/diagnose").status, 404);
}

TEST_F(WorkbenchRoutes, theLoopStopsWhereverItIs) {
  serve("bench.yaml");
  simulate(400);
  const json add = {{"causes", {"joint-offset@theta3"}}};
  const std::pair<const char*, json> requests[] = {{"compare", json::object()},  {"diagnose", json::object()},
                                                   {"identify", json::object()}, {"ladder", json::object()},
                                                   {"improve", json::object()},  {"add", add}};
  for (const auto& [kind, body] : requests) {
    const json begun = post(std::string("/api/") + kind, body).body;
    const int id = begun["id"];
    untilAtWork(id, kind);
    post("/api/jobs/" + std::to_string(id) + "/cancel");
    EXPECT_EQ(ended(id)["status"], "cancelled") << kind;
    EXPECT_EQ(get(std::string("/api/results/") + kind).status, 404) << kind;
    EXPECT_EQ(get("/api/state").body["models"].size(), 1u) << kind;
  }
  done("/api/identify");  // the next job runs as usual
  EXPECT_EQ(get("/api/results/identify").status, 200);
}

}  // namespace
}  // namespace tubeplan::app
