// Postures sent by a running arm are answered at once and not stored, and its measurements are added to the loaded
// measurements. Measurements can also be held out of fits.
#include "app/workbench/live.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string/replace.hpp>
#include <boost/asio.hpp>
#include <sstream>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/measurements/measurement_input.hpp"
#include "app/storage/input_error.hpp"
#include "app/workbench/line_server.hpp"
#include "app/workbench/measurement_sets.hpp"
#include "tests/app/workbench/running_server.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class LiveTest : public WorkbenchTest {
 protected:
  static constexpr const char* kHeader =
      "id,kind,load_lbf,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,sigma_in\n";

  Reply send(const std::string& text) { return replyOf(client->Post("/api/live/readings", text, "text/csv")); }

  [[nodiscard]] static std::string row(int id) {
    return fmt::format("{},position,0,{},40,-50,10,70,{},20,0.005\n", id, id, id);
  }
};

TEST_F(LiveTest, EncodersAreAnsweredWithTheDeflectedTipAndKeptNowhere) {
  serve("bench.yaml");
  const auto before = get("/api/state").body;
  const auto answer = post("/api/live/encoders", {{"joints", {10, 45, -35, 12}}, {"load", 20}});
  ASSERT_EQ(answer.status, 200) << answer.text;
  EXPECT_EQ(answer.body["tip"],
            post("/api/pose", {{"joints", {10, 45, -35, 12}}, {"load", 20}}).body["tip"]["flexible"]);
  EXPECT_EQ(get("/api/state").body, before);
  Events::Seen seen;
  const auto news = server->workbench().events().wait(seen, std::chrono::milliseconds(100));
  EXPECT_EQ(json::parse(news.live)["joints"].size(), 4u);
  EXPECT_TRUE(server->workbench().events().wait(seen, std::chrono::milliseconds(10)).live.empty()) << "told once";
}

TEST_F(LiveTest, BadEncodersAreRefused) {
  serve("bench.yaml");
  for (const json& joints : {json({1, 2}), json({1, 2, 3, 1e9}), json("x"), json()})
    EXPECT_EQ(post("/api/live/encoders", {{"joints", joints}}).status, 422) << joints;
}

/// A client that acts like a controller: it writes lines and waits for each answer.
class LineClient {
 public:
  explicit LineClient(int port) : stream_("127.0.0.1", std::to_string(port)) {}
  std::string send(const std::string& line) {
    stream_ << line << "\n" << std::flush;
    std::string answer;
    std::getline(stream_, answer);
    return answer;
  }
  void begin(const std::string& text) { stream_ << text << std::flush; }

 private:
  boost::asio::ip::tcp::iostream stream_;
};

TEST_F(LiveTest, LinesOverTcpAreAnsweredWithTheDeflectedTip) {
  serve("bench.yaml");
  const LineServer lines(server->workbench(), 0);
  LineClient controller(lines.port()), stalled(lines.port());
  stalled.begin("10 45");  // an unfinished line blocks only its own connection
  const json tip = post("/api/pose", {{"joints", {10, 45, -35, 12}}, {"load", 20}}).body["tip"]["flexible"];
  for (const char* line : {"10 45 -35 12 20", "10,45,-35,12,20", "10; 45; -35; 12; 20\r", "\t10 45 -35 12   20 "}) {
    std::stringstream answer(controller.send(line));
    for (int k = 0; k < 3; ++k) {
      double coordinate = 0;
      ASSERT_TRUE(answer >> coordinate) << line;
      EXPECT_DOUBLE_EQ(coordinate, tip[k].get<double>()) << line;
    }
  }
  for (const char* line :
       {"", "1 2 3", "1 2 3 4 5 6", "10 45 -35 x", "10 45 -35 1e9", "10 45 -35 nan", "10 45 -35 12 -5"})
    EXPECT_TRUE(controller.send(line).starts_with("error: ")) << line;
  EXPECT_FALSE(controller.send("10 45 -35 12").starts_with("error: "));
  EXPECT_THROW(LineServer(server->workbench(), lines.port()), InputError);
}

TEST_F(LiveTest, ALineWithoutEndClosesItsConnection) {
  serve("bench.yaml");
  const LineServer lines(server->workbench(), 0);
  LineClient endless(lines.port());
  EXPECT_EQ(endless.send(std::string(100000, '1')), "");
  LineClient controller(lines.port());
  EXPECT_FALSE(controller.send("10 45 -35 12").starts_with("error: "));
}

