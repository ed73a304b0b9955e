// Comparison of the predicted probabilities that a given number of the tool's steps enters a hole with what happens on
// true arms whose physics differs from the model. Each true arm has stiffness errors, a different mixture of effects
// that the model lacks, and an error field over the sheet that no effect of the catalogue causes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/cell/workcell.hpp"
#include "app/studies/measurements/simulated_calibration.hpp"
#include "app/studies/measurements/touched_holes.hpp"
#include "app/studies/monte_carlo/random_draw.hpp"
#include "app/studies/monte_carlo/true_arm.hpp"
#include "app/studies/monte_carlo/true_touches.hpp"
#include "app/studies/positioning/step_chances.hpp"
#include "deflection/effects/effect.hpp"

namespace tubeplan::testing {

inline constexpr int kBins = 4;  // numbers of inserted steps: 0, 1, 2, 3

struct StepChanceTrial {
  bool is_calibrated = false;
  int holes = 0;
  std::array<double, kBins> predicted{}, happened{};  ///< sums over the holes, per number of steps
};

/// Physics of a true arm that its model lacks, in addition to the stiffness errors that every true arm has.
enum class HiddenPhysics { kMixed, kEffects, kField, kStiffnesses };

inline constexpr double kStiffnessSigma = 0.05;

/// Returns the uncertainty of the true arms' parameters; only the stiffnesses are drawn at random.
inline calibration::ArmUncertainty uncertaintyOfTrials() {
  auto uncertainty = calibration::ArmUncertainty::none();
  uncertainty.stiffness = kStiffnessSigma;
  return uncertainty;
}

class StepChanceTrials {
 public:
  StepChanceTrials(const app::Cell& cell, int touches, int holes, HiddenPhysics hidden = HiddenPhysics::kMixed)
      : cell_(cell),
        model_(app::workcellOf(cell, "study")),
        truths_(model_, {.stiffness_sigma = kStiffnessSigma}),
        hidden_(hidden),
        candidates_(app::touchCandidates(model_, 120)),
        touches_(touches),
        holes_(holes) {
    const auto& table = deflection::effectKinds();
    for (int k = 0; k < static_cast<int>(table.size()); ++k) {
      const auto& kind = table[static_cast<std::size_t>(k)];
      const bool is_seen =
          deflection::conditionsOf(kind).empty() && !kind.needs.approach_directions && !kind.needs.load;
      if (is_seen && kind.places && !kind.parameters.empty() && kind.stage != deflection::EffectStage::kMeasurement &&
          kind.at != deflection::PlaceRule::kSetup && !kind.places(model_.arm).empty())
        kinds_.push_back(k);
    }
  }

  [[nodiscard]] StepChanceTrial run(std::uint64_t seed) const {
    Draw draw(app::keyOf({seed, 7}));
    planner::Workcell truth = truths_.draw(draw);
    const bool has_effects = hidden_ == HiddenPhysics::kMixed || hidden_ == HiddenPhysics::kEffects;
    const int effects =
        hidden_ == HiddenPhysics::kEffects ? 1 + static_cast<int>(draw.seed() % 2) : static_cast<int>(draw.seed() % 3);
    for (int k = 0; k < effects && has_effects; ++k) hide(truth.arm, draw);
    const bool is_drawn = draw.seed() % 2 == 0 || effects == 0;
    const Field field(hidden_ == HiddenPhysics::kField || (hidden_ == HiddenPhysics::kMixed && is_drawn), draw);
    auto plans = candidates_;
    draw.choose(plans, static_cast<std::size_t>(touches_ + holes_));
    for (int tries = 0; tries < 50 && !app::areWellSpread(trialHoles(plans, field), touches_); ++tries)
      draw.choose(plans, static_cast<std::size_t>(touches_ + holes_));
    const auto drawn = trialHoles(plans, field);
    StepChanceTrial trial;
    const auto touches = app::touchHoles(truth, drawn, touches_, app::touchSigmaOf(model_.tool), draw.seed());
    if (touches.empty()) return trial;
    calibration::BaseCalibrationOptions options;
    options.arm = cell_.uncertainty;
    options.neighbours = app::neighboursOn(model_.sheet);
    const auto base = calibration::calibrateBase(model_.arm, touches, model_.X_WB, options);
    if (base.status != calibration::CalibrationStatus::kDone) return trial;
    const planner::Workcell placed = app::withBase(model_, base);
    trial.is_calibrated = true;
    std::vector<Eigen::VectorXd> postures;
    std::vector<planner::Centring> predicted;
    std::vector<int> happened;
    for (int k = touches_; k < touches_ + holes_; ++k)
      visit(placed, truth, drawn[static_cast<std::size_t>(k)], postures, predicted, happened);
    const auto chances = app::stepChances({cell_, placed, &base, postures, predicted});
    for (std::size_t k = 0; k < postures.size(); ++k) {
      ++trial.holes;
      ++trial.happened[static_cast<std::size_t>(happened[k])];
      for (std::size_t b = 0; b < kBins; ++b) trial.predicted[b] += chances.by_posture[k][b];
    }
    return trial;
  }

 private:
  using Draw = calibration::RandomStreamFrom<app::SplitMix>;

