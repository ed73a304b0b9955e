#include "calibration/measurement_checks/measurement_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <set>

#include "calibration/measurement_checks/joint_zero.hpp"
#include "calibration/measurement_checks/plain_checks.hpp"
#include "calibration/measurement_checks/robust_fit.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/reading_prediction.hpp"
#include "calibration/random_stream.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

namespace {

constexpr double kLeastFall = 3;      // of the error by the drawing, at least, that a mistake explains
constexpr double kOdds = 14;          // log of a million
constexpr double kDrastic = 8;        // fall of the error by the drawing that no fit of the drawing is a reason for
constexpr double kAsGood = 3;         // log of the odds within which another mistake explains the readings as well
constexpr double kAsGoodError = 1.5;  // times the error, for the same
constexpr double kNoisePerRow = 0.6;  // lack of fit of a row by noise alone
constexpr double kFarTurn = 0.35;     // rad, of the base from its nominal place
constexpr double kFarShift = 0.25;    // of the arm's reach, the same
constexpr double kUsualTurn = 0.05;   // rad, and ...
constexpr double kUsualShift = 0.05;  // ... of the reach: what bases are usually off by
constexpr std::size_t kQuickReadings = 40;
constexpr std::size_t kFinalists = 8;
constexpr double kLimitSlack = 0.05;    // rad or m past a joint's limit
constexpr double kShareOutside = 0.02;  // of readings past limits, that no hypothesis may have

/// Indices of the readings to look at: all, or whole groups drawn by the seed; touches of one unknown point are a
/// group.
std::vector<std::size_t> drawReadings(const std::vector<Measurement>& readings, std::size_t most, std::uint64_t seed) {
  std::map<std::string, std::vector<std::size_t>> points;
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t k = 0; k < readings.size(); ++k)
    if (touchesUnknownPoint(readings[k]))
      points[readings[k].point].push_back(k);
    else
      groups.push_back({k});
  for (auto& [point, members] : points) groups.push_back(std::move(members));
  std::vector<std::size_t> drawn;
  if (readings.size() > most) RandomStream(seed).shuffle(groups);
  for (const auto& group : groups) {
    if (!drawn.empty() && drawn.size() + group.size() > most) continue;
    drawn.insert(drawn.end(), group.begin(), group.end());
  }
  std::sort(drawn.begin(), drawn.end());
  return drawn;
}

/// The drawn readings with their neighbours, for mistakes of the order; ids say which are counted.
struct Pool {
  std::vector<Measurement> readings;
  std::set<std::string> counted, counted_quickly;
};

Pool poolOf(const std::vector<Measurement>& readings, const CheckOptions& options) {
  Pool pool;
  std::set<std::size_t> kept;
  const auto drawn = drawReadings(readings, options.most_readings, options.seed);
  std::vector<Measurement> of_drawn;
  for (const std::size_t k : drawn) {
    pool.counted.insert(readings[k].id);
    of_drawn.push_back(readings[k]);
    for (const std::size_t near : {k - 1, k, k + 1})
      if (near < readings.size()) kept.insert(near);
  }
  for (const std::size_t k : drawReadings(of_drawn, kQuickReadings, options.seed))
    pool.counted_quickly.insert(of_drawn[k].id);
  for (const std::size_t k : kept) {
    pool.readings.push_back(readings[k]);
    pool.readings.back().is_held_out = false;
  }
  return pool;
}

std::vector<Measurement> only(std::vector<Measurement> readings, const std::set<std::string>& ids) {
  std::erase_if(readings, [&](const Measurement& reading) { return !ids.contains(reading.id); });
  return readings;
}

