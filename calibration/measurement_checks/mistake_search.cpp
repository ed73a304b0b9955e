#include "calibration/measurement_checks/mistake_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "calibration/measurement_checks/joined_mistakes.hpp"
#include "calibration/measurement_checks/joint_zero.hpp"
#include "calibration/measurement_checks/step_search.hpp"
#include "calibration/measurements/reading_problems.hpp"

namespace tubeplan::calibration {

namespace {

constexpr double kLeastFall = 3;      // of the error by the drawing, at least, that a mistake explains
constexpr double kOdds = 14;          // log of a million
constexpr double kDrastic = 8;        // fall of the error by the drawing that no fit of the drawing is a reason for
constexpr double kAsGood = 3;         // log of the odds within which another mistake explains the readings as well
constexpr double kAsGoodError = 1.5;  // times the error, for the same
constexpr double kNoisePerRow = 0.6;  // lack of fit of a row by noise alone
constexpr double kFits = 0.05;        // of the reach: readings with a larger error yet are not mended
constexpr double kLeftOver = 0.001;   // of the reach: an error that one mistake leaves asks for several
constexpr double kMostAtNoise = 2;    // chi-square for each degree of freedom that noise alone may leave
constexpr std::size_t kFinalists = 8;
constexpr double kLimitSlack = 0.05;    // rad or m past a joint's limit
constexpr double kShareOutside = 0.02;  // of readings past limits, that no hypothesis may have

class MistakeSearch {
 public:
  explicit MistakeSearch(const MistakeTrials& trials) : trials_(trials) {}

  [[nodiscard]] std::optional<MeasurementCheck> find() const {
    if (!asksForMistakes() && !asksForSteps()) return std::nullopt;
    auto suspects = asksForMistakes() ? examined(screened()) : std::vector<Suspect>{};
    const auto tried = suspects;
    std::erase_if(suspects, [&](const Suspect& suspect) { return !explainsError(suspect) && !explainsBase(suspect); });
    if (std::ranges::none_of(suspects, [](const Suspect& suspect) { return isAtNoise(suspect); })) {
      auto begun = examined(withSteps(tried, isLeftOver(suspects)));
      std::erase_if(begun, [&](const Suspect& suspect) { return !explainsError(suspect) || !isAllNeeded(suspect); });
      std::ranges::move(begun, std::back_inserter(suspects));
    }
    if (isLeftOver(suspects)) {
      auto joined = examined(screenedTogether());
      std::erase_if(joined, [&](const Suspect& suspect) { return !explainsError(suspect) || !isAllNeeded(suspect); });
      std::ranges::move(joined, std::back_inserter(suspects));
    }
    if (suspects.empty()) return std::nullopt;
    std::ranges::stable_sort(suspects, std::greater{}, [&](const Suspect& suspect) { return merit(suspect); });
    Suspect& best = suspects.front();
    MeasurementCheck check;
    check.name = best.mend.mistake;
    check.assume = best.mend.mistake + "=" + best.mend.value;
    settleSigma(best, check);
    const bool is_of_error = explainsError(best);
    check.severity = is_of_error && isDetermined(best.mend) ? CheckSeverity::kMistake : CheckSeverity::kRemark;
    check.sentence = best.mend.sentence + (best.mend.change_sigma ? "; the unit of sigma with it" : "") +
                     (is_of_error ? "" : ", or the base stands far from its nominal place (" + baseText(trials_) + ")");
    stateErrors(best, check);
    for (std::size_t k = 1; k < suspects.size(); ++k)
      if (suspects[k].parts.size() <= best.parts.size() && gainOf(suspects[k]) > gainOf(best) - kAsGood &&
          suspects[k].drawn.error < kAsGoodError * best.drawn.error)
        check.equally.push_back(suspects[k].mend.mistake + "=" + suspects[k].mend.value);
    return check;
  }

 private:
  struct Suspect {
    JoinedMends parts;
    Mend mend;
    Trial drawn, open;
  };

