// Which physical effect a model lacks: named where the readings show it, and said so where they cannot.
//
// One idea: every hypothesis (nothing missing; a cause at its place; several; each with an unknown remainder or
// without; the unknown alone) has a prior and an evidence, the probability of the readings with its numbers integrated
// over their priors (Laplace's approximation about a fit of its own). The posterior decides the verdict (Bayesian model
// class selection: Beck and Yuen 2004, J. Eng. Mech. 130:192).
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calibration/diagnosis/causes/cause.hpp"
#include "calibration/diagnosis/judgement/diagnosis_views.hpp"
#include "calibration/diagnosis/judgement/verdict.hpp"
#include "calibration/estimation/identification.hpp"
#include "calibration/estimation/repeats.hpp"

namespace tubeplan::calibration {

struct DiagnosisOptions {
  IdentificationOptions baseline;  ///< what is free beside the causes
  CauseOptions causes;
  double sure = 0.9;      ///< probability from which a cause, or a set of alternatives, is named
  double likely = 0.7;    ///< ... from which alternatives are, beside that something unknown is missing
  double nothing = 0.5;   ///< probability of nothing missing from which the model is adequate
  int most_causes = 3;    ///< in one explanation
  int most_leaders = 14;  ///< models that are fitted
  int folds = 5;
  std::uint64_t seed = 1;  ///< of the folds, and of the postures at which causes are held to be the same
  WorkHooks hooks;         ///< of the baseline too
};

struct FoundNumber {
  std::string name;
  deflection::Quantity quantity = deflection::Quantity::kNone;
  double value = 0;
  double sigma = std::numeric_limits<double>::quiet_NaN();  ///< NaN for a shape that was scanned
  bool is_beyond_usual = false;                             ///< larger than real machines have, by more than its doubt
  /// The range of a size that the readings leave open, over all sizes that explain them; else not numbers.
  double lower = std::numeric_limits<double>::quiet_NaN(), upper = std::numeric_limits<double>::quiet_NaN();
};

struct FoundEffect {
  std::string effect, at;
  deflection::Effect fitted;       ///< kind -1 of freed numbers
  std::vector<std::string> frees;  ///< numbers of the arm's file that are freed instead of an effect
  std::vector<FoundNumber> numbers;
  std::vector<std::pair<std::string, std::string>>
      also;  ///< effect and place of others that no reading could distinguish from it
  /// Values of its numbers with which the readings are explained as well, the found ones first; empty where only these
  /// do.
  std::vector<std::vector<double>> modes;
  std::vector<MeasurementKind> decided_by;  ///< of which one reading would tell those apart
};

/// A model with causes added, fitted with everything that is free.
struct Explanation {
  std::vector<FoundEffect> effects;
  PlacedArm fitted;
  double probability = 0;  ///< of these causes and no others, with a remainder or without
  double chi2 = std::numeric_limits<double>::quiet_NaN();       ///< by the stated noise
  double p_value = std::numeric_limits<double>::quiet_NaN();    ///< of it
  double criterion = std::numeric_limits<double>::quiet_NaN();  ///< -2 log of prior times evidence: differences count
  double remainder_probability = 0;                             ///< that something unnamed is missing beside
  double model_error = 0;  ///< m, in each coordinate beyond the stated noise, that no function of the readings follows
  ErrorSize after, heldout;
  ErrorSize farthest;  ///< of the quarter of the poses that reach farthest, by a fit to the others
  double apart = std::numeric_limits<double>::quiet_NaN();  ///< m, rms over the arm's range, from the first alternative
};

/// One cause as the readings see it.
struct RankedEffect {
  std::string effect, at;
  std::vector<deflection::Effect> effects;  ///< as most probable, alone; none of numbers that are freed instead
  double probability = 0;                   ///< of all models that it is part of
  double p_value = 1;                       ///< of its fall of chi-square by noise, alone
  double fall = 0;                          ///< of chi-square, to first order or as fitted
  FoundNumber size;                         ///< its first or largest number
  double kept_fraction = 0;                 ///< of its signature that the free numbers do not absorb
  ErrorSize heldout_before, heldout_after;
};

/// The least size of an effect that these readings would show (in four of five cases).
struct DetectableEffect {
  std::string effect, at, number;
  deflection::Quantity quantity = deflection::Quantity::kNone;
  double size = 0;
  bool is_beyond_plausible = false;  ///< no machine has one that large: the readings cannot show it
};

/// What is left once the sure causes are in.
struct Remainder {
  double probability = 0;                                   ///< that there is one
  double size = std::numeric_limits<double>::quiet_NaN();   ///< m, root mean square over the readings
  double floor = std::numeric_limits<double>::quiet_NaN();  ///< m, the same of noise and what follows nothing
  std::vector<std::pair<std::string, double>> follows;      ///< what it follows, and its share of it; largest first
};

struct Diagnosis {
  Verdict verdict = Verdict::kNotRun;
  std::string reason;                     ///< why not run, or why no verdict is possible; what would be needed
  Identification baseline;                ///< the model as it is, with what is free fitted
  std::vector<Explanation> alternatives;  ///< as the verdict says, most probable first
  std::optional<Explanation> agreed;      ///< ambiguous: the causes that are sure, where the alternatives add to them
  std::vector<Explanation> closest;       ///< the most probable models that were fitted, whatever the verdict
  std::vector<RankedEffect> ranking;
  std::vector<DetectableEffect> detectable;
  std::vector<std::string> not_tried;
  std::vector<int> set_aside;  ///< readings left out as outliers
  Remainder remainder;
  Repeats repeats;  ///< where their scatter, larger than stated, is all that is left: it counts as noise
  ErrorSize before, after, heldout_before, heldout_after, farthest_before;
  double noise_floor = std::numeric_limits<double>::quiet_NaN();  ///< rms that the stated noise leaves [m]
  double model_error = 0;  ///< m, in each coordinate beyond the stated noise, that no function of the readings follows
  double chi2 = 0;         ///< of the baseline, by the stated noise
  double p_value = std::numeric_limits<double>::quiet_NaN();
  int degrees_of_freedom = 0;
  double nothing_probability = std::numeric_limits<double>::quiet_NaN();  ///< that nothing is missing
  double nothing_criterion = std::numeric_limits<double>::quiet_NaN();    ///< Explanation::criterion of nothing missing
  double unknown_probability =
      std::numeric_limits<double>::quiet_NaN();  ///< that something is, and no cause is part of it
  double scatter_probability =
      std::numeric_limits<double>::quiet_NaN();  ///< the same, and it follows nothing that the readings state
  DiagnosisViews views;

  /// Whether what is missing follows nothing that the readings state: a larger noise than stated would be the same.
  [[nodiscard]] bool isScatterAlone() const {
    return verdict == Verdict::kUnexplained && scatter_probability > 0.5 && remainder.follows.empty();
  }
};

[[nodiscard]] Diagnosis diagnose(const PlacedArm& start, const std::vector<Measurement>& readings,
                                 const DiagnosisOptions& options);

/// Models that compete, each fitted with everything that is free; without a verdict.
struct CompetingExplanations {
  std::vector<Explanation> found;  ///< those that the search fitted, nothing missing among them; most probable first
  std::vector<Explanation> asked;  ///< as asked for, in that order; without effects where one cannot be fitted
};

/// Each model asked for is a list of effects; where their values are not neutral the fit is begun at these too, and the
/// more probable end is taken. Nothing is found where the model cannot be fitted, or where it was asked to stop.
[[nodiscard]] CompetingExplanations competingExplanations(const PlacedArm& start,
                                                          const std::vector<Measurement>& readings,
                                                          const DiagnosisOptions& options,
                                                          const std::vector<std::vector<deflection::Effect>>& asked);

}  // namespace tubeplan::calibration