/// Everything that the drawing leaves open: what the cell frees, all geometry, and every stiffness by one number.
FreeChoice allThatIsOpen(const CheckedReadings& checked) {
  FreeChoice open = checked.free;
  open.base = true;  // of base poses that are not known
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  PlacedArm placed = checked.start;
  for (const auto& unknown : chooseUnknowns(placed, checked.free).list)
    if (unknown.owner == Unknown::Owner::kArm) add(unknown.name);
  for (const auto& parameter : deflection::parametersOf(checked.start.arm))
    if (parameter.path.effect < 0 && deflection::isStiffness(parameter.quantity) &&
        parameter.quantity != deflection::Quantity::kPressure)
      add(parameter.name);
  std::erase_if(names, [&](const std::string& name) {
    const auto geometry = namesBehind(checked.start.arm, "geometry");
    return std::find(geometry.begin(), geometry.end(), name) != geometry.end();
  });
  names.push_back("geometry");
  open.names = names;
  return open;
}

double shiftOf(const PlacedArm& found, const PlacedArm& nominal, std::size_t p) {
  return (found.base_poses[p].X_WB.translation() - nominal.base_poses[p].X_WB.translation()).norm();
}

double turnOf(const PlacedArm& found, const PlacedArm& nominal, std::size_t p) {
  const Eigen::Matrix3d turn = found.base_poses[p].X_WB.linear() * nominal.base_poses[p].X_WB.linear().transpose();
  return Eigen::AngleAxisd(turn).angle();
}

/// Of the readings as they are or as one mistake would have them.
struct Trial {
  bool ok = false;
  double error = std::numeric_limits<double>::infinity();        // m, by the drawing, base and tip free
  double held_error = error;                                     // m, the same with the tip as drawn
  double open_error = error;                                     // m, with all that the drawing leaves open
  double whole_error = error;                                    // m, the same of all readings
  double lack_of_fit = std::numeric_limits<double>::infinity();  // with the base's prior
  double base_shift = 0, base_turn = 0;                          // of the base from its nominal place; the largest
  double chi2_per_freedom = kNoFigure;
  double extent = 0;  // m, of predicted tips that touched unknown points
  PlacedArm placed;
};

class Checking {
 public:
  Checking(const CheckedReadings& checked, const CheckOptions& options)
      : checked_(checked),
        options_(options),
        pool_(poolOf(checked.readings, options)),
        open_(allThatIsOpen(checked)),
        drawn_{{"tool.tip"}, true, checked.free.priors},
        held_{{}, true, checked.free.priors},
        reach_(deflection::reachOf(checked.start.arm)),
        has_places_(std::any_of(checked.readings.begin(), checked.readings.end(),
                                [](const Measurement& reading) { return statesPlace(reading); })) {}

  MeasurementChecks run() {
    MeasurementChecks result;
    result.missing = missingColumns(checked_.readings);
    if (checked_.readings.empty()) return result;
    as_is_ = tried({}, Depth::kOpen);
    const Trial drawn = tried({}, Depth::kDrawn);
    as_is_.error = drawn.error;
    // What is open besides would share the base's way: by the drawing it has all of it.
    as_is_.base_shift = drawn.base_shift;
    as_is_.base_turn = drawn.base_turn;
    as_is_.held_error = tried({}, Depth::kHeld).error;
    result.base_shift = as_is_.base_shift;
    result.base_turn = as_is_.base_turn;
    if (as_is_.ok) checkSigma(result.checks);
    if (asksForMistakes()) searchMistakes(result.checks);
    const bool is_mistaken = grossMistake(result) != nullptr;
    if (as_is_.ok && !is_mistaken) {
      checkBase(result.checks);
      if (auto far = placesOutOfReach(checked_, as_is_.placed)) result.checks.push_back(std::move(*far));
      for (auto& hole : mistakenHoles(checked_, as_is_.placed)) result.checks.push_back(std::move(hole));
    }
    for (auto& plain : plainChecks(checked_, result.checks)) result.checks.push_back(std::move(plain));
    return result;
  }

 private:
  enum class Depth { kHeld, kDrawn, kOpen };

