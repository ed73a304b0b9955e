#include "app/documents/ladder_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/figures.hpp"
#include "app/documents/step_table_json.hpp"
#include "app/files/units_json.hpp"

namespace tubeplan::app {

namespace {

std::string stepsText(const std::vector<Rung>& rungs, const Units& units) {
  std::string text;
  for (const auto& rung : rungs) {
    if (!rung.steps) continue;
    text += fmt::format("{:<34}", rung.name);
    for (const int count : rung.steps->counts) text += fmt::format(" {:>9}", count);
    if (rung.steps->holes > 0)
      text += fmt::format(" {:>9.4g} {:>9.4g}", rung.steps->median_error / units.factor(dimension::kLength),
                          rung.steps->p95_error / units.factor(dimension::kLength));
    if (!rung.steps->reason.empty()) text += "  none: " + rung.steps->reason;
    if (rung.steps->no_posture > 0) text += fmt::format("  ({} of them not reached)", rung.steps->no_posture);
    text += "\n";
  }
  if (text.empty()) return "";
  return fmt::format(
             "{:<34} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}   steps of the tool that go in, by holes; centring error in "
             "{}\n",
             "model", "0 steps", "1", "2", "3", "median", "95 %", units.length().name) +
         text;
}

}  // namespace

nlohmann::json ladderJson(const std::vector<Rung>& rungs, const Units& units) {
  nlohmann::json json = {{"units", unitsJson(units)}, {"rungs", nlohmann::json::array()}};
  for (const auto& rung : rungs) {
    json["rungs"].push_back({{"name", rung.name},
                             {"fitted_numbers", rung.fitted_numbers},
                             {"rms",
                              {{"as_it_stands", lengthJson(rung.as_it_stands.rms, units)},
                               {"fitted", lengthJson(rung.fitted.rms, units)},
                               {"heldout", lengthJson(rung.heldout.rms, units)},
                               {"noise_floor", lengthJson(rung.noise_floor, units)}}},
                             {"mean",
                              {{"as_it_stands", lengthJson(rung.as_it_stands.mean, units)},
                               {"fitted", lengthJson(rung.fitted.mean, units)},
                               {"heldout", lengthJson(rung.heldout.mean, units)}}},
                             {"chi2_per_dof", rung.chi2_per_dof}});
    if (!rung.steps) continue;
    json["rungs"].back()["steps"] = stepTableJson(*rung.steps, units);
    if (!rung.steps->reason.empty()) json["rungs"].back()["no_steps"] = rung.steps->reason;
  }
  return json;
}

std::string ladderText(const std::vector<Rung>& rungs, const Units& units) {
  const auto figure = [](double value, int digits) {
    return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : std::string("none");
  };
  const auto length = [&](double metres) { return figure(metres / units.factor(dimension::kLength), 4); };
  double largest = 0;
  for (const auto& rung : rungs)
    if (std::isfinite(rung.heldout.rms)) largest = std::max(largest, rung.heldout.rms);
  std::string text = fmt::format("{:<34} {:>9} {:>9} {:>9} {:>9} {:>8}   rms in {}\n", "model", "stands", "fitted",
                                 "held out", "noise", "chi2/dof", units.length().name);
  for (const auto& rung : rungs) {
    const int bar = largest > 0 && std::isfinite(rung.heldout.rms)
                        ? static_cast<int>(std::lround(40 * rung.heldout.rms / largest))
                        : 0;
    text += fmt::format("{:<34} {:>9} {:>9} {:>9} {:>9} {:>8}   {}\n", rung.name, length(rung.as_it_stands.rms),
                        length(rung.fitted.rms), length(rung.heldout.rms), length(rung.noise_floor),
                        figure(rung.chi2_per_dof, 3), std::string(static_cast<std::size_t>(bar), '#'));
  }
  return text + stepsText(rungs, units);
}

}  // namespace tubeplan::app
