#include "calibration/measurement_checks/step_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "calibration/measurement_checks/from_measurement.hpp"
#include "calibration/measurement_checks/row_comparison.hpp"
#include "calibration/measurement_checks/station_change.hpp"
#include "calibration/measurement_checks/step_scan.hpp"

namespace tubeplan::calibration {

namespace {

using Eigen::VectorXd;

constexpr std::size_t kMostSteps = 3;  // maximum number of steps that are proposed for the measurements as stated
constexpr int kTurns = 4;              // maximum number of passes: fit of the size, then search for the measurement
constexpr double kBeyondCreep = 5;     // smallest log odds of a step against a creep
constexpr double kDrasticFall = 8;     // a step that reduces the error by more than this factor cannot be a creep

class StepSearch {
 public:
  StepSearch(const MistakeTrials& trials, const Correction& before, const Trial& without)
      : trials_(trials), before_(before), without_(without) {
    for (const auto& kind : mistakeKinds())
      if (kind.steps)
        for (auto& form : kind.steps(trials.checked())) {
          forms_.push_back(std::move(form));
          kinds_.push_back(&kind);
        }
    all_ = trials.checked().measurements;
    before_.apply(all_);
  }

  std::vector<Correction> find() {
    const auto measurements = trials_.corrected(before_, TrialDepth::kOpen);
    const StepScan scan(without_.placed, trials_.open(), measurements, forms_);
    if (!scan.ok()) return {};
    const double creep = scan.bestDrift();
    double rival = creep;
    std::vector<Correction> found = changesOfStation(measurements);
    for (const FoundStep& step : scan.steps()) {
      if (found.size() == (before_.mistake.empty() ? kMostSteps : 1) || step.merit <= 0) break;
      if (forms_[step.form].is_effect) {
        rival = std::max(rival, step.merit);
        continue;
      }
      auto correction = refined(step, measurements[step.measurement].id);
      if (!correction || std::ranges::count(found, correction->value, &Correction::value) > 0) continue;
      if (step.merit < rival + kBeyondCreep && !isDrastic(*correction)) continue;
      found.push_back(std::move(*correction));
    }
    return found;
  }

 private:
  /// Returns the steps of bases that are too far for a linear scan, at most one of each set-up.
  [[nodiscard]] std::vector<Correction> changesOfStation(const std::vector<Measurement>& measurements) const {
    std::vector<Correction> found;
    for (std::size_t f = 0; f < forms_.size(); ++f) {
      if (!forms_[f].setup) continue;
      const auto first = stationChange(trials_.checked().start, measurements, *forms_[f].setup);
      if (!first) continue;
      auto correction = refined({f, *first, 0, VectorXd::Zero(forms_[f].numbers)}, measurements[*first].id);
      if (correction && isDrastic(*correction) && (!forms_[f].is_effect || isBeyondEffect(*correction)))
        found.push_back(std::move(*correction));
    }
    return found;
  }

  /// Returns true if a base was displaced by more than any slip: the tracker was set up again.
  [[nodiscard]] bool isBeyondEffect(const Correction& correction) const {
    constexpr double kMostShift = 0.1, kMostTurn = 0.1;  // five times the largest usual slip of a base [m, rad]
    const Trial fit = trials_.tried(joined({before_, correction}), TrialDepth::kOpen);
    if (!fit.ok || !correction.new_setup) return false;
    const auto within = std::ranges::find(fit.placed.base_poses, correction.new_setup->within, &BasePose::setup);
    const Eigen::Isometry3d by = fit.placed.base_poses.back().X_WB * within->X_WB.inverse();
    const double turn = Eigen::AngleAxisd(by.linear()).angle();
    return turn > kMostTurn || (by * within->X_WB.translation() - within->X_WB.translation()).norm() > kMostShift;
  }

  [[nodiscard]] bool isDrastic(const Correction& correction) const {
    const Trial with = trials_.tried(joined({before_, correction}), TrialDepth::kOpen);
    return with.ok && without_.whole_error >= kDrasticFall * with.whole_error;
  }

