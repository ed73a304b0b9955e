// Models that compete to explain the readings: nothing missing, each cause, several together; each with or without an
// unknown discrepancy, with the stated noise or more. Their evidence about one linearisation selects the leaders. The
// evidence of a leader is then computed about a separate fit.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "calibration/diagnosis/causes/signatures.hpp"
#include "calibration/diagnosis/discrepancy/discrepancy.hpp"
#include "calibration/diagnosis/evidence/linear_evidence.hpp"
#include "calibration/diagnosis/evidence/single_source.hpp"
#include "calibration/diagnosis/explanations/explanation_model.hpp"
#include "calibration/diagnosis/model_selection/diagnosis_options.hpp"

namespace tubeplan::calibration {

/// Cause in a model: at a level of its shape, with some of its numbers.
struct ModelTerm {
  int cause = -1;
  int level = 0;
  std::vector<int> numbers;  ///< indices into the cause's numbers

  bool operator==(const ModelTerm&) const = default;
};

/// Hypothesis that a model's term is no cause but partly similar to an unknown effect.
struct Likeness {
  std::size_t term = 0;
  double log_weight = 0;  ///< log of prior times evidence
};

struct CompetingModel {
  std::vector<ModelTerm> terms;  ///< none: nothing named is missing
  double log_share = 0;          ///< log share of the terms among all variants of their causes; part of the prior
  double log_prior = 0;
  double log_evidence = 0;             ///< over noise and discrepancy
  double discrepancy_probability = 0;  ///< probability that something unnamed is missing as well
  double discrepancy = 0;              ///< most probable size of the discrepancy [m]
  std::size_t level = 0;               ///< index of that size among those tried
  double model_error = 0;              ///< most probable error of each coordinate beyond the stated noise [m]
  double more_noise_probability = 0;   ///< probability that the noise is larger than stated
  double scatter_probability = 0;      ///< probability that the noise is larger than stated, without a discrepancy
  /// Sizes of the terms' numbers, one after another, and their standard deviations [units].
  Eigen::VectorXd sizes, sigma;
  SourceEvidence source;             ///< source of the discrepancy if a single one is most probable
  Eigen::VectorXd remainder;         ///< most probable whitened errors of the discrepancy, of a fit; empty: none
  Eigen::VectorXd remainder_left;    ///< part of `remainder` that the fitted numbers do not absorb
  Eigen::VectorXd remainder_terms;   ///< weights of the process's terms in `remainder`
  std::vector<Likeness> likenesses;  ///< similarity of each term to an unknown effect, of a fit with a remainder
  Explanation fit;                   ///< fit of a leader with everything that is free
  bool is_fitted = false;
  double gain_by_fit = 0;  ///< log evidence of the fit minus that of the linearisation about the baseline

  [[nodiscard]] double logWeight() const { return log_prior + log_evidence; }
  /// Returns true if a fit was found; a model without one explains nothing.
  [[nodiscard]] bool hasFit() const { return is_fitted && std::isfinite(log_evidence); }
};

/// Returns the log prior probability that so many causes are missing.
[[nodiscard]] double logPriorOfCount(std::size_t causes);

/// Returns the indices of the terms' causes, ascending.
[[nodiscard]] std::vector<int> causesOf(const std::vector<ModelTerm>& terms);

/// Noise assumption, with all evidence under it.
struct NoiseHypothesis {
  double model_error = 0;  ///< error of each coordinate beyond the stated noise [m]
  double log_prior = 0;
  ReadingWeights weights;
  Eigen::MatrixXd principal_terms;  ///< principal terms of the discrepancy (terms x principal terms)
  Eigen::MatrixXd discrepancy;      ///< whitened columns of the principal terms, rows of `weights`
  /// Discrepancies of one source each; null for very many readings, for which all terms together distinguish as well.
  std::unique_ptr<SingleSources> sources;
  EvidenceOptions options;
  std::unique_ptr<LinearEvidence> evidence;
};

/// All linearisations of one diagnosis about its baseline.
struct DiagnosisWork {
  const DiagnosisOptions& options;
  FittedBasis basis;
  CauseList causes;
  std::unique_ptr<Signatures> signatures;
  std::unique_ptr<Discrepancy> discrepancy;
  Eigen::MatrixXf kept_signatures;  ///< columns of all readings for the stated noise; empty if too many
  /// Noise assumptions, the stated one first; another one if the readings suggest it.
  std::vector<NoiseHypothesis> noise;
  std::vector<CompetingModel> models;  ///< most probable first

  [[nodiscard]] const Cause& cause(int index) const { return causes.causes[static_cast<std::size_t>(index)]; }
};

/// Returns the model that nothing is missing; `work.models` must be compared.
[[nodiscard]] const CompetingModel& modelOfNothing(const DiagnosisWork& work);

/// Returns the index in `work.noise` of the model's most probable noise assumption.
[[nodiscard]] std::size_t likelyNoise(const DiagnosisWork& work, const CompetingModel& model);

/// Sorts by weight, most probable first; equal ones keep their order.
void sortByWeight(std::vector<CompetingModel>& models);

}  // namespace tubeplan::calibration
