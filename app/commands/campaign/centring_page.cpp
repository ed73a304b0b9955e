#include "app/commands/campaign/centring_figures.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/sheet_json.hpp"
#include "app/report/campaign_report.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

// Maximum number of marks in all maps together, which limits the page to a few megabytes.
constexpr std::size_t kMostMarks = 60'000;

json holeJson(const CentringResults& results, std::size_t index, const HoleTally& hole) {
  const auto& plan = results.task.holes.visited[index];
  const auto& sheet = results.task.model.sheet;
  const auto& tube = sheet.tubes[static_cast<std::size_t>(results.trials.tubeOfHole(index))];
  const Units& units = results.task.cell.units;
  json chances = json::array();
  for (const auto count : hole.at_least) {
    const Probability p = wilsonInterval(static_cast<double>(count), static_cast<double>(hole.errors.count()));
    chances.push_back({finiteJson(p.value), finiteJson(p.low), finiteJson(p.high)});
  }
  return {tube.row,
          tube.column,
          lengthJson(plan.p_WH.x(), units),
          lengthJson(plan.p_WH.y(), units),
          hole.errors.count(),
          lengthJson(hole.errors.mean(), units),
          chances};
}

json mapsJson(const CentringResults& results) {
  json maps = json::array();
  std::size_t marks = 0;
  for (std::size_t s = 0; s < results.task.options.settings.size(); ++s)
    for (std::size_t w = 0; w < kWays.size(); ++w) {
      const auto& holes = results.tally.settings()[s].ways[w].holes;
      if ((marks += holes.size()) > kMostMarks) return maps;
      json list = json::array();
      for (std::size_t k = 0; k < holes.size(); ++k)
        if (holes[k].errors.count() > 0) list.push_back(holeJson(results, k, holes[k]));
      maps.push_back({{"setting", s}, {"way", kWays[w]}, {"holes", list}});
    }
  return maps;
}

}  // namespace

std::string centringPage(const CentringResults& results, const json& figures) {
  json page = figures;
  page["title"] = "Centring of " + results.task.cell.name + " over random true arms";
  page["sheet"] = sheetPageJson(results.task.model.sheet, results.task.cell);
  page["maps"] = mapsJson(results);
  return renderCampaignReport(page);
}

}  // namespace tubeplan::app
