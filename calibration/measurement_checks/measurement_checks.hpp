// What looks wrong with readings before any physics is asked: the ordinary mistakes (mistake.hpp), tried one by one.
//
// How a mistake is found. Readings are fitted twice, as they are and as they would be taken if the mistake had been
// made: once by the drawing alone, with the base where that is not known and the tip, for the error in metres; once
// with all that the drawing leaves open and every stiffness within its priors, and a prior of the base about its
// nominal place, for the probability (robust_fit.hpp). A mistake is suspected where both speak for it:
// - the error by the drawing falls to a third or less. A physical effect follows a law of its own and is not undone by
//   another unit, sign or order: whatever share of its error a wrong hypothesis catches by accident, two thirds of all
//   rows in all directions it does not;
// - the odds by the fit with priors, of mistake against none, are above a million to one, which outweighs that mistakes
//   are rare and that there are a hundred to try. What the priors allow (5 mm, 20 mrad, softer or stiffer parts) is no
//   mistake thereby.
// Or where the base found stands far from its nominal place (20 deg, a quarter of the reach) and the mistake brings it
// back without harm to the error: then it is a remark, as the readings' errors do not ask for it.
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
  kMistake,  ///< explains the lack of fit: nothing is to be concluded of the model before it is mended
  kRemark,
};

/// One thing that was noticed.
struct MeasurementCheck {
  std::string name;
  CheckSeverity severity = CheckSeverity::kRemark;
  std::string sentence;
  double error_as_is = kNoFigure;      ///< m, by the drawing; NaN: no matter of errors
  double error_if_mended = kNoFigure;  ///< m
  std::string assume;                  ///< what `--assume` would take; empty where there is nothing
  std::vector<std::string> equally;    ///< further forms of `--assume` that explain the readings as well
};

/// Returns a remark that is no matter of errors.
[[nodiscard]] inline MeasurementCheck remarkOf(std::string name, std::string sentence, std::string assume = "") {
  return {std::move(name), CheckSeverity::kRemark, std::move(sentence), kNoFigure, kNoFigure, std::move(assume), {}};
}

/// A column that is not there, and what it would let be seen.
struct MissingColumn {
  std::string column, sentence;
};

struct MeasurementChecks {
  std::vector<MeasurementCheck> checks;  ///< mistakes first
  std::vector<MissingColumn> missing;
  bool is_overruled = false;             ///< somebody has said that the readings count as they are, every one
  double base_shift = 0, base_turn = 0;  ///< m, rad: of the base found from the nominal one, the largest of all set-ups
};

struct CheckOptions {
  std::size_t most_readings = 100;  ///< of more, so many are drawn by the seed
  std::uint64_t seed = 1;
  StopQuestion stop = {};
};

/// Nothing is changed in the readings. Unwinds where it was stopped.
[[nodiscard]] MeasurementChecks checkMeasurements(const CheckedReadings& checked, const CheckOptions& options = {});

/// The mistake that keeps readings from telling anything of the model; null where there is none.
[[nodiscard]] const MeasurementCheck* grossMistake(const MeasurementChecks& checks);

}  // namespace tubeplan::calibration