  /// The drawing with the base free where it is not known, with the tip besides, or with all that is open.
  RobustFit fit(PlacedArm start, const std::vector<Measurement>& readings, Depth depth,
                const std::string& zero = "") const {
    RobustFitOptions options;
    options.free = depth == Depth::kOpen ? open_ : depth == Depth::kDrawn ? drawn_ : held_;
    options.most_steps = depth == Depth::kOpen ? 8 : 5;
    options.judges_noise = depth == Depth::kOpen;
    options.stop = options_.stop;
    if (!zero.empty()) {
      options.free.names.push_back(zero);
      options.free.priors.named[zero] = std::numbers::pi;
    }
    return fitRobustly(std::move(start), readings, options);
  }

  std::vector<Measurement> mended(const Mend& mend, Depth depth) const {
    auto readings = pool_.readings;
    mend.apply(readings);
    return only(std::move(readings), depth == Depth::kOpen ? pool_.counted : pool_.counted_quickly);
  }

  PlacedArm startOf(const Mend& mend) const {
    PlacedArm start = checked_.start;
    if (mend.frees_base)
      for (auto& base_pose : start.base_poses) base_pose.is_known = false;
    return start;
  }

  Trial tried(const Mend& mend, Depth depth) const {
    if (mend.parts_setups) return triedApart(depth);
    return judged(fit(startOf(mend), mended(mend, depth), depth), mended(mend, depth));
  }

  Trial judged(const RobustFit& fit, const std::vector<Measurement>& readings) const {
    Trial trial;
    trial.ok = fit.ok;
    if (!fit.ok) return trial;
    trial.error = trial.open_error = fit.error;
    trial.whole_error = fit.whole_error;
    trial.lack_of_fit = fit.lack_of_fit;
    trial.chi2_per_freedom = fit.chi2_per_freedom;
    trial.placed = fit.placed;
    for (std::size_t p = 0; p < fit.placed.base_poses.size(); ++p) {
      const double shift = shiftOf(fit.placed, checked_.start, p), turn = turnOf(fit.placed, checked_.start, p);
      trial.lack_of_fit +=
          3.5 * std::log1p(std::pow(shift / (kUsualShift * reach_), 2) + std::pow(turn / kUsualTurn, 2));
      trial.base_shift = std::max(trial.base_shift, shift);
      trial.base_turn = std::max(trial.base_turn, turn);
    }
    trial.extent = extentOfTips(fit.placed, readings);
    return trial;
  }