  /// The suspects by all that is open, but for those that cannot be fitted so.
  std::vector<Suspect> examined(std::vector<Suspect> suspects) const {
    for (auto& suspect : suspects) {
      const double held_error = suspect.drawn.error;
      suspect.drawn = trials_.tried(suspect.mend, TrialDepth::kDrawn);
      suspect.drawn.held_error = held_error;
      suspect.open = trials_.tried(suspect.mend, TrialDepth::kOpen);
    }
    std::erase_if(suspects, [](const Suspect& suspect) { return !suspect.open.ok; });
    return suspects;
  }

  /// What a suspect explains, less what a choice among many readings has against it ...
  [[nodiscard]] double gainOf(const Suspect& suspect) const {
    return trials_.gain(suspect.open) - suspect.mend.against;
  }
  /// ... and less what each further mistake has against it beforehand.
  [[nodiscard]] double merit(const Suspect& suspect) const {
    return gainOf(suspect) - kOdds * static_cast<double>(suspect.parts.size() - 1);
  }

  /// Whether the readings are left with no more than their noise.
  [[nodiscard]] static bool isAtNoise(const Suspect& suspect) { return suspect.open.chi2_per_freedom < kMostAtNoise; }

  /// The steps that the readings as they are ask for and, of mistakes with steps beside them, those as each suspect has
  /// them.
  std::vector<Suspect> withSteps(const std::vector<Suspect>& suspects, bool beside) const {
    std::vector<Suspect> begun;
    const auto add = [&](const JoinedMends& parts, const Mend& before, const PlacedArm& fitted) {
      for (Mend& step : likelySteps(trials_, before, fitted)) {
        Suspect suspect{parts, {}, {}, {}};
        suspect.parts.push_back(std::move(step));
        suspect.mend = joined(suspect.parts);
        suspect.drawn = trials_.tried(suspect.mend, TrialDepth::kHeld);
        begun.push_back(std::move(suspect));
      }
    };
    if (trials_.asIs().ok) add({}, {}, trials_.asIs().placed);
    if (beside)
      for (const Suspect& suspect : suspects)
        if (!suspect.mend.parts_setups) add(suspect.parts, suspect.mend, suspect.open.placed);
    return begun;
  }

  /// Whether no single mistake brings the error near what a model may be off by.
  [[nodiscard]] bool isLeftOver(const std::vector<Suspect>& suspects) const {
    double left = trials_.asIs().ok ? trials_.asIs().open_error : std::numeric_limits<double>::infinity();
    for (const auto& suspect : suspects) left = std::min(left, suspect.open.error);
    return left > std::max(kLeftOver * trials_.reach(), kLeastFall * trials_.noise({}));
  }

  /// Whether each of several mistakes does what a single one is asked for, beside the others.
  [[nodiscard]] bool isAllNeeded(const Suspect& suspect) const {
    for (std::size_t k = 0; suspect.parts.size() > 1 && k < suspect.parts.size(); ++k) {
      auto parts = suspect.parts;
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
      const Mend others = joined(parts);
      const Trial open = trials_.tried(others, TrialDepth::kOpen);
      if (!open.ok) continue;
      const Trial held = trials_.tried(others, TrialDepth::kHeld);
      const bool falls = suspect.parts[k].against > 0 || held.error >= kLeastFall * suspect.drawn.held_error ||
                         open.error >= kLeastFall * suspect.open.error;
      if (!falls || trials_.gain(suspect.open) - trials_.gain(open) - suspect.parts[k].against < kOdds) return false;
    }
    return true;
  }

  /// Whether there is an error that a mistake could explain, or a base that one could have moved.
  [[nodiscard]] bool asksForMistakes() const {
    if (!trials_.asIs().ok) return true;
    const double noise = trials_.noise({});
    if (trials_.asIs().whole_error > kFits * trials_.reach()) return true;  // of a part of the readings
    const bool is_bent =
        trials_.asIs().held_error > kDrastic * trials_.asIs().open_error;  // only a drawing bent to them fits
    return trials_.isBaseFar() || (trials_.asIs().held_error > kLeastFall * noise && (isLackOfFit() || is_bent));
  }

  /// Whether there is an error that a step of a few sigmas could make.
  [[nodiscard]] bool asksForSteps() const {
    constexpr double kMoreThanNoise = 1.5;  // chi-square for each degree of freedom
    return isLackOfFit() || trials_.asIs().chi2_per_freedom > kMoreThanNoise;
  }

