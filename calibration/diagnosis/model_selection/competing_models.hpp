// Models that compete to explain the measurements: nothing missing, each single cause, several causes together. Each
// may include an unknown discrepancy and a larger noise than stated. The leading models are selected by their evidence
// about a single linearisation. The evidence of each leading model is then computed about a separate fit.
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

/// Cause in a model, at a level of its scanned parameter and with some of its other parameters.
struct ModelTerm {
  int cause = -1;
  int level = 0;
  std::vector<int> numbers;  ///< indices into the parameters of the cause

  bool operator==(const ModelTerm&) const = default;
};

/// Hypothesis that a term of a model is not a cause, but only resembles an unknown effect.
struct Likeness {
  std::size_t term = 0;
  double log_weight = 0;  ///< log(prior x evidence)
};

struct CompetingModel {
  std::vector<ModelTerm> terms;  ///< causes of the model; empty means that no known cause is missing
  double log_share = 0;          ///< log of the fraction of the causes' prior probability that goes to these terms
  double log_prior = 0;
  double log_evidence = 0;             ///< log evidence, summed over noise assumptions and discrepancies
  double discrepancy_probability = 0;  ///< probability that an unknown effect is missing as well
  double discrepancy = 0;              ///< most probable root-mean-square size of the discrepancy [m]; 0 if none
  std::size_t level = 0;               ///< index of `discrepancy` among the tried sizes
  double model_error = 0;              ///< most probable error of each coordinate beyond the stated noise [m]
  double more_noise_probability = 0;   ///< probability that the noise is larger than stated
  double scatter_probability = 0;      ///< probability that the noise is larger than stated and there is no discrepancy
  /// Values of the terms' parameters, concatenated, and their standard deviations, in units of Unknown::typical.
  Eigen::VectorXd sizes, sigma;
  SourceEvidence source;  ///< source of the discrepancy if a single source is most probable
  /// Most probable whitened errors due to the discrepancy, for a fitted model; empty if none.
  Eigen::VectorXd remainder;
  Eigen::VectorXd remainder_left;   ///< component of `remainder` that the fitted parameters do not absorb
  Eigen::VectorXd remainder_terms;  ///< weights of the process's terms in `remainder`
  /// For a fit with a discrepancy: for each term, the hypothesis that it only resembles an unknown effect.
  std::vector<Likeness> likenesses;
  Explanation fit;  ///< fit of a leading model together with all free parameters
  bool is_fitted = false;
  double gain_by_fit = 0;  ///< log evidence about the fit minus log evidence about the baseline's linearisation

  [[nodiscard]] double logWeight() const { return log_prior + log_evidence; }
  /// Returns true if the model was fitted successfully. A model without a fit provides no explanation.
  [[nodiscard]] bool hasFit() const { return is_fitted && std::isfinite(log_evidence); }
};

/// Returns the log prior probability that exactly this number of causes is missing.
[[nodiscard]] double logPriorOfCount(std::size_t causes);

/// Returns the indices of the causes of these terms, ascending.
[[nodiscard]] std::vector<int> causesOf(const std::vector<ModelTerm>& terms);

/// Noise assumption, with all data needed for evidence under this assumption.
struct NoiseHypothesis {
  double model_error = 0;  ///< error of each coordinate beyond the stated noise [m]; 0 means the stated noise
  double log_prior = 0;
  MeasurementWeights weights;
  Eigen::MatrixXd principal_terms;  ///< principal terms of the discrepancy (terms x principal terms)
  Eigen::MatrixXd discrepancy;      ///< whitened columns of the principal terms, with the rows of `weights`
  /// Discrepancies with a single source each; null for very many measurements, because the discrepancy with all terms
  /// then discriminates equally well.
  std::unique_ptr<SingleSources> sources;
  EvidenceOptions options;
  std::unique_ptr<LinearEvidence> evidence;
};

/// Working data of one diagnosis, linearised about its baseline.
struct DiagnosisWork {
  const DiagnosisOptions& options;
  FittedBasis basis;
  CauseList causes;
  std::unique_ptr<Signatures> signatures;
  std::unique_ptr<Discrepancy> discrepancy;
  Eigen::MatrixXf kept_signatures;  ///< causes' columns at all measurements for the stated noise; empty if too large
  /// Noise assumptions: the stated noise first, then a larger noise if the measurements suggest it.
  std::vector<NoiseHypothesis> noise;
  std::vector<CompetingModel> models;  ///< competing models, most probable first

  [[nodiscard]] const Cause& cause(int index) const { return causes.causes[static_cast<std::size_t>(index)]; }
};

/// Returns the model with nothing missing; compareModels() must have been called.
[[nodiscard]] const CompetingModel& modelOfNothing(const DiagnosisWork& work);

/// Returns the index in `work.noise` of the model's most probable noise assumption.
[[nodiscard]] std::size_t likelyNoise(const DiagnosisWork& work, const CompetingModel& model);

/// Sorts models by weight, most probable first; models of equal weight keep their order.
void sortByWeight(std::vector<CompetingModel>& models);

}  // namespace tubeplan::calibration
