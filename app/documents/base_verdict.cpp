#include "app/documents/base_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/figures.hpp"
#include "app/documents/pattern_json.hpp"
#include "app/formats/arm/joint_units.hpp"
#include "app/formats/units.hpp"
#include "calibration/patterns/comparison.hpp"

namespace tubeplan::app {

namespace {

using calibration::BaseCalibration;

// Largest plausible deviation of the base from nominal, in standard deviations of its prior.
constexpr double kMostSigmas = 3;
constexpr double kMostPitches = 10;  // largest plausible miscount of rows or columns, in pitches
// Largest difference, in pitches, between the shift of the base and a vector between two holes at which a miscount of
// holes is suspected. Larger differences occur only for shifts off the sheet.
constexpr double kOnLattice = 0.75;
// Touches that fit so well that the probability of such a fit is below this value cause a warning.
constexpr double kTooGood = 1e-6;
// Prior probability that all holes of a session are counted from a wrong row or column.
constexpr double kMiscounted = 0.01;
// Smallest number of touches with which a wrong touch can be distinguished from a wrong model.
constexpr std::size_t kEnoughTouches = 4;

/// Returns a sentence such as "if theta1 of touch T6 was read 0.4 deg too large, the touches fit (p = 0.4): read it
/// again".
std::string suspectText(const calibration::SuspectMeasurement& suspect, const Cell& cell) {
  const auto& joint = cell.arm.joint(suspect.joint);
  const Dimension dimension = jointDimension(joint);
  return fmt::format("if {} of touch {} was read {:.3g} {} too {}, the touches fit (p = {:.2g}): read it again",
                     joint.name, suspect.touch, std::abs(cell.units.toFile(suspect.off, dimension)),
                     cell.units.nameOf(dimension), suspect.off > 0 ? "large" : "small", suspect.p_value);
}

void judgeFit(const BaseCalibration& base, const Cell& cell, BaseVerdict& verdict) {
  const Units& units = cell.units;
  verdict.fit_is_off = calibration::isFitRefused(base);
  if (verdict.fit_is_off) {
    verdict.warnings.push_back(fmt::format(
        "the touches do not fit: their error is {:.3g} times what their noise and the uncertainty of the arm's numbers "
        "explain ({})",
        std::sqrt(base.chi2 / std::max(1, base.degrees_of_freedom)), chanceText(base.p_value)));
    if (base.outlier_touch >= 0) {
      const auto& outlier = base.residuals[static_cast<std::size_t>(base.outlier_touch)];
      verdict.to_do.push_back(fmt::format(
          "touch {} of hole {} does not agree with the others, which fit without it (rms {} instead of {}): "
          "touch it again, or leave it out (--assume without={})",
          outlier.id, outlier.hole, lengthText(base.rms_of_others, units), lengthText(base.rms, units), outlier.id));
    }
    for (const auto& suspect : base.suspect_measurements) verdict.to_do.push_back(suspectText(suspect, cell));
    if (base.residuals.size() < kEnoughTouches)
      verdict.to_do.emplace_back(
          "touch a fourth hole, far from the others, and calibrate again: it distinguishes a wrong touch from a wrong "
          "model");
    verdict.to_do.emplace_back(
        "`tubeplan compare CELL TOUCHES` shows what the error depends on; `identify` finds the parameters that are "
        "wrong");
  }
  if (base.degrees_of_freedom > 0 && 1 - base.p_value < kTooGood)
    verdict.warnings.emplace_back(
        "the touches agree far better than their stated noise: sigma is too large, or in another unit");
}

/// Displacement from one hole of the sheet to another, in rows, in columns and as a vector.
struct HoleDisplacement {
  int rows = 0, columns = 0;
  Eigen::Vector2d way = Eigen::Vector2d::Zero();  ///< vector between the two holes [m]
};

/// Among the displacements from the hole nearest to the middle of the sheet to other holes, returns the one closest to
/// `way`.
HoleDisplacement holesNearest(const tubesheets::Sheet& sheet, const Eigen::Vector2d& way) {
  const auto placeOf = [](const tubesheets::Tube& tube) { return Eigen::Vector2d(tube.x, tube.y); };
  const auto nearestTo = [&](const Eigen::Vector2d& place) {
    return *std::ranges::min_element(
        sheet.tubes, {}, [&](const tubesheets::Tube& tube) { return (placeOf(tube) - place).squaredNorm(); });
  };
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const auto& tube : sheet.tubes) middle += placeOf(tube) / static_cast<double>(sheet.tubes.size());
  const tubesheets::Tube from = nearestTo(middle), to = nearestTo(placeOf(from) + way);
  return {to.row - from.row, to.column - from.column, placeOf(to) - placeOf(from)};
}

/// Returns the prior probability density of the base at displacement `candidate` from nominal, divided by that at
/// `reference`.
double likelihoodRatio(const Eigen::Vector3d& candidate, const Eigen::Vector3d& reference, const BasePrior& prior) {
  return std::exp((reference.squaredNorm() - candidate.squaredNorm()) / (2 * prior.shift * prior.shift));
}

/// Warns if all hole names may be wrong by the same number of rows and columns, that is, if the prior of the base makes
/// such a miscount more probable than the shift found.
void judgeShift(const BaseCalibration& base, const Cell& cell, BaseVerdict& verdict) {
  const Units& units = cell.units;
  const Eigen::Vector3d shift = base.from_start.head<3>();
  verdict.distance = shift.norm();
  if (cell.sheet) verdict.pitches = shift.head<2>() / cell.sheet->pitch;
  const HoleDisplacement displacement = cell.sheet ? holesNearest(*cell.sheet, shift.head<2>()) : HoleDisplacement{};
  const Eigen::Vector3d remaining_shift(shift.x() - displacement.way.x(), shift.y() - displacement.way.y(), shift.z());
  if (displacement.way.norm() > 0 && displacement.way.norm() <= kMostPitches * cell.sheet->pitch &&
      remaining_shift.head<2>().norm() < kOnLattice * cell.sheet->pitch &&
      kMiscounted * likelihoodRatio(remaining_shift, shift, cell.base_prior) > 1) {
    verdict.is_implausible = true;
    verdict.warnings.push_back(fmt::format(
        "the base is {:+.2f} pitches along x and {:+.2f} along y from nominal: if every hole name were off by {:+d} "
        "rows and {:+d} columns, the touches would fit as well, and the base would be {:.3g} {} from nominal",
        verdict.pitches.x(), verdict.pitches.y(), displacement.rows, displacement.columns,
        lengthOf(remaining_shift.norm(), units), units.length().name));
    verdict.to_do.emplace_back(
        "count the position of one touched hole again, from an edge of the sheet: a name one column off has this "
        "effect");
  }
  const double most = kMostSigmas * cell.base_prior.shift;
  if (!(shift.cwiseAbs().maxCoeff() <= most)) {
    verdict.is_implausible = true;
    verdict.warnings.push_back(fmt::format(
        "the base is {:.4g} {} from nominal, but at most {:.3g} {} along an axis is expected",
        lengthOf(verdict.distance, units), units.length().name, lengthOf(most, units), units.length().name));
  }
}

void judgeTurn(const BaseCalibration& base, const Cell& cell, BaseVerdict& verdict) {
  const Units& units = cell.units;
  verdict.angle = base.from_start.tail<3>().norm();
  const double most = kMostSigmas * cell.base_prior.turn;
  if (base.from_start.tail<3>().cwiseAbs().maxCoeff() <= most) return;
  verdict.is_implausible = true;
  verdict.warnings.push_back(
      fmt::format("the base is turned by {:.4g} {} from nominal, but at most {:.3g} {} about an axis is expected: "
                  "columns counted from the other side, or a joint read with the other sign, have this effect",
                  angleOf(verdict.angle, units), units.angle().name, angleOf(most, units), units.angle().name));
}

/// Standard deviations of the base position [m] and rotation [rad], as root sums of squares over the three axes.
struct FromNominalSigma {
  double distance, angle;
};

FromNominalSigma sigmaOf(const BaseCalibration& base) {
  return {std::sqrt(base.covariance.topLeftCorner<3, 3>().trace()),
          std::sqrt(base.covariance.bottomRightCorner<3, 3>().trace())};
}

}  // namespace

