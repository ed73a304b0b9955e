#include "calibration/diagnosis/judgement/measurements_kept_out.hpp"

#include <algorithm>
#include <cmath>

#include "calibration/diagnosis/explanations/explanation_model.hpp"
#include "calibration/diagnosis/judgement/remainder.hpp"
#include "calibration/estimation/held_out.hpp"

namespace tubeplan::calibration {

namespace {

constexpr std::size_t kMostJudged = 3;

/// Drops alternatives that do not lower the error on held-out measurements, and changes the verdict accordingly.
void dropWhatDoesNotHelp(Diagnosis& result) {
  const std::size_t before = result.alternatives.size();
  std::erase_if(result.alternatives, [&](const Explanation& explanation) {
    return std::isfinite(explanation.heldout.rms) && explanation.heldout.rms >= result.heldout_before.rms;
  });
  if (result.alternatives.empty() && result.verdict == Verdict::kPartlyExplained) {
    result.verdict = Verdict::kUnexplained;  // an effect is missing, although no cause is left
  } else if (result.alternatives.empty()) {
    result.verdict = Verdict::kInconclusive;
    result.reason =
        "the explanation of the fitted readings does not lower the error of held-out readings; more readings are "
        "needed";
  } else if (result.verdict == Verdict::kAmbiguous && before > 1 && result.alternatives.size() == 1) {
    result.verdict = Verdict::kExplained;
  }
}

/// Sets the held-out errors of single causes in the ranking.
void setHeldOutErrors(const std::vector<Explanation>& explanations, Diagnosis& result) {
  for (auto& entry : result.ranking) {
    entry.heldout_before = result.heldout_before;
    for (const auto& explanation : explanations)
      if (explanation.effects.size() == 1 && explanation.effects.front().effect == entry.effect &&
          explanation.effects.front().at == entry.at)
        entry.heldout_after = explanation.heldout;
  }
}

}  // namespace

void judgeByMeasurementsKeptOut(const DiagnosisWork& work, const std::vector<Measurement>& kept_out,
                                Diagnosis& result) {
  const auto folds = foldsOf(work.basis.measurements, work.options.folds, work.options.seed);
  const ExplanationModel bare{work.basis.fitted, work.basis.unknowns};
  const auto farthest = farthestQuarter(work.basis.fitted, work.basis.measurements);
  const auto held_out = judgeable(work.basis.fitted, work.basis.measurements, kept_out);
  const auto judged = [&](const ExplanationModel& model, double model_error) {
    return kept_out.empty() ? judgeOnFolds(work.basis, model, folds, model_error) : judge(model.placed, held_out);
  };
  reportProgress(work.options.hooks, "readings kept out");
  result.heldout_before = judged(bare, result.baseline.model_error);
  result.heldout_after = result.heldout_before;
  result.farthest_before = judgeOnFolds(work.basis, bare, farthest, result.baseline.model_error);
  result.after = result.before;
  const auto judgeOne = [&](Explanation& explanation) {
    const ExplanationModel model = modelOf(work.basis, explanation);
    explanation.heldout = judged(model, explanation.model_error);
    explanation.farthest = judgeOnFolds(work.basis, model, farthest, explanation.model_error);
  };
  const auto judgeEach = [&](std::vector<Explanation>& explanations) {
    const std::size_t most = std::min(explanations.size(), kMostJudged);
    for (std::size_t k = 0; k < most; ++k) {
      reportProgress(work.options.hooks, "readings kept out", k + 1, most + 1);
      judgeOne(explanations[k]);
    }
  };
  auto& explanations = result.alternatives.empty() ? result.closest : result.alternatives;
  judgeEach(explanations);
  if (result.agreed) judgeOne(*result.agreed);
  setHeldOutErrors(explanations, result);
  if (result.alternatives.empty()) return;
  dropWhatDoesNotHelp(result);
  if (result.verdict == Verdict::kUnexplained) {
    result.remainder = remainderOf(work, work.models.front());
    judgeEach(result.closest);
  }
  if (result.alternatives.empty()) return;
  result.after = result.alternatives.front().after;
  result.heldout_after = result.alternatives.front().heldout;
}

}  // namespace tubeplan::calibration
