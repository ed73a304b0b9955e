// What rival explanations foretell of readings to come, and how far such readings would tell them apart.
#pragma once

#include <vector>

#include "calibration/design/next_readings.hpp"
#include "calibration/diagnosis/explanation_model.hpp"

namespace tubeplan::calibration {

/// An explanation with what the readings so far tell of its numbers.
struct Rival {
  ExplanationModel model;
  double criterion = 0;
  Eigen::MatrixXd covariance;  ///< of the unknowns over their typical sizes
};

[[nodiscard]] std::vector<Rival> rivalsOf(const DiagnosisBasis& basis, const std::vector<Explanation>& explanations);

/// Whitened rows that each rival foretells at one candidate, and their sensitivities to its unknowns over their typical
/// sizes.
struct Foretold {
  std::vector<Eigen::VectorXd> value;
  std::vector<Eigen::MatrixXd> sensitivity;
};

/// At each candidate; no rivals' entries where a shape does not settle. Unwinds where it was stopped.
[[nodiscard]] std::vector<Foretold> foretell(const std::vector<Rival>& rivals,
                                             const std::vector<ReadingCandidate>& candidates,
                                             const StopQuestion& stop = {});

/// A greedy choice of candidates, each at most once.
struct SplittingStep {
  int candidate = -1;
  int a = -1, b = -1;     ///< rivals that it splits most
  double separation = 0;  ///< in noise sigmas
};
[[nodiscard]] std::vector<SplittingStep> chooseSplitting(const std::vector<Rival>& rivals,
                                                         const std::vector<Foretold>& foretold, int count,
                                                         const StopQuestion& stop = {});

/// The rise of b's chi-square over a's by chosen candidates, made `times` times, when a is true.
struct ExpectedRise {
  double mean = 0, sigma = 0;
};
[[nodiscard]] ExpectedRise expectedRise(const std::vector<Rival>& rivals, const std::vector<Foretold>& foretold,
                                        const std::vector<SplittingStep>& steps, int a, int b, int times);

}  // namespace tubeplan::calibration