  [[nodiscard]] bool isLackOfFit() const {
    double rows = 0;
    for (const auto& reading : trials_.checked().readings)
      if (trials_.pool().counted.contains(reading.id)) rows += rowsOf(reading);
    return trials_.asIs().lack_of_fit - kNoisePerRow * rows > kOdds;
  }

  /// Noise whose column says the same wrong unit is mended with the rest, unless the readings agree better with it as
  /// it stands: somebody may have written it apart.
  void settleSigma(Suspect& best, MeasurementCheck& check) const {
    if (!best.mend.change_sigma) return;
    Mend apart = best.mend;
    apart.change_sigma = nullptr;
    const Trial trial = trials_.tried(apart, TrialDepth::kOpen);
    const auto offBy = [](const Trial& of) { return std::abs(std::log(of.chi2_per_freedom)); };
    if (!trial.ok || !(offBy(trial) < offBy(best.open))) return;
    const auto kind = std::ranges::find_if(mistakeKinds(), [](const auto& other) { return other.settles_sigma; });
    check.assume += fmt::format(",{}={}", kind->name, trials_.checked().units.sigma.name);
    best.mend = std::move(apart);
    best.open = trial;
  }

  bool isWithinLimits(const Mend& mend) const {
    auto readings = trials_.pool().readings;
    mend.apply(readings);
    const auto outside = [&](const std::vector<Measurement>& set) {
      std::size_t count = 0;
      for (const auto& reading : set)
        for (int j = 0; j < reading.q.size(); ++j) {
          const auto& joint = trials_.checked().start.arm.joint(j);
          if (reading.q[j] < joint.lower - kLimitSlack || reading.q[j] > joint.upper + kLimitSlack) {
            ++count;
            break;
          }
        }
      return count;
    };
    return !readings.empty() &&
           static_cast<double>(outside(readings)) <=
               kShareOutside * static_cast<double>(readings.size()) +
                   (mend.zeros_of.empty() && outside(trials_.pool().readings) > outside(readings) ? 1e9 : 0);
  }

  /// The zero as the readings have it best, from the value tried; nothing where that is no mistake. The first joint's
  /// zero and a base that is not known are one for the readings: it is looked for with the base where it nominally is.
  std::optional<JoinedMends> withZerosFound(JoinedMends parts) const {
    const Mend from = joined(parts);
    if (from.zeros_of.empty()) return parts;
    PlacedArm start = trials_.startOf(from);
    if (std::ranges::find(from.zeros_of, 0) != from.zeros_of.end())
      for (auto& base_pose : start.base_poses) base_pose.is_known = true;
    std::vector<std::string> names;
    for (const int joint : from.zeros_of) names.push_back(offsetOf(joint));
    const auto best = trials_.fitZeros(from, std::move(start), names);
    if (!best.ok) return std::nullopt;
    for (Mend& part : parts) {
      if (part.zeros_of.empty()) continue;
      auto found = zeroFound(part, best.placed.arm);
      if (!found) return std::nullopt;
      part = std::move(*found);
    }
    return parts;
  }

  /// The name of a joint's zero among the numbers of the arm.
  [[nodiscard]] std::string offsetOf(int joint) const {
    const auto& arm = trials_.checked().start.arm;
    const int row = deflection::activeRows(arm)[static_cast<std::size_t>(joint)];
    return arm.rows[static_cast<std::size_t>(row)].name + ".joint.offset";
  }

  std::optional<Mend> zeroFound(const Mend& from, const deflection::Arm& fitted) const {
    const int joint = from.zeros_of.front();
    const auto before = deflection::findParameter(trials_.checked().start.arm, offsetOf(joint)),
               after = deflection::findParameter(fitted, offsetOf(joint));
    if (!before || !after) return std::nullopt;
    const double tried = std::stod(partedAtColon(from.value).second) * trials_.checked().units.angles.factor;
    double zero = std::remainder(tried + after->value - before->value, 2 * std::numbers::pi);
    constexpr double kQuarter = std::numbers::pi / 2, kNearQuarter = 0.035;
    if (const double whole = std::round(zero / kQuarter) * kQuarter;
        whole != 0 && std::abs(zero - whole) < kNearQuarter)
      zero = whole;
    if (std::abs(zero) < mistakes::joint_zero::kLeast) return std::nullopt;
    return mistakes::joint_zero::mend(trials_.checked(), mistakes::joint_zero::textOf(trials_.checked(), joint, zero));
  }

