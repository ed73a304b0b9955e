#include "app/formats/measurements/assumptions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "app/studies/model/cell_fit.hpp"

namespace tubeplan::app {

namespace {

std::vector<std::string> namesOfMistakes() {
  std::vector<std::string> names;
  for (const auto& kind : calibration::mistakeKinds()) names.emplace_back(kind.name);
  names.emplace_back(kAsIs);
  return names;
}

const calibration::MistakeKind* mistakeOf(const std::string& assumption) {
  return calibration::findMistakeKind(assumption.substr(0, assumption.find('=')));
}

/// Applies one assumption to the measurements and the cell; `is_sigma_settled` is true if another assumption states the
/// noise.
void take(const std::string& assumption, bool is_sigma_settled, MeasurementTable& table, Cell& cell) {
  const std::size_t equals = assumption.find('=');
  const std::string name = assumption.substr(0, equals);
  const auto* kind = mistakeOf(assumption);
  if (!kind || equals == std::string::npos)
    throw InputError("--assume", inQuotes(assumption), "NAME=VALUE, where NAME is " + alternatives(namesOfMistakes()),
                     kind ? fmt::format("write {}={}", name, kind->value) : suggestion(name, namesOfMistakes()));
  const calibration::CheckedMeasurements checked{startOf(cell, table.measurements), table.measurements,
                                                 freeNumbersOf(cell), table.units, cell.sheet ? &*cell.sheet : nullptr};
  auto correction = kind->correction(checked, assumption.substr(equals + 1));
  if (!correction) throw InputError("--assume " + name, inQuotes(assumption.substr(equals + 1)), kind->expected);
  if (is_sigma_settled && !kind->settles_sigma) correction->change_sigma = nullptr;
  correction->apply(table.measurements);
  if (table.measurements.empty())
    throw InputError::problem("--assume", inQuotes(assumption) + " leaves no readings", "leave out fewer readings");
  if (correction->frees_base) cell.base_known = false;
}

/// Returns the subject of an assumption. Assumptions about the same subject exclude each other. For an assumption about
/// a unit, the subject is the text before the unit. For other kinds it includes the value, because several values may
/// apply at once.
std::string subjectOf(const std::string& assumption) {
  const std::size_t equals = assumption.find('=');
  const auto* kind = mistakeOf(assumption);
  if (!kind || !std::string_view(kind->value).ends_with("UNIT")) return assumption;
  const std::size_t colon = assumption.find(':', equals);
  return assumption.substr(0, colon == std::string::npos ? equals : colon);
}

/// Returns the assumptions that apply: the last assumption about each subject.
std::vector<std::string> inForce(const std::vector<std::string>& assume) {
  std::vector<std::string> kept;
  for (const auto& text : assume)
    for (const auto& assumption : calibration::partedAssumptions(text)) {
      std::erase_if(kept, [&](const auto& earlier) { return subjectOf(earlier) == subjectOf(assumption); });
      kept.push_back(assumption);
    }
  return kept;
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
  const auto in_force = inForce(assume);
  const bool is_sigma_settled = std::ranges::any_of(in_force, [](const auto& assumption) {
    const auto* kind = mistakeOf(assumption);
    return kind && kind->settles_sigma;
  });
  for (const auto& assumption : in_force)
    if (assumption == kAsIs)
      is_overruled = true;
    else
      take(assumption, is_sigma_settled, table, cell);
  return is_overruled;
}

}  // namespace tubeplan::app