TEST_F(LiveTest, MeasurementsJoinTheOthersAndAreCompared) {
  serve("bench.yaml");
  std::string text = kHeader;
  for (int id = 1; id <= 12; ++id) text += row(id);
  ASSERT_EQ(send(text).status, 202);
  const auto state = get("/api/state").body;
  EXPECT_EQ(state["measurements"]["readings"], 12);
  ASSERT_FALSE(state["jobs"].empty());
  EXPECT_EQ(state["jobs"].back()["kind"], "compare");
  (void)ended(state["jobs"].back()["id"]);
  EXPECT_EQ(send(kHeader + row(13)).status, 202);
  EXPECT_EQ(get("/api/state").body["measurements"]["readings"], 13);
  EXPECT_EQ(send(kHeader + row(13)).status, 422) << "an id that is there";
  EXPECT_EQ(send("id,kind\n").status, 422);
}

TEST_F(LiveTest, CopiesThatJoinAreCountedOnce) {
  serve("bench.yaml");
  simulate();
  std::string copies = boost::replace_all_copy(get("/api/export/measurements.csv").text, "\n", "\nN");
  copies.pop_back();
  ASSERT_EQ(send(copies).status, 202);
  const json now = get("/api/state").body["measurements"];
  EXPECT_EQ(now["readings"], 30);
  EXPECT_EQ(now["joined"], 0);
  EXPECT_NE(now["checks"].dump().find("copies"), std::string::npos) << now["checks"];
  (void)ended(get("/api/state").body["jobs"].back()["id"]);
  EXPECT_EQ(post("/api/measurements/assume", {{"assume", {"as-is"}}}).body["measurements"]["readings"], 60);
  EXPECT_EQ(post("/api/measurements/part").body["measurements"]["readings"], 30);
}

TEST_F(LiveTest, NoMeasurementsChangeBesideARunningJob) {
  serve("bench.yaml");
  simulate();
  ASSERT_EQ(send(kHeader + row(41)).status, 202);
  (void)ended(get("/api/state").body["jobs"].back()["id"]);
  HeldJob held(server->workbench());
  const std::pair<const char*, json> changes[] = {{"/api/measurements/part", json::object()},
                                                  {"/api/measurements/assume", {{"assume", {"as-is"}}}},
                                                  {"/api/measurements/set-aside", {{"ids", {"41"}}}}};
  for (const auto& [path, body] : changes) EXPECT_EQ(post(path, body).status, 409) << path;
  held.release();
  (void)ended(held.id());
  EXPECT_EQ(post("/api/measurements/part").body["measurements"]["readings"], 30);
}

TEST_F(LiveTest, MeasurementsThatJoinedArePartedAgainAndTheMarksOfTheOthersStay) {
  serve("bench.yaml");
  EXPECT_EQ(post("/api/measurements/part").status, 404) << "no readings";
  const auto sent = [&](const std::string& rows) {
    EXPECT_EQ(send(kHeader + rows).status, 202);
    (void)ended(get("/api/state").body["jobs"].back()["id"]);
  };
  sent(row(1) + row(2) + row(3));
  EXPECT_EQ(post("/api/measurements/part").status, 409) << "the first have joined none";
  sent(row(4) + row(5));
  EXPECT_EQ(post("/api/measurements/set-aside", {{"ids", {"1", "5"}}}).status, 200);
  EXPECT_EQ(get("/api/state").body["measurements"]["joined"], 2);
  const auto parted = post("/api/measurements/part");
  ASSERT_EQ(parted.status, 200) << parted.text;
  EXPECT_EQ(parted.body["measurements"]["readings"], 3);
  EXPECT_EQ(parted.body["measurements"]["set_aside"], 1);
  EXPECT_EQ(parted.body["measurements"]["joined"], 0);
  EXPECT_EQ(parted.body["results"]["compare"], nullptr) << "it was of all";
  EXPECT_EQ(post("/api/measurements/part").status, 409) << "once";
}