BaseVerdict judgeBase(const BaseCalibration& base, const Cell& cell) {
  BaseVerdict verdict;
  if (!base.residuals.empty()) judgeFit(base, cell, verdict);
  if (base.status != calibration::CalibrationStatus::kDone) return verdict;
  judgeShift(base, cell, verdict);
  judgeTurn(base, cell, verdict);
  if (verdict.is_implausible)
    verdict.to_do.emplace_back(
        "if the base is meant to be there, write that pose into `base` of the cell, or state how far it may be off: "
        "base: {prior: {shift: ..., turn: ...}}");
  return verdict;
}

nlohmann::json baseVerdictJson(const BaseVerdict& verdict, const BaseCalibration& base, const Units& units) {
  const auto adequacy = verdict.fit_is_off ? calibration::Adequacy::kInadequate : calibration::Adequacy::kAdequate;
  nlohmann::json json = {{"verdict", nameOf(adequacy)},
                         {"verdict_words", wordsOf(adequacy)},
                         {"warnings", verdict.warnings},
                         {"to_do", verdict.to_do}};
  if (base.status != calibration::CalibrationStatus::kDone) return json;
  const FromNominalSigma sigma = sigmaOf(base);
  nlohmann::json pitches = nullptr;
  if (verdict.pitches.allFinite()) pitches = {rounded(verdict.pitches.x()), rounded(verdict.pitches.y())};
  json["nominal"] = {{"shift", vectorJson(base.from_start.head<3>(), units, dimension::kLength)},
                     {"turn", vectorJson(base.from_start.tail<3>(), units, dimension::kAngle)},
                     {"distance", lengthOf(verdict.distance, units)},
                     {"angle", angleOf(verdict.angle, units)},
                     {"sigma", {{"distance", lengthOf(sigma.distance, units)}, {"angle", angleOf(sigma.angle, units)}}},
                     {"pitches", pitches},
                     {"implausible", verdict.is_implausible}};
  return json;
}

}  // namespace tubeplan::app
