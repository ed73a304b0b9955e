#include "app/documents/model_comparison_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/figures.hpp"
#include "app/documents/step_table_json.hpp"
#include "app/files/units_json.hpp"

namespace tubeplan::app {

namespace {

std::string stepsHeading(std::size_t counts, const Units& units) {
  std::string text = fmt::format("{:<34}", "model");
  for (std::size_t k = 0; k < counts; ++k) text += fmt::format(" {:>9}", k == 0 ? "0 steps" : std::to_string(k));
  return text + fmt::format(" {:>9} {:>9}   holes by number of inserted steps; centring error in {}\n", "median", "95 %",
                            units.length().name);
}

std::string stepsText(const std::vector<ModelComparisonRow>& comparison, const Units& units) {
  std::string text;
  std::size_t counts = 0;
  for (const auto& compared : comparison) {
    if (!compared.steps) continue;
    counts = std::max(counts, compared.steps->counts.size());
    text += fmt::format("{:<34}", compared.name);
    for (const int count : compared.steps->counts) text += fmt::format(" {:>9}", count);
    if (compared.steps->holes > 0)
      text += fmt::format(" {:>9.4g} {:>9.4g}", compared.steps->median_error / units.factor(dimension::kLength),
                          compared.steps->p95_error / units.factor(dimension::kLength));
    if (!compared.steps->reason.empty()) text += "  none: " + compared.steps->reason;
    if (compared.steps->no_posture > 0) text += fmt::format("  ({} of them not reached)", compared.steps->no_posture);
    text += "\n";
  }
  return text.empty() ? "" : stepsHeading(counts, units) + text;
}

}  // namespace

nlohmann::json modelComparisonJson(const std::vector<ModelComparisonRow>& comparison, const Units& units) {
  nlohmann::json json = {{"units", unitsJson(units)}, {"models", nlohmann::json::array()}};
  for (const auto& compared : comparison) {
    json["models"].push_back({{"name", compared.name},
                              {"fitted_numbers", compared.fitted_numbers},
                              {"rms",
                               {{"as_it_stands", lengthJson(compared.as_it_stands.rms, units)},
                                {"fitted", lengthJson(compared.fitted.rms, units)},
                                {"heldout", lengthJson(compared.heldout.rms, units)},
                                {"noise_floor", lengthJson(compared.noise_floor, units)}}},
                              {"mean",
                               {{"as_it_stands", lengthJson(compared.as_it_stands.mean, units)},
                                {"fitted", lengthJson(compared.fitted.mean, units)},
                                {"heldout", lengthJson(compared.heldout.mean, units)}}},
                              {"worst",
                               {{"as_it_stands", lengthJson(compared.as_it_stands.max, units)},
                                {"fitted", lengthJson(compared.fitted.max, units)},
                                {"heldout", lengthJson(compared.heldout.max, units)}}},
                              {"chi2_per_dof", compared.chi2_per_dof},
                              {"p_value", finiteJson(compared.p_value)}});
    if (!compared.steps) continue;
    json["models"].back()["steps"] = stepTableJson(*compared.steps, units);
    if (!compared.steps->reason.empty()) json["models"].back()["no_steps"] = compared.steps->reason;
  }
  return json;
}

std::string modelComparisonText(const std::vector<ModelComparisonRow>& comparison, const Units& units) {
  const auto figure = [](double value, int digits) {
    return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : std::string("none");
  };
  const auto length = [&](double metres) { return figure(metres / units.factor(dimension::kLength), 4); };
  double largest = 0;
  for (const auto& compared : comparison)
    if (std::isfinite(compared.heldout.rms)) largest = std::max(largest, compared.heldout.rms);
  std::string text = fmt::format("{:<34} {:>9} {:>9} {:>9} {:>9} {:>8}   rms, {}\n", "model", "stands", "fitted",
                                 "held out", "noise", "chi2/dof", units.length().name);
  for (const auto& compared : comparison) {
    const int bar = largest > 0 && std::isfinite(compared.heldout.rms)
                        ? static_cast<int>(std::lround(40 * compared.heldout.rms / largest))
                        : 0;
    text += fmt::format("{:<34} {:>9} {:>9} {:>9} {:>9} {:>8}   {}\n", compared.name, length(compared.as_it_stands.rms),
                        length(compared.fitted.rms), length(compared.heldout.rms), length(compared.noise_floor),
                        figure(compared.chi2_per_dof, 3), std::string(static_cast<std::size_t>(bar), '#'));
  }
  return text + stepsText(comparison, units);
}

}  // namespace tubeplan::app
