// Two common mistakes introduced together into clean measurements, and the judgement of whether the checks name both.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "app/formats/measurements/assumptions.hpp"
#include "app/storage/input_error.hpp"
#include "calibration/measurement_checks/mistake_trials.hpp"
#include "tests/calibration/measurement_checks/seeded_mistakes.hpp"

namespace tubeplan::calibration {

struct SeededPair {
  SeededSet set;
  std::vector<Measurement> clean;
  std::vector<std::string> corrections;  ///< corrections, in the order in which the mistakes were made
  std::string label;
};

/// Returns the labels of mistakes that affect a whole table and show in its errors; any two of them may be combined.
inline const std::vector<std::string>& pairedMistakes() {
  static const std::vector<std::string> kLabels{
      "coordinates in mm",    "coordinates in m",     "radians under deg",   "one joint in radians under deg",
      "one axis mirrored",    "two axes exchanged",   "a joint's sign",      "a zero 90 deg off",
      "a zero 10-60 deg off", "two joints exchanged", "rows shifted by one", "a joint shown with another's"};
  return kLabels;
}

inline const SeededMistake& seededMistake(const std::string& label) {
  return *std::ranges::find_if(seededMistakes(), [&](const auto& mistake) { return mistake.label == label; });
}

/// Returns clean measurements with the pair of mistakes of this number; empty if the set does not allow the pair, or if
/// both mistakes are of one kind. Zeros of the last joint are excluded, because for tip positions they are equivalent
/// to a tool mounted elsewhere.
inline std::optional<SeededPair> seededPair(std::uint64_t number) {
  SeededRandom random(number * 977 + 11);
  const auto& labels = pairedMistakes();
  const auto& first = seededMistake(labels[random() % labels.size()]);
  const auto& then = seededMistake(labels[random() % labels.size()]);
  auto set = cleanSet(number);
  if (!set) return std::nullopt;
  SeededPair pair{*set, set->table.measurements, {}, std::string(first.label) + " + " + then.label};
  for (const auto* mistake : {&first, &then}) {
    const auto correction = mistake->make(pair.set, random);
    if (!correction || correction->starts_with("joint-zero=theta4")) return std::nullopt;
    pair.corrections.push_back(*correction);
  }
  const auto kind = [](const std::string& correction) { return correction.substr(0, correction.find('=')); };
  const bool are_one =
      kind(pair.corrections[0]) == kind(pair.corrections[1]) &&
      (pair.corrections[0] == pair.corrections[1] || !findMistakeKind(kind(pair.corrections[0]))->joins_itself);
  return are_one ? std::nullopt : std::optional(std::move(pair));
}

enum class PairNaming { kBoth, kAsGood, kOne, kOther, kNone };
inline constexpr const char* kPairNamings[] = {"both", "as good", "one", "another", "none"};

/// Returns the largest difference between the measurements corrected as a check proposes and the clean measurements:
/// joints [rad, modulo a turn] and positions [m]; infinite if the proposal is refused.
inline double distanceAfterCorrection(const SeededPair& pair, const std::string& assume) {
  app::MeasurementTable table = pair.set.table;
  app::Cell cell = pair.set.cell;
  try {
    (void)app::takeAssumptions({assume}, table, cell);
  } catch (const app::InputError&) {
    return std::numeric_limits<double>::infinity();
  }
  double largest = 0;
  for (const auto& m : table.measurements) {
    const auto clean = std::ranges::find(pair.clean, m.id, &Measurement::id);
    for (int j = 0; j < m.q.size(); ++j)
      largest = std::max(largest, std::abs(std::remainder(m.q[j] - clean->q[j], 2 * std::numbers::pi)));
    if (m.p_W) largest = std::max(largest, (*m.p_W - *clean->p_W).norm());
  }
  return largest;
}

/// Returns the set with its measurements corrected as a check proposes.
inline SeededSet correctedSet(const SeededPair& pair, const std::string& assume) {
  SeededSet set = pair.set;
  (void)app::takeAssumptions({assume}, set.table, set.cell);
  return set;
}

/// Returns true if the corrected measurements fit as well as the clean ones: the errors, both with the tip as drawn and
/// with all parameters free, are less than 1.5 times as large.
inline bool fitsAsClean(const SeededPair& pair, const std::string& assume) {
  SeededSet clean = pair.set;
  clean.table.measurements = pair.clean;
  const SeededSet corrected = correctedSet(pair, assume);
  const CheckOptions options;
  const auto checkedOf = [](const SeededSet& set) {
    return CheckedMeasurements{app::startOf(set.cell, set.table.measurements), set.table.measurements,
                               app::freeNumbersOf(set.cell), set.table.units,
                               set.cell.sheet ? &*set.cell.sheet : nullptr};
  };
  const CheckedMeasurements of_clean = checkedOf(clean), of_corrected = checkedOf(corrected);
  const MistakeTrials without(of_clean, options), with(of_corrected, options);
  return with.asIs().held_error < 1.5 * without.asIs().held_error &&
         with.asIs().open_error < 1.5 * without.asIs().open_error;
}

/// Judges how the checks name the two mistakes. Both: a proposal, or an equally good one, restores the clean
/// measurements to within 0.05 rad and 0.05 m. As good: a named mistake corrects the measurements to fit as well as
/// clean ones. One: a proposal contains one of the two mistakes.
inline PairNaming judgePair(const SeededPair& pair, const MeasurementChecks& checks) {
  constexpr double kSame = 0.05;
  bool is_one = false, is_any = false;
  for (const auto& check : checks.checks) {
    if (check.assume.empty()) continue;
    is_any = true;
    auto forms = check.equally;
    forms.insert(forms.begin(), check.assume);
    for (const auto& form : forms) {
      if (distanceAfterCorrection(pair, form) < kSame) return PairNaming::kBoth;
      is_one = is_one || std::ranges::any_of(pair.corrections, [&](const std::string& correction) {
                 return ("," + form + ",").find("," + correction) != std::string::npos;
               });
    }
  }
  const auto fits = [&](const MeasurementCheck& check) {
    return check.severity == CheckSeverity::kMistake && !check.assume.empty() && fitsAsClean(pair, check.assume);
  };
  if (std::ranges::any_of(checks.checks, fits)) return PairNaming::kAsGood;
  return is_one ? PairNaming::kOne : is_any ? PairNaming::kOther : PairNaming::kNone;
}

}  // namespace tubeplan::calibration
