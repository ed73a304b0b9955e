#include "app/documents/work_list_export.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/files/units.hpp"
#include "tubesheets/csv_table.hpp"
#include "tubesheets/length_unit.hpp"

namespace tubeplan::app {

std::string workListCsv(const PlanOutcome& outcome) {
  const auto& sheet = outcome.model.sheet;
  const auto* known = tubesheets::findLengthUnit(outcome.cell.units.length().name);
  const tubesheets::LengthUnit& unit = known ? *known : tubesheets::kInch;
  const std::string fingerprint = sheet.fingerprint();
  const auto& visits = outcome.plan.visits;
  const bool has_stays = std::any_of(visits.begin(), visits.end(), [](const auto& visit) { return visit.dwell > 0; });
  std::string text =
      fmt::format("leg,sheet,row,column,x_{0},y_{0},priority{1},comment\n", unit.suffix, has_stays ? ",dwell_s" : "");
  const auto stayAt = [&](int tube) {
    const auto own = outcome.conditions.dwell_at.find(tube);
    return formatNumber(own == outcome.conditions.dwell_at.end() ? outcome.conditions.dwell : own->second);
  };
  const auto add = [&](int index, const std::string& priority, const std::string& dwell, const std::string& comment) {
    const auto& tube = sheet.tubes[static_cast<std::size_t>(index)];
    text += fmt::format("{},{},{},{},{},{},{}{},{}\n", tubesheets::legName(sheet.leg), fingerprint, tube.row,
                        tube.column, tubesheets::formatLength(tube.x, unit), tubesheets::formatLength(tube.y, unit),
                        priority, has_stays ? "," + dwell : "", comment);
  };
  for (std::size_t k = 0; k < visits.size(); ++k)
    add(visits[k].tube, std::to_string(k + 1), formatNumber(visits[k].dwell), "");
  for (const auto& missed : outcome.plan.unreachable)
    add(missed.tube, "", stayAt(missed.tube), tubesheets::csvQuoted("unreachable: " + missed.reason));
  return text;
}

}  // namespace tubeplan::app
