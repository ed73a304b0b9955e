// Models that compete to explain the readings: nothing missing, each cause, several together; each with or without an
// unknown discrepancy, with the stated noise or more. Their evidence about one linearisation finds the leaders, whose
// evidence is then taken about a fit of their own.
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

/// A cause as a model has it: at a level of its shape, with some of its numbers.
struct ModelTerm {
  int cause = -1;
  int level = 0;
  std::vector<int> numbers;  ///< indices into the cause's numbers

  bool operator==(const ModelTerm&) const = default;
};

/// That one of a model's terms is no cause: what else is unknown resembles it in part.
struct Likeness {
  std::size_t term = 0;
  double log_weight = 0;  ///< prior times evidence
};

struct CompetingModel {
  std::vector<ModelTerm> terms;  ///< none: nothing named is missing
  double log_share = 0;          ///< of the terms among all ways to say their causes; part of the prior
  double log_prior = 0;
  double log_evidence = 0;             ///< over noise and discrepancy
  double discrepancy_probability = 0;  ///< that something unnamed is missing as well
  double discrepancy = 0;              ///< m, its most probable size
  std::size_t level = 0;               ///< of that size, among those tried
  double model_error = 0;              ///< m, of each coordinate beyond the stated noise, most probable
  double more_noise_probability = 0;   ///< that the noise is larger than stated
  double scatter_probability = 0;      ///< the same, and no discrepancy
  Eigen::VectorXd sizes, sigma;        ///< of the terms' numbers, one after another, in units
  SourceEvidence source;               ///< of the discrepancy where it is most probably of a single source
  Eigen::VectorXd remainder;           ///< of a fit: whitened errors of the discrepancy, most probable; empty: none
  Eigen::VectorXd remainder_left;      ///< the same beside all that is fitted: what of it is seen as an error
  Eigen::VectorXd remainder_terms;     ///< its weights of the process's terms
  std::vector<Likeness> likenesses;    ///< of a fit beside which something remains, term by term
  Explanation fit;                     ///< of a leader: fitted with everything that is free
  bool is_fitted = false;
  double gain_by_fit = 0;  ///< of log evidence against that of the linearisation about the baseline

  [[nodiscard]] double logWeight() const { return log_prior + log_evidence; }
  /// Returns true if a fit was found: a model that could not be fitted explains nothing.
  [[nodiscard]] bool hasFit() const { return is_fitted && std::isfinite(log_evidence); }
};

/// Log of the probability beforehand that so many causes are missing.
[[nodiscard]] double logPriorOfCount(std::size_t causes);

/// Their causes, ascending.
[[nodiscard]] std::vector<int> causesOf(const std::vector<ModelTerm>& terms);

/// One view of the noise, and all evidence under it.
struct NoiseHypothesis {
  double model_error = 0;  ///< m
  double log_prior = 0;
  ReadingWeights weights;
  Eigen::MatrixXd principal_terms;         ///< of the discrepancy: its terms x principal ones
  Eigen::MatrixXd discrepancy;             ///< whitened columns of the principal terms, rows of `weights`
  std::unique_ptr<SingleSources> sources;  ///< none of very many readings: all terms together are as sharp there
  EvidenceOptions options;
  std::unique_ptr<LinearEvidence> evidence;
};

/// All that one diagnosis linearises about its baseline.
struct DiagnosisWork {
  const DiagnosisOptions& options;
  FittedBasis basis;
  CauseList causes;
  std::unique_ptr<Signatures> signatures;
  std::unique_ptr<Discrepancy> discrepancy;
  Eigen::MatrixXf kept_signatures;     ///< all readings' columns by the stated noise; empty of too many
  std::vector<NoiseHypothesis> noise;  ///< the stated first; another where readings ask for it
  std::vector<CompetingModel> models;  ///< most probable first

  [[nodiscard]] const Cause& cause(int index) const { return causes.causes[static_cast<std::size_t>(index)]; }
};

/// That nothing is missing; `work.models` must be compared.
[[nodiscard]] const CompetingModel& modelOfNothing(const DiagnosisWork& work);

/// The index in `work.noise` of the view that the model most probably has.
[[nodiscard]] std::size_t likelyNoise(const DiagnosisWork& work, const CompetingModel& model);

/// Most probable first; equal ones in the order they had.
void sortByWeight(std::vector<CompetingModel>& models);

}  // namespace tubeplan::calibration
