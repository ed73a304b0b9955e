// The search of a diagnosis: every effect scored about the fit, the leaders and pairs of them fitted with the rest.
#pragma once

#include "calibration/diagnosis/hypothesis.hpp"

namespace tubeplan::calibration {

/// One set of variants with its fall of chi-square to first order.
struct Scored {
  std::vector<int> variants;
  double fall = 0;
  double criterion = 0;  ///< numbers ln n - fall
};

/// All that one diagnosis linearises about its baseline.
struct DiagnosisWork {
  DiagnosisOptions options;
  Identification baseline;
  DiagnosisBasis basis;
  Catalogue catalogue;
  ScoreSpace space;
  double log_n = 0;
};

struct Finding {
  std::vector<Explanation> fits;  ///< all that were fitted, best first
  std::vector<Explanation> good;  ///< those that are enough
};

/// The best variant of each candidate, best first.
[[nodiscard]] std::vector<Scored> bestVariants(const DiagnosisWork& work);

/// Fits of the leading singles with sizes that a machine may have, best first.
[[nodiscard]] std::vector<Explanation> plausibleSingles(const DiagnosisWork& work, const std::vector<Scored>& singles);

/// Singles first; where a pair does better by more than the gap, pairs.
[[nodiscard]] Finding findExplanations(const DiagnosisWork& work, const std::vector<Scored>& singles);

}  // namespace tubeplan::calibration
