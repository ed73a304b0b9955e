// Every effect that a model could lack, at every place, linearised about a fit: what each would do to the readings.
#pragma once

#include <string>
#include <vector>

#include "calibration/fit.hpp"
#include "deflection/effects/effect.hpp"

namespace tubeplan::calibration {

/// An effect at a place: one answer that a diagnosis can give.
struct Candidate {
  std::string effect, at;
  deflection::Effect neutral;        ///< at neutral values
  std::vector<int> sizes;            ///< indices of its values that are not shapes
  int shape = -1;                    ///< index of its shape value; -1 without
  std::vector<double> levels;        ///< shape values that are tried; one (unused) without a shape
  std::vector<double> unit;          ///< of each value: the largest plausible size
  std::vector<double> lower, upper;  ///< of each value
};

/// Whether its shape is the time of a step, before which it does nothing.
[[nodiscard]] bool isStep(const Candidate& candidate);

/// Columns of a candidate at one of its shape levels, one for each size, for a change by its unit.
struct CandidateColumns {
  int candidate = -1;
  int level = 0;
  Eigen::MatrixXd columns;  ///< whitened rows x sizes
};

struct Catalogue {
  std::vector<Candidate> candidates;
  std::vector<CandidateColumns> columns;
  std::vector<std::string> not_tried;  ///< effects left out and why: "hysteresis: no column <joint>_dir"
};

struct CatalogueOptions {
  int knee_levels = 7;   ///< tried moments of a knee
  int time_levels = 64;  ///< tried times of a step
};

/// All candidates of the arm that the readings could show, linearised at `placed` with the weights of a fit to
/// `readings`. Effects that the arm already has at a place are left out. Unwinds where it was stopped.
[[nodiscard]] Catalogue linearizeCatalogue(const PlacedArm& placed, const std::vector<Measurement>& readings,
                                           const ReadingWeights& weights, const CatalogueOptions& options = {},
                                           const WorkHooks& hooks = {});

/// A step's columns at any time from one linearisation, as before its time it does nothing. Keeps references to
/// readings and weights.
class StepColumns {
 public:
  StepColumns(const PlacedArm& placed, const std::vector<Measurement>& readings, const ReadingWeights& weights,
              const Candidate& step);
  [[nodiscard]] Eigen::MatrixXd at(double time) const;

 private:
  const std::vector<Measurement>& readings_;
  const ReadingWeights& weights_;
  Eigen::MatrixXd always_;  ///< as if it had been there from the first
};

/// The candidate's effect placed on an arm: its values at the given sizes (in units), shape as given; returns the
/// index of the effect.
int placeEffect(deflection::Arm& arm, const Candidate& candidate, double shape);

/// The unknowns for a placed effect's sizes; `sizes` chooses among the candidate's.
[[nodiscard]] std::vector<Unknown> effectUnknowns(const deflection::Arm& arm, const Candidate& candidate, int effect,
                                                  const std::vector<int>& sizes);

}  // namespace tubeplan::calibration
