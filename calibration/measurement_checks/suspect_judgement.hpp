// Decides whether a suspected mistake, or several together, explains the measurements, by the criteria of
// measurement_checks.hpp.
#pragma once

#include <vector>

#include "calibration/measurement_checks/joined_mistakes.hpp"

namespace tubeplan::calibration {

/// One suspected mistake, or several together, with the fits of the corrected measurements: `drawn` to the arm as
/// drawn, `open` with all open parameters free.
struct Suspect {
  JoinedCorrections parts;
  Correction correction;
  Trial drawn, open;
};

/// Judges suspects by comparing their fits with the fits of the measurements as stated. `trials` must outlive the
/// object.
class SuspectJudgement {
 public:
  explicit SuspectJudgement(const MistakeTrials& trials) : trials_(trials) {}

  /// Returns true if there is an error that a mistake could explain, or a displacement of the base that a mistake could
  /// have caused.
  [[nodiscard]] bool needsMistakeSearch() const;
  /// Returns true if there is an error that a step of a few sigmas could cause.
  [[nodiscard]] bool needsStepSearch() const;
  /// Returns true if the remaining error exceeds the usual error of a model, for every suspect that could be corrected.
  [[nodiscard]] bool hasRemainingError(const std::vector<Suspect>& suspects) const;

  /// Returns true if several mistakes are worth trying together: an error remains, or every suspect leaves the base far
  /// from its nominal place or needs a distorted drawing. A step that leaves only noise needs no further mistake.
  [[nodiscard]] bool needsCombinedSearch(const std::vector<Suspect>& suspects) const;

  /// Returns true if a suspect lowers the error as much as measurement_checks.hpp requires of a mistake.
  [[nodiscard]] bool explainsError(const Suspect& suspect) const;
  /// Returns true if a suspect brings the base back to its nominal place without a larger error.
  [[nodiscard]] bool explainsBase(const Suspect& suspect) const;
  /// Returns true if each of a suspect's mistakes meets the criteria of a single mistake once the others are corrected.
  [[nodiscard]] bool isAllNeeded(const Suspect& suspect) const;
  /// Returns true if the suspect is a single mistake, and one effect of the catalogue at one place, of a size that is
  /// possible on a real machine, explains the measurements as well without it.
  [[nodiscard]] bool isEffectAsLikely(const Suspect& suspect) const;
  /// Returns true if, with the suspect corrected, the remaining error is no larger than the noise.
  [[nodiscard]] static bool isAtNoise(const Suspect& suspect);
  /// Returns true if there are enough measurements to refute a correction that is fitted to them or that excludes some
  /// of them.
  [[nodiscard]] bool isDetermined(const Correction& correction) const;

  /// Returns the log odds of a suspect against no mistake, minus the penalty for mistakes that may begin at any
  /// measurement.
  [[nodiscard]] double gainOf(const Suspect& suspect) const;
  /// Returns gainOf(suspect) minus the prior log odds against each further mistake.
  [[nodiscard]] double merit(const Suspect& suspect) const;
  /// Returns true if suspect `other` explains the measurements as well as `best`.
  [[nodiscard]] bool isAsGood(const Suspect& other, const Suspect& best) const;

 private:
  [[nodiscard]] bool isLackOfFit() const;
  /// Returns true if the corrected measurements fit only with dimensions that depart from the drawing to the limits of
  /// their priors or beyond.
  [[nodiscard]] bool isBent(const Suspect& suspect) const;
  /// Returns true if a base that was far from its nominal place before is near it after the correction.
  [[nodiscard]] bool restoresNominalBase(const Trial& before, const Trial& after) const;

  const MistakeTrials& trials_;
};

}  // namespace tubeplan::calibration
