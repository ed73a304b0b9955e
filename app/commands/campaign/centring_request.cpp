#include "app/commands/campaign/centring_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/cli/caller.hpp"
#include "app/formats/cell/command_inputs.hpp"
#include "app/formats/cell/uncertainty_reader.hpp"
#include "app/formats/cell/workcell.hpp"
#include "app/formats/sheet/touched_base.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/named_entry.hpp"
#include "app/studies/measurements/simulated_calibration.hpp"
#include "app/studies/measurements/touched_holes.hpp"

namespace tubeplan::app {

namespace {

constexpr int kTouchableHoles = 24;  // number of candidate holes for touches, as in `plan --touches auto`
constexpr std::size_t kMostSettings = 100;
constexpr int kMostTouchedHoles = 50;
// Largest accepted length [m] (10 in); an arm with a larger error does not find any hole.
constexpr double kMostLength = 0.254;
constexpr double kMostAngle = 0.5;  // largest angle accepted [rad]

void requireWithin(const std::string& option, double value, double most, const std::string& what) {
  if (!(value >= 0 && value <= most))
    throw InputError(option, fmt::format("{}", value), fmt::format("{} from 0 to {:.3g}", what, most));
}

double lengthFrom(const std::string& option, std::optional<double> value, double otherwise, const Units& units) {
  if (!value) return otherwise;
  const double unit = units.factor(dimension::kLength);
  requireWithin(option, *value, kMostLength / unit, fmt::format("a length ({})", units.length().name));
  return *value * unit;
}

double angleFrom(const std::string& option, std::optional<double> value, double otherwise, const Units& units) {
  if (!value) return otherwise;
  const double unit = units.factor(dimension::kAngle);
  requireWithin(option, *value, kMostAngle / unit, fmt::format("an angle ({})", units.angle().name));
  return *value * unit;
}

template <class T>
void refuseTwice(const std::string& option, std::vector<T> values) {
  std::sort(values.begin(), values.end());
  if (const auto twice = std::adjacent_find(values.begin(), values.end()); twice != values.end())
    throw InputError::problem(option, fmt::format("{} is given twice", *twice), "give each value once");
}

TruthSpread spreadOf(const CampaignRequest& request, const Units& units) {
  TruthSpread spread;
  spread.base_shift_sigma = lengthFrom("--base-shift", request.base_shift, spread.base_shift_sigma, units);
  spread.base_turn_sigma = angleFrom("--base-turn", request.base_turn, spread.base_turn_sigma, units);
  spread.unmodelled_sigma = lengthFrom("--unmodelled", request.unmodelled, spread.unmodelled_sigma, units);
  if (request.stiffness) {
    requireWithin("--stiffness", *request.stiffness, 1, "a fraction of each stiffness");
    spread.stiffness_sigma = *request.stiffness;
  }
  return spread;
}

void setEncoderSigma(double sigma, deflection::Arm& arm) {
  for (const int row : deflection::activeRows(arm)) {
    auto& joint = arm.rows[static_cast<std::size_t>(row)].joint;
    if (joint.type == deflection::JointType::kRevolute) joint.encoder_sigma = sigma;
  }
}

std::vector<double> touchSigmas(const CampaignRequest& request, const CentringTask& task) {
  if (request.touch_sigmas.empty()) return {touchSigmaOf(task.model.tool)};
  refuseTwice("--touch-sigma", request.touch_sigmas);
  std::vector<double> sigmas;
  for (const double sigma : request.touch_sigmas)
    sigmas.push_back(lengthFrom("--touch-sigma", sigma, 0, task.cell.units));
  return sigmas;
}

std::vector<CentringSetting> settingsOf(const CampaignRequest& request, const CentringTask& task) {
  refuseTwice("--touches", request.touches);
  refuseTwice("--choice", request.choices);
  std::vector<CentringSetting> settings;
  for (const int touches : request.touches) {
    if (touches < 3 || touches > kMostTouchedHoles)
      throw InputError("--touches", std::to_string(touches), fmt::format("3 to {} touched holes", kMostTouchedHoles));
    for (const auto& choice : request.choices)
      for (const double sigma : touchSigmas(request, task))
        settings.push_back({touches, entryNamed(touchRules(), choice, "--choice").rule, sigma});
  }
  if (settings.size() > kMostSettings)
    throw InputError::problem(
        "--touches, --choice, --touch-sigma",
        fmt::format("these options give {} combinations, at most {} are allowed", settings.size(), kMostSettings),
        "give fewer values");
  return settings;
}

/// Finds the holes to visit and to touch; tubes that the tool cannot enter because of their state are excluded.
void findHoles(const CampaignRequest& request, const VisitedHoles& visited, CentringTask& task) {
  const std::string tubes = tubesOrSpread(request.tubes, task.model.sheet, visited.tubes);
  requireWorkList(request.columns, {tubes});
  const auto selection = readTubes(tubes, task.model.sheet, request.columns);
  for (const auto& note : listNotes(selection)) remark("note: {}\n", note);
  task.tubes = static_cast<int>(selection.tube_indices.size());
  task.holes.visited = touchCandidates(task.model, selection.tube_indices);
  if (static_cast<int>(task.holes.visited.size()) < request.holes)
    throw InputError("--tubes " + tubes,
                     fmt::format("{} reachable holes among {} tubes", task.holes.visited.size(), task.tubes),
                     fmt::format("at least the {} that a run visits", request.holes),
                     fmt::format("select more tubes, or reduce {}", visited.option));
  for (const auto& setting : task.options.settings)
    if (setting.rule == TouchRule::kBest && task.holes.touchable.empty())
      task.holes.touchable = touchCandidates(task.model, kTouchableHoles);
}

void requireTouchable(const CentringTask& task) {
  for (const auto& setting : task.options.settings) {
    const bool is_best = setting.rule == TouchRule::kBest, is_tested = setting.rule == TouchRule::kTested;
    const int most = is_best     ? static_cast<int>(task.holes.touchable.size())
                     : is_tested ? task.options.holes
                                 : static_cast<int>(task.holes.visited.size());
    if (setting.touches > most)
      throw InputError("--touches", std::to_string(setting.touches),
                       fmt::format("at most {}, the number of holes {}", most,
                                   is_tested ? "visited in a run" : "that can be touched"),
                       is_tested ? "touch fewer holes, or visit more with --holes" : "touch fewer holes");
  }
}

}  // namespace

CentringTask centringTask(const CampaignRequest& request, const VisitedHoles& visited) {
  CentringTask task;
  task.cell = readCell(request.cell);
  forgetTouches(task.cell);
  task.model = workcellOf(task.cell, "score positioning");
  const std::string truth = request.truth.empty() ? request.cell : request.truth;
  task.truth = workcellOf(readCell(truth), "score against it");
  if (task.model.sheet.fingerprint() != task.truth.sheet.fingerprint())
    throw InputError::problem(
        truth,
        fmt::format("this tube sheet (fingerprint {}) differs from that of the cell (fingerprint {})",
                    task.truth.sheet.fingerprint(), task.model.sheet.fingerprint()),
        "give a true cell with the same tube sheet");
  if (request.holes < visited.least || request.holes > visited.most)
    throw InputError(visited.option, std::to_string(request.holes),
                     fmt::format("{} to {} holes in each run", visited.least, visited.most));
  if (request.encoder_sigma)
    for (auto* arm : {&task.model.arm, &task.truth.arm})
      setEncoderSigma(angleFrom("--encoder-sigma", request.encoder_sigma, 0, task.cell.units), *arm);
  task.options.spread = spreadOf(request, task.cell.units);
  task.options.additional = additionalUncertainty(task.cell);
  task.options.holes = request.holes;
  task.options.seed = request.seed;
  task.options.settings = settingsOf(request, task);
  findHoles(request, visited, task);
  requireTouchable(task);
  return task;
}

PlanKey centringKey(const CentringTask& task, const CampaignRequest& request) {
  const auto& spread = task.options.spread;
  std::string settings, holes;
  for (const auto& setting : task.options.settings)
    settings += fmt::format("{}:{}:{:a} ", setting.touches, static_cast<int>(setting.rule), setting.touch_sigma);
  for (const auto& hole : task.holes.visited) holes += hole.hole + " ";
  Eigen::Matrix2Xd tool(2, std::ssize(task.model.tool.steps));
  for (Eigen::Index k = 0; k < tool.cols(); ++k) {
    const auto& step = task.model.tool.steps[static_cast<std::size_t>(k)];
    tool.col(k) << step.diameter, step.tolerance;
  }
  const Cell truth = request.truth.empty() ? task.cell : readCell(request.truth);
  return {{"program", programText()},
          {"kind of campaign", "centre"},
          {"arm and scene", modelFingerprint(task.cell)},
          {"base", numbersFingerprint(task.model.X_WB.matrix())},
          {"uncertainty of the arm's numbers",
           fingerprintOf(uncertaintyText(task.cell.uncertainty, task.cell.arm, task.cell.units))},
          {"model error", fmt::format("{} m", task.options.additional.model_error)},
          {"true arm", modelFingerprint(truth)},
          {"true base", numbersFingerprint(task.truth.X_WB.matrix())},
          {"sheet", task.model.sheet.fingerprint()},
          {"tool", numbersFingerprint(tool)},
          {"seed", std::to_string(request.seed)},
          {"spread of the true arm",
           fmt::format("{} m, {} rad, {}, {} m, encoders {}", spread.base_shift_sigma, spread.base_turn_sigma,
                       spread.stiffness_sigma, spread.unmodelled_sigma,
                       request.encoder_sigma ? fmt::format("{}", *request.encoder_sigma) : "as the arm's")},
          {"number of holes in a run", std::to_string(task.options.holes)},
          {"list of tubes", fmt::format("{} holes, {}", task.holes.visited.size(), fingerprintOf(holes))},
          {"list of settings", fmt::format("{} settings, {}", task.options.settings.size(), fingerprintOf(settings))}};
}

}  // namespace tubeplan::app
