// Which effect a model lacks: named where the readings can tell it, and said so where they cannot.
//
// One linearisation scores every effect at every place (score_space.hpp); the leaders are fitted with the rest of the
// model; the misfit that remains says whether any of them is enough; those the readings cannot tell apart are named
// together (detection, identification, adaptation: Teunissen 2018).
#pragma once

#include <string>
#include <vector>

#include "calibration/diagnosis/diagnosis_views.hpp"
#include "calibration/diagnosis/score_space.hpp"
#include "calibration/identification.hpp"

namespace tubeplan::calibration {

struct DiagnosisOptions {
  IdentificationOptions baseline;  ///< what is free beside the effect
  CatalogueOptions catalogue;
  double false_alarm = 0.04;  ///< chance of naming anything where nothing is missing, by the best candidate
  double hint = 0.12;         ///< chance of calling readings inconclusive, or worse, where nothing is missing
  double misfit = 0.003;      ///< the same by what remains, over all readings or smooth in the joints
  double lack_of_fit = 0.01;  ///< chance of refusing a model that is right
  double gap = 8;             ///< in the information criterion: models within it cannot be told apart
  int leaders = 5;            ///< candidates that are fitted, at least
  int most_effects = 2;
  int draws = 2000;  ///< of noise, for the best of the catalogue
  int folds = 5;
  std::uint64_t seed = 1;
  WorkHooks hooks;  ///< of the baseline too
};

enum class Verdict { kNotRun, kAdequate, kExplained, kAmbiguous, kUnexplained, kInconclusive, kStopped };

struct FoundNumber {
  std::string name;
  deflection::Quantity quantity = deflection::Quantity::kNone;
  double value = 0;
  double sigma = std::numeric_limits<double>::quiet_NaN();  ///< NaN for a shape that was scanned
};

struct FoundEffect {
  std::string effect, at;
  deflection::Effect fitted;
  std::vector<FoundNumber> numbers;
};

/// A model with one effect or more, fitted with everything that is free.
struct Explanation {
  std::vector<FoundEffect> effects;
  PlacedArm fitted;
  double chi2 = std::numeric_limits<double>::quiet_NaN();
  double criterion = std::numeric_limits<double>::quiet_NaN();       ///< chi2 + numbers ln n (BIC)
  double p_value = std::numeric_limits<double>::quiet_NaN();         ///< of the misfit that remains, over all readings
  double smooth_p_value = std::numeric_limits<double>::quiet_NaN();  ///< the same of what follows the joints smoothly
  ErrorSize after, heldout;
  bool is_near_best = false;  ///< of models none of which is enough: this one does as well as the best
};

/// One effect at one place as the readings see it.
struct RankedEffect {
  std::string effect, at;
  double probability = 0;
  double p_value = 1;        ///< of its fall of chi-square by noise, alone
  double fall = 0;           ///< of chi-square, to first order or as fitted
  FoundNumber size;          ///< its first or largest size
  double kept_fraction = 0;  ///< of its signature that the free numbers do not absorb
  double correlation = 0;    ///< of its signature with the leader's
  ErrorSize heldout_before, heldout_after;
};

/// The least size of an effect that these readings would show (in four of five cases).
struct DetectableEffect {
  std::string effect, at, number;
  deflection::Quantity quantity = deflection::Quantity::kNone;
  double size = 0;
  bool is_beyond_plausible = false;  ///< no machine has one that large: the readings cannot show it
};

struct Diagnosis {
  Verdict verdict = Verdict::kNotRun;
  std::string reason;                     ///< why not run; else what decided
  Identification baseline;                ///< the model as it is, with what is free fitted
  std::vector<Explanation> alternatives;  ///< as the verdict says
  std::vector<Explanation> closest;       ///< best models where none is enough, best first
  std::vector<RankedEffect> ranking;
  std::vector<DetectableEffect> detectable;
  std::vector<std::string> not_tried;
  std::vector<int> set_aside;  ///< readings left out as outliers
  ErrorSize before, after, heldout_before, heldout_after;
  double noise_floor = std::numeric_limits<double>::quiet_NaN();
  double chi2 = 0, p_value = 1;  ///< of the baseline
  double smooth_p_value = 1;     ///< of what of it follows the joints smoothly
  int degrees_of_freedom = 0;
  double evidence = 0, threshold = 0;  ///< of the best candidate, and what noise alone reaches: -log10 p
  double hint_threshold = 0;           ///< what it reaches more often: below it nothing is hinted at
  DiagnosisViews views;
};

[[nodiscard]] Diagnosis diagnose(const PlacedArm& start, const std::vector<Measurement>& readings,
                                 const DiagnosisOptions& options);

/// The leading single effects, each fitted with everything that is free and of a plausible size, best first by the
/// criterion; without verdict, pairs or judgement on readings kept out. Empty where the model cannot be fitted, or
/// where it was asked to stop.
[[nodiscard]] std::vector<Explanation> explainBySingles(const PlacedArm& start,
                                                        const std::vector<Measurement>& readings,
                                                        const DiagnosisOptions& options);

}  // namespace tubeplan::calibration