  /// Each set-up by a fit of its own, a tip among its numbers.
  Trial triedApart(Depth depth) const {
    Trial whole;
    whole.ok = true;
    whole.lack_of_fit = 0;
    double squares = 0;
    std::size_t count = 0;
    for (const auto& base_pose : checked_.start.base_poses) {
      auto readings = only(pool_.readings, depth == Depth::kOpen ? pool_.counted : pool_.counted_quickly);
      std::erase_if(readings, [&](const Measurement& reading) { return reading.setup != base_pose.setup; });
      if (readings.empty()) continue;
      const Trial part = judged(fit({checked_.start.arm, {base_pose}}, readings, depth), readings);
      if (!part.ok) return part;
      whole.lack_of_fit += part.lack_of_fit;
      squares += part.error * part.error * static_cast<double>(readings.size());
      count += readings.size();
    }
    whole.error = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(count, 1)));
    whole.extent = as_is_.extent;
    whole.base_shift = as_is_.base_shift;
    whole.base_turn = as_is_.base_turn;
    return whole;
  }

  /// How far tips that touched unknown points are spread: a mistake that draws them together lowers their error for no
  /// merit of its own. 0 where there are none.
  static double extentOfTips(const PlacedArm& placed, const std::vector<Measurement>& readings) {
    std::vector<Eigen::Vector3d> tips;
    for (const auto& reading : readings)
      if (touchesUnknownPoint(reading))
        if (const auto tip = predictReading(
                placed.arm, placed.base_poses[static_cast<std::size_t>(basePoseOf(placed, reading))].X_WB, reading);
            tip.ok)
          tips.push_back(tip.value);
    if (tips.size() < 2) return 0;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto& tip : tips) mean += tip / static_cast<double>(tips.size());
    double sum = 0;
    for (const auto& tip : tips) sum += (tip - mean).squaredNorm();
    return std::sqrt(sum / static_cast<double>(tips.size()));
  }

  /// How much smaller a mistake makes what is touched: above 1 where it draws the tips together.
  double shrinkage(const Trial& trial) const {
    return as_is_.extent > 0 && trial.extent > 0 ? std::max(1., as_is_.extent / trial.extent) : 1;
  }

  /// By how much less a mistake leaves than the readings as they are; where those cannot be fitted, by a lot.
  [[nodiscard]] double gain(const Trial& trial) const {
    constexpr double kALot = 1e9;
    if (!as_is_.ok) return kALot - trial.lack_of_fit;
    double rows = 0;
    if (shrinkage(trial) > 1) rows = 3 * static_cast<double>(pool_.counted.size());
    return as_is_.lack_of_fit - trial.lack_of_fit - rows * std::log(shrinkage(trial));
  }

  /// Whether there is an error that a mistake could explain, or a base that one could have moved.
  [[nodiscard]] bool asksForMistakes() const {
    if (!as_is_.ok) return true;
    double noise = 0, rows = 0;
    for (const auto& reading : checked_.readings) {
      if (!pool_.counted.contains(reading.id)) continue;
      noise += rowsOf(reading) * reading.sigma * reading.sigma;
      rows += rowsOf(reading);
    }
    noise = std::sqrt(noise / static_cast<double>(pool_.counted.size()));
    const bool is_lack_of_fit = as_is_.lack_of_fit - kNoisePerRow * rows > kOdds;
    const bool is_bent = as_is_.held_error > kDrastic * as_is_.open_error;  // only a drawing bent to them fits
    return isBaseFar() || (as_is_.held_error > kLeastFall * noise && (is_lack_of_fit || is_bent));
  }

  /// Touches of unknown points alone say nothing of the base.
  [[nodiscard]] bool isBaseFar() const {
    return has_places_ && (as_is_.base_turn > kFarTurn || as_is_.base_shift > kFarShift * reach_);
  }

  bool isWithinLimits(const Mend& mend) const {
    auto readings = pool_.readings;
    mend.apply(readings);
    const auto outside = [&](const std::vector<Measurement>& set) {
      std::size_t count = 0;
      for (const auto& reading : set)
        for (int j = 0; j < reading.q.size(); ++j) {
          const auto& joint = checked_.start.arm.joint(j);
          if (reading.q[j] < joint.lower - kLimitSlack || reading.q[j] > joint.upper + kLimitSlack) {
            ++count;
            break;
          }
        }
      return count;
    };
    return !readings.empty() && static_cast<double>(outside(readings)) <=
                                    kShareOutside * static_cast<double>(readings.size()) +
                                        (mend.zero_of < 0 && outside(pool_.readings) > outside(readings) ? 1e9 : 0);
  }

  struct Suspect {
    Mend mend;
    Trial drawn, open;
  };

  /// The zero as the readings have it best, from the value tried; nothing where that is no mistake. The first joint's
  /// zero and a base that is not known are one for the readings: it is looked for with the base where it nominally is.
  std::optional<Mend> zeroFound(const Mend& from) const {
    PlacedArm start = startOf(from);
    if (from.zero_of == 0)
      for (auto& base_pose : start.base_poses) base_pose.is_known = true;
    const int zeroed = deflection::activeRows(checked_.start.arm)[static_cast<std::size_t>(from.zero_of)];
    const auto& row = checked_.start.arm.rows[static_cast<std::size_t>(zeroed)];
    const std::string name = row.name + ".joint.offset";
    const auto best = fit(std::move(start), mended(from, Depth::kDrawn), Depth::kHeld, name);
    if (!best.ok) return std::nullopt;
    const auto before = deflection::findParameter(checked_.start.arm, name),
               after = deflection::findParameter(best.placed.arm, name);
    if (!before || !after) return std::nullopt;
    const double tried = std::stod(partedAtColon(from.value).second) * checked_.units.angles.factor;
    double zero = std::remainder(tried + after->value - before->value, 2 * std::numbers::pi);
    constexpr double kQuarter = std::numbers::pi / 2, kNearQuarter = 0.035;
    if (const double whole = std::round(zero / kQuarter) * kQuarter;
        whole != 0 && std::abs(zero - whole) < kNearQuarter)
      zero = whole;
    if (std::abs(zero) < mistakes::joint_zero::kLeast) return std::nullopt;
    return mistakes::joint_zero::mend(checked_, mistakes::joint_zero::textOf(checked_, from.zero_of, zero));
  }

  std::vector<Suspect> screened() const {
    std::vector<Suspect> suspects;
    for (const auto& kind : mistakeKinds())
      for (const auto& value : kind.values(checked_)) {
        goOn(options_.stop);
        auto mend = kind.mend(checked_, value);
        if (mend && mend->zero_of >= 0) mend = zeroFound(*mend);
        if (!mend || !isWithinLimits(*mend)) continue;
        if (mend->zero_of >= 0 && std::any_of(suspects.begin(), suspects.end(), [&](const Suspect& other) {
              return other.mend.mistake == mend->mistake && other.mend.value == mend->value;
            }))
          continue;
        Trial trial = tried(*mend, Depth::kHeld);
        if (trial.ok) suspects.push_back({std::move(*mend), std::move(trial), {}});
      }
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
    return -3 * static_cast<double>(pool_.counted_quickly.size()) * std::log(shrinkage(trial));
  }

  /// Whether a mend has numbers that are fitted: what others take off the error is no fit.
  static bool hasNumbers(const Mend& mend) { return mend.frees_base || mend.parts_setups || mend.zero_of >= 0; }

  [[nodiscard]] bool explainsError(const Suspect& suspect) const {
    constexpr double kFits = 0.05;  // of the reach: an error from which readings that cannot be fitted as they are, are
    if (!as_is_.ok) return suspect.drawn.error < kFits * reach_;
    const double shrinks = shrinkage(suspect.drawn);
    const auto falls = [&](double as_is, double mended) { return as_is >= kLeastFall * mended * shrinks; };
    // A base is one for all readings: one that has slipped is none for those before.
    if (suspect.mend.frees_base && !falls(as_is_.whole_error, suspect.open.whole_error)) return false;
    if (!hasNumbers(suspect.mend) && gain(suspect.open) > 0 &&
        as_is_.held_error >= kDrastic * suspect.drawn.held_error * shrinks)
      return true;
    return gain(suspect.open) >= kOdds &&
           (falls(as_is_.error, suspect.drawn.error) || falls(as_is_.held_error, suspect.drawn.held_error) ||
            falls(as_is_.open_error, suspect.open.error));
  }

  [[nodiscard]] bool explainsBase(const Suspect& suspect) const {
    constexpr double kBack = 4, kHarm = 1.5;
    if (!as_is_.ok || !isBaseFar()) return false;
    const bool turns_back = as_is_.base_turn > kFarTurn && as_is_.base_turn >= kBack * suspect.drawn.base_turn;
    const bool shifts_back =
        as_is_.base_shift > kFarShift * reach_ && as_is_.base_shift >= kBack * suspect.drawn.base_shift;
    const bool is_near = suspect.drawn.base_turn < kFarTurn && suspect.drawn.base_shift < kFarShift * reach_;
    return (turns_back || shifts_back) && is_near && suspect.drawn.error <= kHarm * as_is_.error &&
           gain(suspect.open) >= kOdds;
  }

  /// The errors that fall most: by the drawing, with the tip as drawn, or with all that is open.
  void tellErrors(const Suspect& best, MeasurementCheck& check) const {
    const std::pair<double, double> told[] = {{as_is_.error, best.drawn.error},
                                              {as_is_.held_error, best.drawn.held_error},
                                              {as_is_.open_error, best.open.error}};
    const auto& [as_is, mended] = *std::max_element(std::begin(told), std::end(told), [](const auto& a, const auto& b) {
      return a.first * b.second < b.first * a.second;
    });
    check.error_as_is = as_is_.ok ? as_is : kNoFigure;
    check.error_if_mended = mended;
  }

  void searchMistakes(std::vector<MeasurementCheck>& checks) const {
    auto suspects = screened();
    for (auto& suspect : suspects) {
      const double held_error = suspect.drawn.error;
      suspect.drawn = tried(suspect.mend, Depth::kDrawn);
      suspect.drawn.held_error = held_error;
      suspect.open = tried(suspect.mend, Depth::kOpen);
    }
    std::erase_if(suspects, [&](const Suspect& suspect) {
      return !suspect.open.ok || (!explainsError(suspect) && !explainsBase(suspect));
    });
    if (suspects.empty()) return;
    std::stable_sort(suspects.begin(), suspects.end(),
                     [&](const Suspect& a, const Suspect& b) { return gain(a.open) > gain(b.open); });
    const Suspect& best = suspects.front();
    MeasurementCheck check;
    check.name = best.mend.mistake;
    const bool is_of_error = explainsError(best);
    check.severity = is_of_error ? CheckSeverity::kMistake : CheckSeverity::kRemark;
    check.sentence = best.mend.sentence +
                     (is_of_error ? "" : ", or the base stands far from its nominal place (" + baseText(as_is_) + ")");
    tellErrors(best, check);
    check.assume = best.mend.mistake + "=" + best.mend.value;
    for (std::size_t k = 1; k < suspects.size(); ++k)
      if (gain(suspects[k].open) > gain(best.open) - kAsGood &&
          suspects[k].drawn.error < kAsGoodError * best.drawn.error)
        check.equally.push_back(suspects[k].mend.mistake + "=" + suspects[k].mend.value);
    checks.push_back(std::move(check));
  }

  /// Of the units that sigma might be in, the one by which chi-square is nearest to what noise leaves.
  struct SigmaUnit {
    Mend mend;
    double chi2_per_freedom = kNoFigure;
  };
  std::optional<SigmaUnit> likeliestSigma(bool is_smaller) const {
    std::optional<SigmaUnit> best;
    const auto& units = checked_.units;
    for (const auto& unit : units.sigmas) {
      if (unit.name == units.sigma.name || (unit.factor < units.sigma.factor) != is_smaller) continue;
      auto mend = findMistakeKind("sigma")->mend(checked_, unit.name);
      if (!mend) continue;
      const Trial trial = tried(*mend, Depth::kOpen);
      if (!trial.ok || !(trial.chi2_per_freedom > 0)) continue;
      if (!best || std::abs(std::log(trial.chi2_per_freedom)) < std::abs(std::log(best->chi2_per_freedom)))
        best = SigmaUnit{std::move(*mend), trial.chi2_per_freedom};
    }
    return best;
  }

  void checkSigma(std::vector<MeasurementCheck>& checks) const {
    constexpr double kFarBelow = 1. / 30;  // of chi-square per degree of freedom: readings agree five times better
    constexpr double kAgrees = 5;          // times too large or small, the same: as good as sigmas are known
    constexpr double kFinest = 2e-7;       // of the arm's reach: interferometers measure a machine to 0.5 um in a metre
    constexpr std::size_t kFew = 6;
    std::vector<double> sigmas;
    for (const auto& reading : checked_.readings) sigmas.push_back(reading.sigma);
    const double sigma = median(std::move(sigmas));
    const bool is_large = checked_.readings.size() >= kFew && as_is_.chi2_per_freedom < kFarBelow;
    const bool is_fine = sigma < kFinest * reach_;
    if (!is_large && !is_fine) return;
    const auto likeliest = likeliestSigma(is_large);
    const bool agrees = likeliest && std::abs(std::log(likeliest->chi2_per_freedom)) < std::log(kAgrees);
    char text[160];
    if (is_large)
      std::snprintf(text, sizeof text, "the readings agree %.2g times better than their stated noise",
                    1 / std::sqrt(std::max(as_is_.chi2_per_freedom, 1e-30)));
    else
      std::snprintf(text, sizeof text,
                    "the stated noise (%.2g %s) is smaller than that of any instrument for an arm of this size",
                    sigma / checked_.units.sigma.factor, checked_.units.sigma.name.c_str());
    MeasurementCheck check{
        "sigma", agrees && is_large ? CheckSeverity::kMistake : CheckSeverity::kRemark, text, kNoFigure, kNoFigure, "",
        {}};
    if (agrees || (is_fine && likeliest)) {
      check.sentence += ": " + likeliest->mend.sentence;
      check.assume = "sigma=" + likeliest->mend.value;
    }
    checks.push_back(std::move(check));
  }

  [[nodiscard]] std::string baseText(const Trial& trial) const {
    const auto& length = checked_.units.coordinates;
    char text[128];
    std::snprintf(text, sizeof text, "%.3g %s", trial.base_shift / length.factor, length.name.c_str());
    std::string words = text;
    if (checked_.sheet && checked_.sheet->pitch > 0) {
      std::snprintf(text, sizeof text, " (%.1f pitches)", trial.base_shift / checked_.sheet->pitch);
      words += text;
    }
    std::snprintf(text, sizeof text, " and %.2g deg", trial.base_turn * 180 / std::numbers::pi);
    return words + text;
  }

  /// How far the base is from its nominal place, where that is far, or where a row or column miscounted would do it.
  void checkBase(std::vector<MeasurementCheck>& checks) const {
    constexpr double kNearlyAPitch = 0.7, kBack = 3;
    const bool is_far = isBaseFar();
    const bool is_pitches = checked_.sheet && has_places_ && as_is_.base_shift > kNearlyAPitch * checked_.sheet->pitch;
    if (!is_far && !is_pitches) return;
    const auto is_told = [](const MeasurementCheck& check) {
      return check.sentence.find("nominal place") != std::string::npos;
    };
    if (std::any_of(checks.begin(), checks.end(), is_told)) return;
    MeasurementCheck check{"base-from-nominal",
                           CheckSeverity::kRemark,
                           "the best-fitting base is " + baseText(as_is_) + " from its nominal place",
                           kNoFigure,
                           kNoFigure,
                           "",
                           {}};
    if (is_pitches)
      for (const auto& value : findMistakeKind("holes")->values(checked_))
        if (const auto mend = findMistakeKind("holes")->mend(checked_, value)) {
          const Trial trial = tried(*mend, Depth::kDrawn);
          if (!trial.ok || trial.base_shift * kBack > as_is_.base_shift) continue;
          check.sentence += ": were the holes counted from another row or column?";
          check.assume = "holes=" + value;
          break;
        }
    checks.push_back(std::move(check));
  }

  const CheckedReadings& checked_;
  const CheckOptions& options_;
  Pool pool_;
  FreeChoice open_, drawn_, held_;
  double reach_;
  bool has_places_;
  Trial as_is_;
};

}  // namespace

MeasurementChecks checkMeasurements(const CheckedReadings& checked, const CheckOptions& options) {
  auto result = Checking(checked, options).run();
  std::stable_sort(result.checks.begin(), result.checks.end(),
                   [](const MeasurementCheck& a, const MeasurementCheck& b) { return a.severity < b.severity; });
  return result;
}

const MeasurementCheck* grossMistake(const MeasurementChecks& checks) {
  for (const auto& check : checks.checks)
    if (check.severity == CheckSeverity::kMistake) return &check;
  return nullptr;
}

}  // namespace tubeplan::calibration