TEST_F(LiveTest, WhatCannotBeReadTogetherJoinsAsItIs) {
  const Cell cell = readCell((opened() / "bench.yaml").string());
  auto measurements = parseMeasurementText(kHeader + row(1) + row(2), "two", cell);
  const auto known = joinedSet(nullptr, measurements, cell);
  EXPECT_EQ(known->measurements.size(), 2u);
  EXPECT_NE(known->source, nullptr);
  measurements.resize(1);
  measurements.front().id = "3";
  measurements.front().q[0] = 100;  // far beyond the joint limits, so a file with this measurement would be refused
  const auto joined = joinedSet(known.get(), measurements, cell);
  EXPECT_EQ(joined->measurements.size(), 3u);
  EXPECT_EQ(joined->source, nullptr);
}

TEST_F(LiveTest, AMeasurementThatJoinsMovesThePosterior) {
  serve("bench.yaml");
  simulate();
  const auto kindsSince = [&](std::size_t first) {
    std::vector<std::string> kinds;
    const auto jobs = get("/api/state").body["jobs"];
    for (std::size_t k = first; k < jobs.size(); ++k) kinds.push_back(jobs[k]["kind"]);
    return kinds;
  };
  const auto joined = send(kHeader + row(41));
  ASSERT_EQ(joined.status, 202) << joined.text;
  EXPECT_EQ(kindsSince(1), std::vector<std::string>{"compare"}) << "nobody asked for a diagnosis yet";
  (void)ended(get("/api/state").body["jobs"].back()["id"]);
  done("/api/diagnose", {{"effects", 1}});
  ASSERT_EQ(send(kHeader + row(42)).status, 202);
  EXPECT_EQ(kindsSince(3), (std::vector<std::string>{"compare", "diagnose"}));
  EXPECT_EQ(ended(get("/api/state").body["jobs"].back()["id"])["status"], "done");
  EXPECT_EQ(get("/api/results/diagnose").body["readings"].size(), 32u);
}

TEST_F(LiveTest, AWatchedFileIsReadByWholeRowsOnceEach) {
  serve("bench.yaml");
  const auto file = folder / "watched.csv";
  const auto put = [&](const std::string& text) { write("watched.csv", text); };
  WatchedFile watched(file);
  watched.look(server->workbench());  // the file does not exist yet
  put(std::string(kHeader) + row(1) + row(2) + "3,posi");
  watched.look(server->workbench());
  EXPECT_EQ(server->workbench().arrivals().drain().size(), 2u);
  put(std::string(kHeader) + row(1) + row(2) + row(3));
  watched.look(server->workbench());
  joinArrived(server->workbench());
  EXPECT_EQ(get("/api/state").body["measurements"]["readings"], 3);
  put("theta1_deg,theta2_deg,theta3_deg,theta4_deg\n10,45,-35,12\n");
  watched.look(server->workbench());
  Events::Seen seen;
  EXPECT_EQ(json::parse(server->workbench().events().wait(seen, std::chrono::milliseconds(100)).live)["joints"][0], 10);
}

TEST_F(LiveTest, MeasurementsAreHeldOutAndTakenBack) {
  serve("bench.yaml");
  simulate();
  done("/api/compare");
  const auto hold = [&](const json& ids, bool held) {
    return post("/api/measurements/hold-out", {{"ids", ids}, {"held_out", held}});
  };
  const auto held = hold({"3", "4", "5"}, true);
  ASSERT_EQ(held.status, 200) << held.text;
  EXPECT_EQ(held.body["measurements"]["held_out"], 3);
  EXPECT_TRUE(held.body["results"]["compare"].is_null());
  done("/api/compare", {{"ladder", true}});
  int judged = 0;
  const json compared = get("/api/results/compare").body, rows = get("/api/measurements").body["rows"];
  for (const auto& measurement : compared["readings"]) judged += measurement["held_out"] ? 1 : 0;
  EXPECT_EQ(judged, 3);
  EXPECT_EQ(get("/api/results/ladder").status, 200);
  EXPECT_EQ(hold({"3", "4", "5"}, false).body["measurements"]["held_out"], 0);
  EXPECT_EQ(hold({"no-such"}, true).status, 422);
  json all = json::array();
  for (const auto& entry : rows) all.push_back(entry["id"]);
  EXPECT_EQ(hold(all, true).status, 422) << "none left to fit";
}

}  // namespace
}  // namespace tubeplan::app
