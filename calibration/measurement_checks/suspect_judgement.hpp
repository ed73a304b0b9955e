// Judgement of mistakes by the criteria of measurement_checks.hpp, for one mistake or for several together.
#pragma once

#include <vector>

#include "calibration/measurement_checks/joined_mistakes.hpp"

namespace tubeplan::calibration {

/// One mistake, or several together, with its trials by the drawing and with all that is open.
struct Suspect {
  JoinedMends parts;
  Mend mend;
  Trial drawn, open;
};

/// Criteria for suspects. `trials` must outlive the object.
class SuspectJudgement {
 public:
  explicit SuspectJudgement(const MistakeTrials& trials) : trials_(trials) {}

  /// Returns true if there is an error that a mistake could explain, or a base that one could have moved.
  [[nodiscard]] bool asksForMistakes() const;
  /// Returns true if there is an error that a step of a few sigmas could cause.
  [[nodiscard]] bool asksForSteps() const;
  /// Returns true if no single mistake brings the error near the usual error of a model.
  [[nodiscard]] bool isLeftOver(const std::vector<Suspect>& suspects) const;

  /// Returns true if an error remains, or if each suspect has the base far from its nominal place or a bent drawing.
  [[nodiscard]] bool asksForSeveral(const std::vector<Suspect>& suspects) const;

  /// Returns true if a suspect lowers the error as much as a mistake must.
  [[nodiscard]] bool explainsError(const Suspect& suspect) const;
  /// Returns true if a suspect brings the base back to its nominal place without a larger error.
  [[nodiscard]] bool explainsBase(const Suspect& suspect) const;
  /// Returns true if each of several mistakes meets the criteria of a single one, beside the others.
  [[nodiscard]] bool isAllNeeded(const Suspect& suspect) const;
  /// Returns true if a suspect leaves no more than the noise.
  [[nodiscard]] static bool isAtNoise(const Suspect& suspect);
  /// Returns true if the readings are enough to contradict a correction that is fitted to them, or that leaves some of
  /// them out.
  [[nodiscard]] bool isDetermined(const Mend& mend) const;

  /// Returns the log odds that a suspect gains, minus the penalty for a choice among many readings.
  [[nodiscard]] double gainOf(const Suspect& suspect) const;
  /// Returns the same minus the prior log odds against each further mistake.
  [[nodiscard]] double merit(const Suspect& suspect) const;
  /// Returns true if another suspect explains the readings as well as the best.
  [[nodiscard]] bool isAsGood(const Suspect& other, const Suspect& best) const;

 private:
  [[nodiscard]] bool isLackOfFit() const;
  /// Returns true if the readings fit only a drawing that is bent to them, by as much as its priors allow and more.
  [[nodiscard]] bool isBent(const Suspect& suspect) const;
  /// Returns true if a base that was far from its nominal place is near it afterwards.
  [[nodiscard]] bool bringsBack(const Trial& before, const Trial& after) const;

  const MistakeTrials& trials_;
};

}  // namespace tubeplan::calibration
