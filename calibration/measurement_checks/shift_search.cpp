#include "calibration/measurement_checks/shift_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "calibration/measurement_checks/quick_alignment.hpp"
#include "calibration/measurement_checks/shifted_rows.hpp"

namespace tubeplan::calibration {

namespace {

constexpr std::size_t kRowsOfEnd = 12;       // measurements at either end of the table that are compared quickly
constexpr std::size_t kMostBeforeShift = 8;  // maximum number of mistakes after which a shift is searched for

/// Ends of the table that a shift from a measurement on leaves right, or that it shifts as a whole.
class TableEnds {
 public:
  explicit TableEnds(const MistakeTrials& trials)
      : trials_(trials), alignment_(trials.checked().start, trials.reach()) {}

  /// Returns the score (quick_alignment.hpp) of the end that fits best once the mistake is corrected.
  [[nodiscard]] double score(const Correction& correction) {
    auto measurements = trials_.checked().measurements;
    correction.change(measurements);
    if (measurements.size() < 2 * kRowsOfEnd) return std::numeric_limits<double>::infinity();
    const auto n = static_cast<std::ptrdiff_t>(kRowsOfEnd);
    double least = scoreOf({measurements.begin(), measurements.begin() + n}, correction);
    for (const int by : {-1, 1}) {
      std::vector<Measurement> end(measurements.end() - n, measurements.end());
      mistakes::shifted_rows::shift(by, end);
      least = std::min(least, scoreOf(end, correction));
    }
    return least;
  }

 private:
  double scoreOf(const std::vector<Measurement>& rows, const Correction& correction) {
    return alignment_.score(rows, alignment_.tips(rows), {.frees_base = correction.frees_base});
  }

  const MistakeTrials& trials_;
  QuickAlignment alignment_;
};

/// Returns the mistakes of the whole table that correct one of its ends best.
std::vector<Correction> correctingAnEnd(const MistakeTrials& trials) {
  TableEnds ends(trials);
  std::vector<std::pair<double, Correction>> scored;
  for (const auto& kind : mistakeKinds()) {
    if (kind.is_of_turns) continue;
    for (const auto& value : (kind.values_with_others ? kind.values_with_others : kind.values)(trials.checked())) {
      throwIfStopped(trials.options().stop);
      auto correction = kind.correction(trials.checked(), value);
      if (!correction || correction->parts_setups || correction->is_of_part ||
          correction->mistake == mistakes::shifted_rows::kind().name)
        continue;
      if (const double score = ends.score(*correction); std::isfinite(score))
        scored.emplace_back(score, std::move(*correction));
    }
  }
  std::ranges::stable_sort(scored, {}, &std::pair<double, Correction>::first);
  std::vector<Correction> best;
  for (auto& [score, correction] : scored)
    if (best.size() < kMostBeforeShift) best.push_back(std::move(correction));
  return best;
}

}  // namespace

std::vector<JoinedCorrections> likelyRowShifts(const MistakeTrials& trials) {
  const MistakeKind shift = mistakes::shifted_rows::kind();
  std::vector<JoinedCorrections> likely;
  for (const Correction& correction : correctingAnEnd(trials)) {
    throwIfStopped(trials.options().stop);
    CheckedMeasurements corrected = trials.checked();
    correction.change(corrected.measurements);
    corrected.start = trials.startOf(correction);
    for (const auto& value : shift.values(corrected))
      if (auto first = shift.correction(trials.checked(), value); first && first->is_of_part)
        likely.push_back({std::move(*first), correction});
  }
  return likely;
}

}  // namespace tubeplan::calibration
