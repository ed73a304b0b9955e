// Checks of measurements before any physical effect is considered: common mistakes (mistake.hpp) are tried one by one.
//
// Method. Two kinds of fit are made, each with the measurements as stated and as corrected for the mistake. The first
// keeps the arm as drawn and frees only the tip, and the base if it is unknown; it gives the error in metres. The
// second frees, within their priors, every stiffness and all other parameters that the drawing leaves open, with a
// prior that keeps the base near its nominal place; it gives the probability (robust_fit.hpp). A mistake is suspected
// if both fits support it:
// - The error relative to the drawing falls to a third or less. A physical effect follows its own law and is not
//   removed by another unit, sign or order. A wrong hypothesis may remove some of the error by chance, but not two
//   thirds of it in all rows and directions. Numbers fitted to measurements that still disagree must remove three
//   quarters of it.
// - The odds of the mistake against no mistake, from the fit with priors, are above a million to one. The threshold is
//   that high because mistakes are rare and about a hundred hypotheses are tried. An error that the priors allow (5 mm,
//   20 mrad, softer or stiffer members) is therefore not a mistake.
//
// A mistake that begins at a measurement is only a remark if an effect of the catalogue explains the measurements as
// well.
//
// A mistake is also reported if the fitted base is far from its nominal pose (20 deg, a quarter of the reach),
// and correcting the mistake moves the base back without increasing the error. This is only a remark, because the
// errors alone do not justify it.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "calibration/hooks.hpp"
#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration {

inline constexpr double kNoFigure = std::numeric_limits<double>::quiet_NaN();

enum class CheckSeverity {
  kMistake,  ///< explains the lack of fit, and must be corrected before the model is judged
  kRemark,
};

/// Finding of one check: a suspected mistake in the measurements, or a remark.
struct MeasurementCheck {
  std::string name;
  CheckSeverity severity = CheckSeverity::kRemark;
  std::string sentence;
  /// Error of the measurements as stated [m]; NaN means that the check does not concern errors.
  double error_as_is = kNoFigure;
  double error_if_corrected =
      kNoFigure;       ///< error of the corrected measurements [m]; NaN means that the check does not concern errors
  std::string assume;  ///< value of `--assume` that corrects the mistake; empty if none
  std::vector<std::string> equally;  ///< further values of `--assume` that explain the measurements equally well
};

/// Returns a remark without error figures.
[[nodiscard]] inline MeasurementCheck remarkOf(std::string name, std::string sentence, std::string assume = "") {
  return {std::move(name), CheckSeverity::kRemark, std::move(sentence), kNoFigure, kNoFigure, std::move(assume), {}};
}

/// Column that the measurements lack, with a sentence on the effects that it would reveal.
struct MissingColumn {
  std::string column, sentence;
};

struct MeasurementChecks {
  std::vector<MeasurementCheck> checks;  ///< findings, mistakes before remarks
  std::vector<MissingColumn> missing;
  bool is_overruled = false;  ///< true if the user has declared all measurements to be correct
  /// Shift [m] and rotation [rad] of the fitted base relative to its nominal pose; largest values over all set-ups.
  double base_shift = 0, base_turn = 0;
};

struct CheckOptions {
  /// Largest number of measurements used; if there are more, a subset is drawn randomly with `seed`.
  std::size_t most_measurements = 100;
  std::uint64_t seed = 1;
  StopQuestion stop = {};
};

/// Checks the measurements without changing them. Throws WorkStopped if `options.stop` requests a stop.
[[nodiscard]] MeasurementChecks checkMeasurements(const CheckedMeasurements& checked, const CheckOptions& options = {});

/// Returns the first finding of severity kMistake, which must be corrected before the model is judged; null if there is
/// none.
[[nodiscard]] const MeasurementCheck* firstMistake(const MeasurementChecks& checks);

}  // namespace tubeplan::calibration
