#include "app/documents/work_list_export.hpp"

#include <fmt/format.h>

#include "tubesheets/csv_table.hpp"
#include "tubesheets/length_unit.hpp"

namespace tubeplan::app {

std::string workListCsv(const PlanOutcome& outcome) {
  const auto& sheet = outcome.model.sheet;
  const auto* known = tubesheets::findLengthUnit(outcome.cell.units.length().name);
  const tubesheets::LengthUnit& unit = known ? *known : tubesheets::kInch;
  const std::string fingerprint = sheet.fingerprint();
  std::string text = fmt::format("leg,sheet,row,column,x_{0},y_{0},priority,comment\n", unit.suffix);
  const auto add = [&](int index, const std::string& priority, const std::string& comment) {
    const auto& tube = sheet.tubes[static_cast<std::size_t>(index)];
    text +=
        fmt::format("{},{},{},{},{},{},{},{}\n", tubesheets::legName(sheet.leg), fingerprint, tube.row, tube.column,
                    tubesheets::formatLength(tube.x, unit), tubesheets::formatLength(tube.y, unit), priority, comment);
  };
  for (std::size_t k = 0; k < outcome.plan.visits.size(); ++k)
    add(outcome.plan.visits[k].tube, std::to_string(k + 1), "");
  for (const auto& missed : outcome.plan.unreachable)
    add(missed.tube, "", tubesheets::csvQuoted("unreachable: " + missed.reason));
  return text;
}

}  // namespace tubeplan::app
