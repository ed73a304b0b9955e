#include "app/documents/pattern_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/figures.hpp"
#include "calibration/patterns/variable_words.hpp"

namespace tubeplan::app {

namespace {

using calibration::PatternFrame, calibration::PatternTest, calibration::TrendStep;
using nlohmann::json;

const char* frameName(PatternFrame frame) {
  switch (frame) {
    case PatternFrame::kWorld:
      return "world";
    case PatternFrame::kRadial:
      return "radial";
    case PatternFrame::kTool:
      return "tool";
  }
  return "";
}

std::vector<std::string> componentsOf(PatternFrame frame) {
  if (frame == PatternFrame::kRadial) return {"radial", "tangential", "up"};
  return {"x", "y", "z"};
}

std::string componentText(PatternFrame frame, int component) {
  static constexpr const char* kRadial[] = {"away from the base's axis", "around the base's axis", "upwards"};
  if (frame == PatternFrame::kRadial) return kRadial[component];
  return fmt::format("along {} of the {}", "xyz"[component], frameName(frame));
}

std::string valueText(const PatternTest& test, const TrendStep& step, const Units& units) {
  if (!test.groups.empty()) return test.groups.at(static_cast<std::size_t>(std::lround(step.at)));
  const std::string name = units.nameOf(test.unit);
  return fmt::format("{:.4g}{}{}", units.toFile(step.at, test.unit), name.empty() ? "" : " ", name);
}

}  // namespace

std::string patternSentence(const PatternTest& test, const Units& units) {
  if (test.component < 0) return "";
  const std::string where = componentText(test.frame, test.component);
  const std::string chance =
      fmt::format("{:.0f} % of the error, {} over all tests", 100 * test.share, chanceText(test.p_corrected));
  const std::string verb = test.is_finding ? "follows" : "does not significantly follow";
  if (test.trend.size() == 1)
    return fmt::format("{} of the error {} the same everywhere: {} {} in addition to what the fit absorbs ({}).",
                       test.is_finding ? "A part" : "No part", test.is_finding ? "is" : "is shown to be",
                       lengthText(test.size, units, 3), where, chance);
  const auto& low = test.trend.at(static_cast<std::size_t>(test.low));
  const auto& high = test.trend.at(static_cast<std::size_t>(test.high));
  return fmt::format("The error {} {}: {} more {} at {} than at {} ({}).", verb,
                     calibration::variableWords(test.variable), lengthText(test.size, units, 3), where,
                     valueText(test, high, units), valueText(test, low, units), chance);
}

json testJson(const PatternTest& test, const Units& units) {
  json entry = {{"kind", test.kind},
                {"variable", test.variable},
                {"unit", units.nameOf(test.unit)},
                {"frame", frameName(test.frame)},
                {"components", componentsOf(test.frame)},
                {"chi2_fall", finiteJson(test.fall)},
                {"degrees_of_freedom", test.numbers},
                {"remaining_degrees_of_freedom", test.remaining_freedom},
                {"F", finiteJson(test.F)},
                {"p_value_alone", finiteJson(test.p_value)},
                {"p_value", finiteJson(test.p_corrected)},
                {"share_of_misfit", finiteJson(test.share)},
                {"size", lengthJson(test.size, units)},
                {"followed_rms", lengthJson(test.followed_rms, units)},
                {"finding", test.is_finding},
                {"sentence", patternSentence(test, units)}};
  if (test.component >= 0) entry["component"] = componentsOf(test.frame).at(static_cast<std::size_t>(test.component));
  return entry;
}

json findingJson(const PatternTest& test, const Units& units) {
  json entry = testJson(test, units);
  entry["goes_with"] = test.goes_with;
  entry["trend"] = json::array();
  for (const auto& step : test.trend) {
    json at = finiteJson(units.toFile(step.at, test.unit));
    if (!test.groups.empty()) at = valueText(test, step, units);
    entry["trend"].push_back({{"at", at}, {"error", placeJson(step.error, units)}, {"readings", step.measurements}});
  }
  return entry;
}

}  // namespace tubeplan::app