  std::vector<Suspect> screened() const {
    std::vector<Suspect> suspects;
    for (const auto& kind : mistakeKinds())
      for (const auto& value : kind.values(trials_.checked())) {
        goOn(trials_.options().stop);
        auto mend = kind.mend(trials_.checked(), value);
        if (mend) screen({std::move(*mend)}, suspects);
      }
    return foremost(std::move(suspects));
  }

  std::vector<Suspect> screenedTogether() const {
    std::vector<Suspect> suspects;
    for (auto& parts : likelyTogether(trials_)) {
      goOn(trials_.options().stop);
      screen(std::move(parts), suspects);
    }
    return foremost(std::move(suspects));
  }

  /// Adds a hypothesis with its trial by the drawing, unless it is none or has been tried.
  void screen(JoinedMends tried, std::vector<Suspect>& suspects) const {
    auto parts = withZerosFound(std::move(tried));
    if (!parts) return;
    Mend mend = joined(*parts);
    if (!isWithinLimits(mend)) return;
    if (!mend.zeros_of.empty() && std::any_of(suspects.begin(), suspects.end(), [&](const Suspect& other) {
          return other.mend.mistake == mend.mistake && other.mend.value == mend.value;
        }))
      return;
    Trial trial = trials_.tried(mend, TrialDepth::kHeld);
    if (trial.ok) suspects.push_back({std::move(*parts), std::move(mend), std::move(trial), {}});
  }

  /// Those by which the drawing fits best.
  std::vector<Suspect> foremost(std::vector<Suspect> suspects) const {
    const std::size_t kept = std::min(kFinalists, suspects.size());
    std::partial_sort(suspects.begin(), suspects.begin() + static_cast<std::ptrdiff_t>(kept), suspects.end(),
                      [&](const Suspect& a, const Suspect& b) {
                        return a.drawn.lack_of_fit - gainByShrinking(a.drawn) <
                               b.drawn.lack_of_fit - gainByShrinking(b.drawn);
                      });
    suspects.resize(kept);
    return suspects;
  }

  double gainByShrinking(const Trial& trial) const {
    return -3 * static_cast<double>(trials_.pool().counted_quickly.size()) * std::log(trials_.shrinkage(trial));
  }

  /// Whether a mend has numbers that are fitted: what others take off the error is no fit.
  static bool hasNumbers(const Mend& mend) { return mend.frees_base || mend.parts_setups || mend.numbers_fitted > 0; }

  /// Whether so many readings could contradict a mend that is fitted to them, or that leaves some of them out.
  [[nodiscard]] bool isDetermined(const Mend& mend) const {
    constexpr int kLeastFreedom = 6;
    auto readings = trials_.pool().readings;
    const std::size_t all = readings.size();
    mend.apply(readings);
    if (!hasNumbers(mend) && readings.size() == all) return true;
    const auto start = trials_.startOf(mend);
    const auto bases = std::count_if(start.base_poses.begin(), start.base_poses.end(),
                                     [](const auto& base_pose) { return !base_pose.is_known; });
    return numbersMeasured(readings) - 6 * static_cast<int>(bases) - mend.numbers_fitted >= kLeastFreedom;
  }

