#include "app/report/plan_report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>
#include <string>
#include <vector>

#include "app/report/page.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

/// Returns the text between the tags of the data block, which a browser ends at the first "</script".
std::string dataBlock(const std::string& page) {
  const std::string opening = R"(<script type="application/json" id="report">)";
  const std::size_t start = page.find(opening) + opening.size();
  return page.substr(start, page.find("</script", start) - start);
}

/// Returns the document as it is embedded in the page, that is, with the name of the page added.
json asPlan(json document) {
  document["page"] = "plan";
  return document;
}

json smallReport() {
  const json score = {{"error", 0.03}, {"dx", 0.03}, {"dy", 0.0}, {"steps", 2}, {"approach_deviation", 0.0004}};
  return {
      {"title", "Plan for a small cell"},
      {"units", {{"length", "in"}, {"angle", "deg"}}},
      {"sheet",
       {{"leg", "hot"},
        {"viewed_from", "below"},
        {"holes", {{1, 1, 0.0, 2.28, "open"}, {1, 2, 1.0, 2.28, "plugged"}}}}},
      {"tubes",
       {{{"order", 1}, {"row", 1}, {"column", 1}, {"x", 0.0}, {"y", 2.28}, {"via_point", score}, {"none", nullptr}}}},
      {"tightest", "forearm to nozzle-dam"}};
}

TEST(PlanReport, carriesTheDocumentUnchanged) {
  const json report = smallReport();
  EXPECT_EQ(json::parse(dataBlock(renderPlanReport(report))), asPlan(report));
}

TEST(PlanReport, isOneFileWithoutNetwork) {
  const std::string page = renderPlanReport(smallReport());
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0U);
  EXPECT_EQ(page.find("/*STYLE*/"), std::string::npos);
  EXPECT_EQ(page.find("/*SCRIPT*/"), std::string::npos);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  EXPECT_FALSE(std::regex_search(page, std::regex(R"((src|href)\s*=\s*["']?(https?:)?//)")));
  EXPECT_EQ(page.find("@import"), std::string::npos);
}

TEST(PlanReport, containsTheReportsScriptAndStyle) {
  const PageSources built = builtPageSources();
  if (built.script.empty()) GTEST_SKIP() << "built without its page";
  EXPECT_LT(built.script.size(), 300'000U);
  EXPECT_LT(built.style.size(), 80'000U);
  const std::string page = renderPlanReport(json::object());
  for (const std::string part : {"Centring errors", "The tour", "The arm from the side", "Touches and residuals",
                                 "Steps inserted", "Clearance along the tour", "Row by row, to and fro",
                                 "The ranking of effects", "Probabilities over the sheet", "--case3"})
    EXPECT_GT(occurrences(page, part), 0U) << part;
}

TEST(PlanReport, withoutItsScriptSaysSoAndCarriesTheDocument) {
  const json report = smallReport();
  const std::string page = renderPage({"plan", "Plan report", "plan.json"}, report, PageSources{});
  EXPECT_EQ(occurrences(page, "This build of tubeplan has no report pictures"), 1U);
  EXPECT_EQ(json::parse(dataBlock(page)), asPlan(report));
  const std::string page_with_script =
      renderPage({"plan", "Plan report", "plan.json"}, report, PageSources{"a {}", "show();"});
  EXPECT_EQ(occurrences(page_with_script, "This build of tubeplan has no report pictures"), 0U);
  EXPECT_EQ(occurrences(page_with_script, "show();"), 1U);
  EXPECT_EQ(occurrences(page_with_script, "/*"), 0U);  // every marker is replaced
}

TEST(PlanReport, hostileTextCannotLeaveTheDataBlock) {
  const std::size_t blocks = occurrences(renderPlanReport(json::object()), "<script");
  const std::vector<std::string> hostile = {"</script><script>alert(1)</script>", "<!--<script>",    "]]>",
                                            "<img src=x onerror=alert(1)>",       "\"};alert(1);//", "&lt;/script&gt;",
                                            "\xE2\x80\xA8\xE2\x80\xA9",           "/*SCRIPT*/",      "/*REPORT*/"};
  for (const std::string& text : hostile) {
    json report = smallReport();
    report["title"] = text;
    report["sheet"]["holes"][0][4] = text;
    report["unreachable"] = {{{"row", 1}, {"column", 2}, {"reason", text}}};
    report[text] = text;
    const std::string page = renderPlanReport(report);
    EXPECT_EQ(occurrences(page, "<script"), blocks) << text;
    EXPECT_EQ(occurrences(page, "</script"), blocks) << text;
    EXPECT_EQ(json::parse(dataBlock(page)), asPlan(report)) << text;
    EXPECT_EQ(dataBlock(page).find_first_of("<>&"), std::string::npos) << text;
  }
}

TEST(PlanReport, dataIsPlainAscii) {
  json report = smallReport();
  report["title"] = "Caf\xC3\xA9 \xE2\x80\xA8 \xF0\x9F\x94\xA7";
  for (const char character : dataBlock(renderPlanReport(report))) {
    ASSERT_TRUE(character >= 0x20 && character < 0x7F) << static_cast<int>(character);
  }
}

TEST(PlanReport, brokenTextAndNumbersDoNotThrow) {
  json report = smallReport();
  report["title"] = "broken \xFF\xC3 bytes";
  report["min_clearance"] = std::numeric_limits<double>::quiet_NaN();
  report["times"] = {{"travel_time_s", std::numeric_limits<double>::infinity()}};
  const json embedded = json::parse(dataBlock(renderPlanReport(report)));
  EXPECT_TRUE(embedded["min_clearance"].is_null());
  EXPECT_TRUE(embedded["times"]["travel_time_s"].is_null());
  EXPECT_EQ(embedded["title"], "broken \xEF\xBF\xBD\xEF\xBF\xBD bytes");
}

TEST(PlanReport, anyPartMayBeMissing) {
  const json complete = smallReport();
  for (const auto& [key, value] : complete.items()) {
    json without = complete;
    without.erase(key);
    EXPECT_EQ(json::parse(dataBlock(renderPlanReport(without))), asPlan(without)) << key;
    without[key] = nullptr;
    EXPECT_EQ(json::parse(dataBlock(renderPlanReport(without))), asPlan(without)) << key;
  }
  for (const json& other : {json(), json(3), json::array({1, 2}), json("text")})
    EXPECT_EQ(json::parse(dataBlock(renderPlanReport(other))), asPlan(json::object()));
}

TEST(PlanReport, sameDocumentGivesSameBytes) {
  json other;  // the same members, added in another order
  const json report = smallReport();
  const std::vector<std::string> keys = {"units", "tubes", "title", "tightest", "sheet"};
  for (const std::string& key : keys) other[key] = report[key];
  EXPECT_EQ(renderPlanReport(report), renderPlanReport(other));
  other["title"] = "Another plan";
  EXPECT_NE(renderPlanReport(report), renderPlanReport(other));
}

}  // namespace
}  // namespace tubeplan::app
