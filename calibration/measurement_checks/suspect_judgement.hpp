// Whether a mistake explains what is wrong with readings, and how well: what measurement_checks.hpp asks of one, and of
// several that are made at once.
#pragma once

#include <vector>

#include "calibration/measurement_checks/joined_mistakes.hpp"

namespace tubeplan::calibration {

/// One mistake, or several at once, with its trials by the drawing and with all that is open.
struct Suspect {
  JoinedMends parts;
  Mend mend;
  Trial drawn, open;
};

/// `trials` must outlive it.
class SuspectJudgement {
 public:
  explicit SuspectJudgement(const MistakeTrials& trials) : trials_(trials) {}

  /// Returns true if there is an error that a mistake could explain, or a base that one could have moved.
  [[nodiscard]] bool asksForMistakes() const;
  /// Returns true if there is an error that a step of a few sigmas could make.
  [[nodiscard]] bool asksForSteps() const;
  /// Returns true if no single mistake brings the error near what a model may be off by.
  [[nodiscard]] bool isLeftOver(const std::vector<Suspect>& suspects) const;

  /// Returns true if an error is left over, or each suspect leaves the base far from its nominal place or the drawing
  /// bent.
  [[nodiscard]] bool asksForSeveral(const std::vector<Suspect>& suspects) const;

  /// Returns true if a suspect brings the error down as a mistake does.
  [[nodiscard]] bool explainsError(const Suspect& suspect) const;
  /// Returns true if a suspect brings the base back to its nominal place, without harm to the error.
  [[nodiscard]] bool explainsBase(const Suspect& suspect) const;
  /// Returns true if each of several mistakes does what a single one is asked for, beside the others.
  [[nodiscard]] bool isAllNeeded(const Suspect& suspect) const;
  /// Returns true if a suspect leaves the readings with no more than their noise.
  [[nodiscard]] static bool isAtNoise(const Suspect& suspect);
  /// Returns true if so many readings could contradict a mend that is fitted to them, or that leaves some of them out.
  [[nodiscard]] bool isDetermined(const Mend& mend) const;

  /// Returns the log of the odds that a suspect gains, less what a choice among many readings has against it.
  [[nodiscard]] double gainOf(const Suspect& suspect) const;
  /// Returns the same less what each further mistake has against it beforehand.
  [[nodiscard]] double merit(const Suspect& suspect) const;
  /// Returns true if another suspect explains the readings as well as the best.
  [[nodiscard]] bool isAsGood(const Suspect& other, const Suspect& best) const;

 private:
  [[nodiscard]] bool isLackOfFit() const;
  /// Returns true if only a drawing that is bent to the readings fits them: by what its priors allow and more.
  [[nodiscard]] bool isBent(const Suspect& suspect) const;
  /// Returns true if a base that was far from its nominal place is near it after.
  [[nodiscard]] bool bringsBack(const Trial& before, const Trial& after) const;

  const MistakeTrials& trials_;
};

}  // namespace tubeplan::calibration