  [[nodiscard]] std::optional<Correction> correctionOf(std::size_t form, const VectorXd& size,
                                                       const std::string& from) const {
    auto correction = kinds_[form]->correction(trials_.checked(), forms_[form].value(size, from));
    if (correction)
      correction->against = priceOfStep(forms_[form].numbers, trials_.corrected(before_, TrialDepth::kOpen));
    return correction;
  }

  /// Refines the size and the first measurement of a step by alternating between a fit of the size and a search for the
  /// measurement; nullopt if a fit fails.
  [[nodiscard]] std::optional<Correction> refined(const FoundStep& step, std::string from) const {
    VectorXd size = step.size;
    auto correction = correctionOf(step.form, size, from);
    for (int turn = 0; turn < kTurns && correction; ++turn) {
      throwIfStopped(trials_.options().stop);
      const Correction both = joined({before_, *correction});
      const Trial fit = trials_.tried(both, TrialDepth::kOpen);
      if (!fit.ok) return std::nullopt;
      const auto measurements = trials_.corrected(both, TrialDepth::kOpen);
      if (!correction->new_setup) size += change(step.form, size, fit.placed, measurements, from);
      const std::string best_start = beginning(step.form, size, from, fit);
      const bool is_settled = best_start == from && turn > 0;
      from = best_start;
      correction = correctionOf(step.form, size, from);
      if (is_settled) break;
    }
    return correction;
  }

  /// Returns the change of the step's size in a linear fit of the size and all open parameters.
  [[nodiscard]] VectorXd change(std::size_t form, const VectorXd& size, const PlacedArm& placed,
                                const std::vector<Measurement>& measurements, const std::string& from) const {
    const auto ids = idsFrom(all_, from);
    const std::vector<StepForm> forms{forms_[form]};
    const StepScan scan(placed, trials_.open(), measurements, forms);
    const auto first = std::ranges::find_if(measurements, [&](const auto& m) { return ids.contains(m.id); });
    if (!scan.ok() || first == measurements.end()) return VectorXd::Zero(size.size());
    return scan.sizeAt(0, static_cast<std::size_t>(first - measurements.begin()));
  }

  /// Returns the id of the measurement for which the errors are smallest if the step begins there.
  [[nodiscard]] std::string beginning(std::size_t form, const VectorXd& size, const std::string& from,
                                      const Trial& fit) const {
    std::vector<std::size_t> members;
    for (std::size_t k = 0; k < all_.size(); ++k)
      if (!forms_[form].setup || *forms_[form].setup == all_[k].setup) members.push_back(k);
    if (members.size() < 2 * kFewestOfStep) return from;
    const auto correction = correctionOf(form, size, all_[members.front()].id);
    auto stepped = all_;
    PlacedArm placed = fit.placed;
    if (correction) {
      correction->change(stepped);
      // The set-up that begins with the step has the same base as the fitted set-up, under another name.
      if (correction->new_setup && !placed.base_poses.empty())
        placed.base_poses.back().setup = correction->new_setup->name;
    }
    RowErrors without(placed, all_), with(placed, stepped);
    const double scale = fit.open_error / std::sqrt(3.);
    const auto cost = [&](double error) { return std::log1p(error * error / (4 * scale * scale)); };
    double sum = 0, least = std::numeric_limits<double>::infinity();
    std::string best = from;
    for (std::size_t m = members.size(); m-- > kFewestOfStep;) {
      const std::size_t k = members[m];
      const double by_step = cost(with.at(k)) - cost(without.at(k));
      if (std::isfinite(by_step)) sum += by_step;
      if (members.size() - m >= kFewestOfStep && sum < least) least = sum, best = all_[k].id;
    }
    return best;
  }

  const MistakeTrials& trials_;
  Correction before_;
  const Trial& without_;
  std::vector<StepForm> forms_;
  std::vector<const MistakeKind*> kinds_;
  std::vector<Measurement> all_;
};

}  // namespace

std::vector<Correction> likelySteps(const MistakeTrials& trials, const Correction& before, const Trial& open) {
  return StepSearch(trials, before, open).find();
}

}  // namespace tubeplan::calibration
