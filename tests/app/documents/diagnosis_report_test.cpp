#include "app/report/diagnosis_report.hpp"

#include <fmt/format.h>

#include <regex>

#include "tests/app/program.hpp"
#include "tests/calibration/bench_measurements.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

const std::vector<std::string> kHostile = {"</script><script>alert(1)</script>",
                                           "<!--<script>",
                                           "<img src=x onerror=alert(1)>",
                                           "\"};alert(1);//",
                                           "&lt;/script&gt;",
                                           "/*SCRIPT*/",
                                           "/*REPORT*/"};

/// Returns the data between the tags of the data block, which a browser ends at the first "</script".
json dataOf(const std::string& page) {
  const std::string opening = R"(<script type="application/json" id="report">)";
  const std::size_t start = page.find(opening) + opening.size();
  return json::parse(page.substr(start, page.find("</script", start) - start));
}

void expectOneFile(const std::string& page) {
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0U);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(page.find("/*STYLE*/"), std::string::npos);
  EXPECT_EQ(page.find("@import"), std::string::npos);
  EXPECT_FALSE(std::regex_search(page, std::regex(R"((src|href)\s*=\s*["']?(https?:)?//)")));
  std::string without = page;
  const std::string names = "http://www.w3.org/";
  for (std::size_t at = without.find(names); at != std::string::npos; at = without.find(names, at))
    without.erase(at, names.size());
  EXPECT_EQ(without.find("http:"), std::string::npos);
  EXPECT_EQ(without.find("https:"), std::string::npos);
}

TEST(DiagnosisReport, eachKindIsOneFileThatSaysWhatItIs) {
  const json figures = {{"verdict", "adequate"}, {"sentence", "Nothing is missing."}};
  for (const auto& [page, kind] :
       {std::pair{renderDiagnosisReport(figures), "diagnosis"},
        std::pair{renderComparisonReport(figures), "comparison"}, std::pair{renderLadderReport(figures), "ladder"}}) {
    expectOneFile(page);
    json expected = figures;
    expected["page"] = kind;
    EXPECT_EQ(dataOf(page), expected);
  }
}

TEST(DiagnosisReport, hostileTextStaysText) {
  const std::size_t blocks = occurrences(renderDiagnosisReport(json::object()), "<script");
  for (const std::string& text : kHostile) {
    const json figures = {{"sentence", text},
                          {"verdict", text},
                          {"ranking", {{{"effect", text}, {"at", text}, {"probability", 1}}}},
                          {"readings", {{{"id", text}, {"point", text}, {"position", {1, 2, 3}}}}},
                          {"set_aside", {text}},
                          {text, text}};
    for (const std::string& page :
         {renderDiagnosisReport(figures), renderComparisonReport(figures), renderLadderReport(figures)}) {
      EXPECT_EQ(occurrences(page, "<script"), blocks) << text;
      EXPECT_EQ(occurrences(page, "</script"), blocks) << text;
      EXPECT_EQ(dataOf(page)["readings"], figures["readings"]) << text;
    }
  }
}

TEST(DiagnosisReport, anythingButAnObjectIsAnEmptyPage) {
  for (const json& figures : {json(), json(3), json::array({1, 2}), json("text")})
    EXPECT_EQ(dataOf(renderDiagnosisReport(figures)), json({{"page", "diagnosis"}}));
}

class DiagnosisReportOfProgram : public ProgramTest {
 protected:
  static constexpr int kMeasurements = 36;

  /// Returns a CSV table of measurements, whose ids contain text that would end a script block if it were not escaped.
  [[nodiscard]] static std::string measurementsCsv(const std::string& effect, const std::vector<double>& values) {
    const auto measurements =
        calibration::benchMeasurements(calibration::shippedBench(), effect, "theta4", values, kMeasurements, 7);
    std::string csv =
        "id,kind,load_lbf,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,sigma_in,theta1_dir,theta2_dir,"
        "theta3_dir,theta4_dir\n";
    for (const auto& measurement : measurements) {
      csv += fmt::format("{}{},position,{:.9g}", kHostile.front(), measurement.id, measurement.load / kPound);
      for (const double q : measurement.q) csv += fmt::format(",{:.9f}", q / kDegree);
      for (const double x : *measurement.p_W) csv += fmt::format(",{:.9f}", x / kInch);
      csv += ",0.003";
      for (const int approach_direction : measurement.approach_directions)
        csv += fmt::format(",{}", approach_direction);
      csv += "\n";
    }
    return csv;
  }
};

TEST_F(DiagnosisReportOfProgram, isWrittenWithWhatJsonSaysAndItsMeasurements) {
  write("readings.csv", measurementsCsv("hysteresis", {0.1 * kDegree}));
  const auto outcome =
      run("diagnose " + shipped("bench.yaml") + " readings.csv --effects 1 --report page.html --json -");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string page = contentOf(folder / "page.html");
  expectOneFile(page);
  const json data = dataOf(page), figures = json::parse(outcome.out);
  for (const auto& [key, value] : figures.items()) EXPECT_EQ(data[key], value) << key;
  EXPECT_EQ(data["verdict"], "explained");
  EXPECT_EQ(data["verdict_words"], "Explained");
  ASSERT_GE(data["sentences"].size(), 2U);
  EXPECT_TRUE(std::regex_search(data["sentences"][0].get<std::string>(),
                                std::regex(R"(^Missing: hysteresis at theta4 \(half width 0\.\d+ ± 0\.\d+ deg\)\.$)")))
      << data["sentences"][0];
  std::string together = data["sentences"][0];
  for (std::size_t k = 1; k < data["sentences"].size(); ++k) together += " " + data["sentences"][k].get<std::string>();
  EXPECT_EQ(data["sentence"], together);
  EXPECT_EQ(data["ranking"][0]["words"], "a joint's position depends on the direction of its last motion");
  EXPECT_EQ(data["explanations"][0]["effects"][0]["varies_with"], json({"sense"}));
  ASSERT_EQ(data["readings"].size(), static_cast<std::size_t>(kMeasurements));
  EXPECT_EQ(data["readings"][0]["id"], kHostile.front() + "1");
  EXPECT_EQ(occurrences(page, "<script"), occurrences(renderDiagnosisReport(json::object()), "<script"));
  for (const auto& measurement : data["readings"]) {
    EXPECT_EQ(measurement["position"].size(), 3U);
    EXPECT_EQ(measurement["before"].size(), 3U);
    EXPECT_EQ(measurement["after"], measurement["explained"][0]);
    EXPECT_EQ(measurement["joints"].size(), data["joints"].size());
  }
  ASSERT_EQ(data["ladder"].size(), 3U);
  EXPECT_GT(data["ladder"][1]["rms"], data["ladder"][2]["rms"]);
  EXPECT_GT(data["ladder"][1]["heldout_rms"], data["ladder"][2]["heldout_rms"]);
  EXPECT_EQ(data["ladder"][2]["name"], "with hysteresis at theta4");
  ASSERT_EQ(data["added_variable"].size(), 1U);
  EXPECT_EQ(data["added_variable"][0]["points"].size(), 3U * kMeasurements);
}

TEST_F(DiagnosisReportOfProgram, aPlaceThatCannotBeWrittenIsRefusedBeforeTheWork) {
  write("readings.csv", measurementsCsv("", {}));
  const auto outcome = run("diagnose " + shipped("bench.yaml") + " readings.csv --report .");
  EXPECT_NE(outcome.exit_code, 0);
  expectSays(outcome.err, "--report");
  EXPECT_TRUE(outcome.out.empty()) << outcome.out;
}

}  // namespace
}  // namespace tubeplan::app
