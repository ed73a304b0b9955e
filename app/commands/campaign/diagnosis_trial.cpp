#include "app/commands/campaign/diagnosis_trial.hpp"

#include <algorithm>
#include <cmath>

#include "app/jobs/diagnosis.hpp"
#include "app/studies/monte_carlo/random_draw.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "deflection/effects/effect.hpp"

namespace tubeplan::app {

namespace {

using calibration::Verdict;
using TrialDraw = calibration::RandomStreamFrom<SplitMix>;

enum Purpose : std::uint64_t { kHiddenKey = 101, kMeasurementsKey, kDiagnosisKey };

int indexBelow(std::size_t count, TrialDraw& draw) { return static_cast<int>(draw.seed() % count); }

struct Hidden {
  deflection::Effect effect;
  double share = 0;
};

Hidden drawEffect(const deflection::Arm& arm, const std::vector<int>& kinds, TrialDraw& draw) {
  const int kind = kinds[static_cast<std::size_t>(indexBelow(kinds.size(), draw))];
  const auto& row = deflection::effectKinds()[static_cast<std::size_t>(kind)];
  const auto places = row.places(arm);
  Hidden hidden;
  hidden.effect.kind = kind;
  hidden.effect.place = places[static_cast<std::size_t>(indexBelow(places.size(), draw))];
  hidden.share = std::pow(kLeastShare, draw.uniform(0, 1));
  for (const auto& number : row.parameters) hidden.effect.values.push_back(number.neutral);
  for (std::size_t v = 0; v < row.parameters.size(); ++v) {
    const auto& number = row.parameters[v];
    if (number.is_shape) continue;
    const double size = hidden.share * number.plausible * (number.lower < 0 && draw.seed() % 2 ? -1 : 1);
    const auto bounds = deflection::numberOf(arm, hidden.effect, static_cast<int>(v));
    hidden.effect.values[v] = std::clamp(number.neutral + size, bounds.lower, bounds.upper);
  }
  return hidden;
}

std::size_t sizeClassOf(double share) {
  const double order = 1 - std::log(share) / std::log(kLeastShare);  // 0 for the smallest magnitude, 1 for the largest
  return std::min(kSizeClasses - 1, static_cast<std::size_t>(std::max(0., order) * kSizeClasses));
}

bool isTruth(const calibration::Explanation& explanation, const std::string& effect, const std::string& at) {
  if (explanation.effects.size() != 1) return false;
  const auto& found = explanation.effects.front();
  return (found.effect == effect && found.at == at) ||
         std::find(found.indistinguishable.begin(), found.indistinguishable.end(), std::pair{effect, at}) !=
             found.indistinguishable.end();
}

DiagnosisOutcomeKind outcomeOf(const calibration::Diagnosis& diagnosis, const std::string& effect,
                               const std::string& at) {
  switch (diagnosis.verdict) {
    case Verdict::kNotRun:
      return DiagnosisOutcomeKind::kNotMade;
    case Verdict::kAdequate:
      return DiagnosisOutcomeKind::kAdequate;
    case Verdict::kInconclusive:
      return DiagnosisOutcomeKind::kInconclusive;
    case Verdict::kUnexplained:
      return DiagnosisOutcomeKind::kUnexplained;
    default:
      break;
  }
  const auto& answers = diagnosis.alternatives;
  if (!std::any_of(answers.begin(), answers.end(), [&](const auto& answer) { return isTruth(answer, effect, at); }))
    return DiagnosisOutcomeKind::kOther;
  return answers.size() == 1 ? DiagnosisOutcomeKind::kNamed : DiagnosisOutcomeKind::kAmong;
}

}  // namespace

DiagnosisTrials::DiagnosisTrials(const Cell& cell, std::vector<int> kinds, const DiagnosisTrialOptions& options)
    : cell_(cell), kinds_(std::move(kinds)), options_(options) {
  (void)prepareSimulation(cell_, options_.measurements);
}

std::optional<DiagnosisTrial> DiagnosisTrials::run(std::uint64_t index, const calibration::StopQuestion& stop) const {
  TrialDraw draw(keyOf({options_.seed, index, kHiddenKey}));
  SimulationRequest request = options_.measurements;
  request.seed = keyOf({options_.seed, index, kMeasurementsKey});
  SimulationTask task = prepareSimulation(cell_, request);
  DiagnosisTrial trial;
  std::string effect, at;
  if (draw.uniform(0, 1) >= options_.nothing) {
    const Hidden hidden = drawEffect(cell_.arm, kinds_, draw);
    const auto& kind = kindOf(hidden.effect);
    trial.effect = hidden.effect.kind;
    trial.size_class = sizeClassOf(hidden.share);
    effect = kind.name;
    at = deflection::textOf(cell_.arm, kind, hidden.effect.place);
    task.truth.arm.effects.push_back(hidden.effect);
  }
  const auto simulated = simulateMeasurements(cell_, task, request.seed, {{}, stop});
  if (simulated.status == calibration::CampaignStatus::kStopped) return std::nullopt;
  if (simulated.status != calibration::CampaignStatus::kDone) return trial;
  DiagnosisRequest question;
  question.effects = options_.effects;
  question.seed = keyOf({options_.seed, index, kDiagnosisKey});
  const auto diagnosis = diagnoseMeasurements(cell_, simulated.measurements, question, {{}, stop});
  if (diagnosis.verdict == Verdict::kStopped) return std::nullopt;
  trial.outcome = outcomeOf(diagnosis, effect, at);
  return trial;
}

std::vector<int> observableKinds(const Cell& cell, const DiagnosisTrialOptions& options) {
  const auto design = prepareSimulation(cell, options.measurements).design;
  const bool is_loaded = std::any_of(design.loads.begin(), design.loads.end(), [](double load) { return load > 0; });
  calibration::Measurement measurement;
  measurement.kind = design.kind;
  const bool shows_tool_turn = calibration::seesToolTurn(measurement);
  std::vector<int> kinds;
  const auto& table = deflection::effectKinds();
  for (std::size_t k = 0; k < table.size(); ++k)
    if (!table[k].parameters.empty() && table[k].places && !table[k].places(cell.arm).empty() &&
        (is_loaded || !table[k].needs.load) && (shows_tool_turn || !table[k].needs.tool_turn))
      kinds.push_back(static_cast<int>(k));
  return kinds;
}

}  // namespace tubeplan::app
