#include "app/files/assumptions.hpp"

#include <fmt/format.h>

#include "app/files/input_error.hpp"
#include "app/files/suggestion.hpp"
#include "app/studies/model/cell_fit.hpp"

namespace tubeplan::app {

namespace {

constexpr const char* kAsIs = "as-is";

std::vector<std::string> namesOfMistakes() {
  std::vector<std::string> names;
  for (const auto& kind : calibration::mistakeKinds()) names.emplace_back(kind.name);
  names.emplace_back(kAsIs);
  return names;
}

void take(const std::string& assumption, MeasurementTable& table, Cell& cell) {
  const std::size_t equals = assumption.find('=');
  const std::string name = assumption.substr(0, equals);
  const auto* kind = calibration::findMistakeKind(name);
  if (!kind || equals == std::string::npos)
    throw InputError("--assume", inQuotes(assumption), "NAME=VALUE with a NAME of " + alternatives(namesOfMistakes()),
                     kind ? fmt::format("write {}={}", name, kind->value) : suggestion(name, namesOfMistakes()));
  const calibration::CheckedReadings checked{startOf(cell, table.readings), table.readings, freeNumbersOf(cell),
                                             table.units, cell.sheet ? &*cell.sheet : nullptr};
  const auto mend = kind->mend(checked, assumption.substr(equals + 1));
  if (!mend) throw InputError("--assume " + name, inQuotes(assumption.substr(equals + 1)), kind->expected);
  mend->apply(table.readings);
  if (table.readings.empty())
    throw InputError("--assume", inQuotes(assumption), "one that keeps some readings", "leave fewer out");
  if (mend->frees_base) cell.base_known = false;
}

}  // namespace

std::string assumptionsText() {
  std::string text;
  for (const auto& kind : calibration::mistakeKinds())
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", kind.name, kind.value);
  return text;
}

bool takeAssumptions(const std::vector<std::string>& assume, MeasurementTable& table, Cell& cell) {
  bool is_overruled = false;
  for (const auto& assumption : assume)
    if (assumption == kAsIs)
      is_overruled = true;
    else
      take(assumption, table, cell);
  return is_overruled;
}

}  // namespace tubeplan::app