  [[nodiscard]] bool explainsError(const Suspect& suspect) const {
    if (std::min(suspect.drawn.error, suspect.open.error) >= kFits * trials_.reach()) return false;
    if (!trials_.asIs().ok) return suspect.drawn.error < kFits * trials_.reach();
    const double shrinks = trials_.shrinkage(suspect.drawn);
    const auto falls = [&](double as_is, double mended) { return as_is >= kLeastFall * mended * shrinks; };
    // A step that leaves the noise alone, and that no creep explains (step_search.hpp), may be smaller.
    if (suspect.mend.against > 0 && isAtNoise(suspect) && gainOf(suspect) >= kOdds) return true;
    // A base is one for all readings: one that has slipped is none for those before.
    if (suspect.mend.frees_base && !falls(trials_.asIs().whole_error, suspect.open.whole_error)) return false;
    if (!hasNumbers(suspect.mend) && trials_.gain(suspect.open) > 0 &&
        trials_.asIs().held_error >= kDrastic * suspect.drawn.held_error * shrinks)
      return true;
    // A part that is mended fits as the others do, or it was another mistake.
    if (suspect.mend.is_of_part && trials_.gain(suspect.open) >= kOdds &&
        trials_.asIs().whole_error >= kDrastic * suspect.open.whole_error * shrinks &&
        suspect.open.whole_error < kLeastFall * suspect.open.error)
      return true;
    return gainOf(suspect) >= kOdds && (falls(trials_.asIs().error, suspect.drawn.error) ||
                                        falls(trials_.asIs().held_error, suspect.drawn.held_error) ||
                                        falls(trials_.asIs().open_error, suspect.open.error));
  }

  [[nodiscard]] bool explainsBase(const Suspect& suspect) const {
    constexpr double kBack = 4, kHarm = 1.5;
    if (!trials_.asIs().ok || !trials_.isBaseFar()) return false;
    const bool turns_back =
        trials_.asIs().base_turn > kFarTurn && trials_.asIs().base_turn >= kBack * suspect.drawn.base_turn;
    const bool shifts_back = trials_.asIs().base_shift > kFarShift * trials_.reach() &&
                             trials_.asIs().base_shift >= kBack * suspect.drawn.base_shift;
    const bool is_near = suspect.drawn.base_turn < kFarTurn && suspect.drawn.base_shift < kFarShift * trials_.reach();
    return (turns_back || shifts_back) && is_near && suspect.drawn.error <= kHarm * trials_.asIs().error &&
           trials_.gain(suspect.open) >= kOdds;
  }

  /// The errors that fall most: by the drawing, with the tip as drawn, or with all that is open; of a part of the
  /// readings those of all, as the part may be what others leave out. A fit with as many numbers as the readings hold
  /// says nothing of an error, and no fit says that it is below the noise.
  void stateErrors(const Suspect& best, MeasurementCheck& check) const {
    struct Fall {
      TrialDepth depth;
      double as_is, mended;
    };
    const Trial& as_is = trials_.asIs();
    std::vector<Fall> falls = {{TrialDepth::kDrawn, as_is.error, best.drawn.error},
                               {TrialDepth::kHeld, as_is.held_error, best.drawn.held_error},
                               {TrialDepth::kOpen, as_is.open_error, best.open.error}};
    if (best.mend.is_of_part) falls.push_back({TrialDepth::kOpen, as_is.whole_error, best.open.whole_error});
    std::erase_if(falls, [&](const Fall& fall) { return trials_.freedom(best.mend, fall.depth) <= 0; });
    if (falls.empty()) return;
    for (Fall& fall : falls) {
      fall.as_is = std::max(fall.as_is, trials_.noise({}));
      fall.mended = std::max(fall.mended, trials_.noise(best.mend));
    }
    const Fall& most = *std::ranges::max_element(falls, {}, [](const Fall& fall) { return fall.as_is / fall.mended; });
    if (as_is.ok) check.error_as_is = most.as_is;
    check.error_if_mended = most.mended;
  }

  const MistakeTrials& trials_;
};

}  // namespace

std::optional<MeasurementCheck> findMistake(const MistakeTrials& trials) { return MistakeSearch(trials).find(); }

std::string baseText(const MistakeTrials& trials) {
  const CheckedReadings& checked = trials.checked();
  const Trial& trial = trials.asIs();
  const auto& length = checked.units.coordinates;
  const bool has_pitch = checked.sheet && checked.sheet->pitch > 0;
  return fmt::format("{:.3g} {}{} and {:.2g} deg", trial.base_shift / length.factor, length.name,
                     has_pitch ? fmt::format(" ({:.1f} pitches)", trial.base_shift / checked.sheet->pitch) : "",
                     trial.base_turn * 180 / std::numbers::pi);
}

}  // namespace tubeplan::calibration