  /// Smooth error field over the sheet, with an additional independent error at every hole.
  struct Field {
    Field(bool is_there, Draw& draw) {
      size = is_there ? 2.5e-5 * std::pow(40., uniform(draw)) : 0;  // 0.001 to 0.04 in
      for (auto& wave : waves) {
        const double length = 0.5 * std::pow(6., uniform(draw)), turn = 2 * std::numbers::pi * uniform(draw);
        wave = {Eigen::Vector2d(std::cos(turn), std::sin(turn)) * 2 * std::numbers::pi / length,
                2 * std::numbers::pi * uniform(draw), draw.vector(1)};
      }
      own = draw.seed();
    }
    [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& p, int tube) const {
      Eigen::Vector3d error = Eigen::Vector3d::Zero();
      for (const auto& wave : waves) error += std::sin(wave.number.dot(p.head<2>()) + wave.phase) * wave.direction;
      Draw of_hole(app::keyOf({own, static_cast<std::uint64_t>(tube)}));
      return size * (error * std::sqrt(2. / 3) + of_hole.vector(0.5));
    }
    struct Wave {
      Eigen::Vector2d number;
      double phase;
      Eigen::Vector3d direction;
    };
    double size = 0;
    std::array<Wave, 3> waves;
    std::uint64_t own = 0;
  };

  static double uniform(Draw& draw) { return static_cast<double>(draw.seed() >> 11) * 0x1p-53; }

  /// Adds an effect of random kind and place to the arm. Its size is log-uniform between 1/50 and 1/3 of the largest
  /// size on real machines.
  void hide(deflection::Arm& arm, Draw& draw) const {
    const int kind = kinds_[draw.seed() % kinds_.size()];
    const auto& row = deflection::effectKinds()[static_cast<std::size_t>(kind)];
    const auto places = row.places(arm);
    deflection::Effect effect{kind, places[draw.seed() % places.size()], {}};
    const double share = 0.02 * std::pow(16., uniform(draw));
    for (const auto& number : row.parameters) effect.values.push_back(number.neutral);
    for (std::size_t v = 0; v < row.parameters.size(); ++v) {
      if (row.parameters[v].is_shape) continue;
      const double sign = row.parameters[v].lower < 0 && draw.seed() % 2 ? -1 : 1;
      const auto bounds = deflection::numberOf(arm, effect, static_cast<int>(v));
      effect.values[v] = std::clamp(row.parameters[v].neutral + sign * share * row.parameters[v].plausible,
                                    bounds.lower, bounds.upper);
    }
    arm.effects.push_back(effect);
    if (!deflection::findEffectProblems(arm).empty()) arm.effects.pop_back();
  }

  [[nodiscard]] std::vector<app::TrialHole> trialHoles(const std::vector<calibration::TouchPlan>& plans,
                                                       const Field& field) const {
    std::vector<app::TrialHole> holes;
    for (int k = 0; k < touches_ + holes_; ++k) {
      const auto& plan = plans[static_cast<std::size_t>(k)];
      const int tube = app::tubeOf(plan, model_.sheet);
      holes.push_back({plan, tube, field.at(plan.p_WH, tube)});
    }
    return holes;
  }

  void visit(const planner::Workcell& placed, const planner::Workcell& truth, const app::TrialHole& hole,
             std::vector<Eigen::VectorXd>& postures, std::vector<planner::Centring>& predicted,
             std::vector<int>& happened) const {
    planner::CompensationOptions options;
    options.with_approach = false;
    const auto branch = planner::compensateFrom(placed, hole.plan.p_WH, hole.plan.q_start, options);
    if (branch.status != deflection::BranchStatus::kConverged) return;
    const auto score = planner::scoreVisit(truth, hole.plan.p_WH, branch, hole.tip_error);
    if (score.steps < 0 || !score.offset.allFinite()) return;
    postures.push_back(branch.q);
    predicted.push_back(planner::scoreVisit(placed, hole.plan.p_WH, branch));
    happened.push_back(score.steps);
  }

  const app::Cell& cell_;
  planner::Workcell model_;
  app::TruthMaker truths_;
  HiddenPhysics hidden_;
  std::vector<calibration::TouchPlan> candidates_;
  std::vector<int> kinds_;
  int touches_, holes_;
};

/// Predicted and observed fractions of holes per number of inserted steps, with the standard error of their difference,
/// estimated from the scatter between true arms.
struct StepChanceSummary {
  int calibrated = 0, holes = 0;
  std::array<double, kBins> predicted{}, happened{}, standard_error{};
};

inline StepChanceSummary summaryOf(const std::vector<StepChanceTrial>& trials) {
  StepChanceSummary sum;
  for (const auto& trial : trials) {
    sum.calibrated += trial.is_calibrated;
    sum.holes += trial.holes;
    for (std::size_t b = 0; b < kBins; ++b) {
      sum.predicted[b] += trial.predicted[b];
      sum.happened[b] += trial.happened[b];
      const double off = trial.predicted[b] - trial.happened[b];
      sum.standard_error[b] += off * off;
    }
  }
  for (std::size_t b = 0; b < kBins; ++b) {
    sum.predicted[b] /= std::max(1, sum.holes);
    sum.happened[b] /= std::max(1, sum.holes);
    sum.standard_error[b] = std::sqrt(sum.standard_error[b]) / std::max(1, sum.holes);
  }
  return sum;
}

}  // namespace tubeplan::testing
