// Common mistakes in measurements, as an extensible table. Each kind of mistake is a file in this folder and a row of
// the table in mistakes.cpp; no other code refers to it. A kind states which values are worth trying, and how to
// correct the measurements for each value. measurement_checks.cpp finds the mistake that explains the measurements.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calibration/measurement.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/placed_arm.hpp"
#include "tubesheets/sheet.hpp"

namespace tubeplan::calibration {

struct NamedUnit {
  std::string name;
  double factor = 1;  ///< internal units per this unit
};

/// Units that a file's columns state, and the units that they may have instead.
struct MeasurementUnits {
  NamedUnit coordinates{"m", 1}, loads{"N", 1}, angles{"rad", 1}, sigma{"m", 1};
  /// Units of the noise columns: one common column for all coordinates, and columns for x, y and z. An empty name means
  /// that there is no such column.
  NamedUnit sigma_column{"", 1}, axis_sigma_columns{"", 1};
  std::vector<NamedUnit> lengths, forces, angle_units, sigmas;
  std::vector<NamedUnit> joints;  ///< unit of each joint's column; empty if unknown
};

/// Measurements of a file, with the arm, the units and the sheet against which they are checked.
struct CheckedMeasurements {
  PlacedArm start;  ///< arm as stated by the cell, with one base pose for every set-up
  std::vector<Measurement> measurements;
  FreeChoice free;
  MeasurementUnits units;
  const tubesheets::Sheet* sheet = nullptr;  ///< null without a sheet; must outlive this struct
};

struct Prediction;

/// Set-up that begins within another set-up, with a base pose that is fitted separately.
struct NewSetup {
  std::string name, within;
};

/// Correction of the measurements for one mistake.
struct Correction {
  std::string mistake, value;  ///< parts of the option `--assume MISTAKE=VALUE`
  std::string sentence;  ///< description, such as "the unit of the coordinates is mm, not in as their columns state"
  std::function<void(std::vector<Measurement>&)> change = [](std::vector<Measurement>&) {};
  /// Corrects the stated sigmas if they are in the same wrong unit; empty if there are no such sigmas.
  std::function<void(std::vector<Measurement>&)> change_sigma = {};
  bool frees_base = false;         ///< true if the base is treated as unknown
  bool parts_setups = false;       ///< true if every set-up is fitted separately, with a separate tip
  bool is_of_part = false;         ///< true if the correction applies only to some of the measurements
  std::vector<int> zeros_of = {};  ///< joints whose zeros are fitted, starting from the tried values
  int numbers_fitted = 0;          ///< number of parameters of the correction that are fitted, such as zeros
  std::optional<NewSetup> new_setup = {};
  double against = 0;  ///< prior log odds against a mistake that may begin at any measurement; otherwise 0

  /// Applies the corrections and updates the references between measurements.
  void apply(std::vector<Measurement>& measurements) const {
    change(measurements);
    if (change_sigma) change_sigma(measurements);
    linkReferences(measurements);
  }
};

/// Returns a function that applies `change` to each measurement.
template <class Change>
[[nodiscard]] auto toEach(Change change) {
  return [change = std::move(change)](std::vector<Measurement>& measurements) {
    for (Measurement& measurement : measurements) change(measurement);
  };
}

/// Form of a mistake that may begin at any measurement and is constant from then on, such as a displaced base
/// (step_search.hpp).
struct StepForm {
  int numbers = 1;
  /// Returns the derivatives of a measurement with respect to the step's parameters (rows x parameters). The prediction
  /// passed to it has derivatives with respect to the tip's x, y, z, to the joints and to the base.
  std::function<Eigen::MatrixXd(const Prediction&)> slopes;
  std::function<std::string(const Eigen::VectorXd& size, const std::string& from)> value;
  std::optional<std::string> setup = {};  ///< set-up to which the mistake is limited; nullopt if it is not limited
  /// True if an effect of the catalogue describes this step. It is then left to the diagnosis, and a step of another
  /// form is proposed only if it explains the measurements clearly better.
  bool is_effect = false;
  bool is_of_tip = false;  ///< true for a step of the tip, for example because the tool was remounted for a set-up
};

struct MistakeKind {
  const char* name;
  const char* value;     ///< form of a value, after the equals sign, such as "UNIT"
  const char* expected;  ///< description of a value for messages, such as "a unit of length"
  std::vector<std::string> (*values)(const CheckedMeasurements&);  ///< values worth trying
  /// Returns the correction for a value; nullopt if there is no such value.
  std::optional<Correction> (*correction)(const CheckedMeasurements&, const std::string& value);
  bool settles_sigma = false;  ///< true if its correction sets the noise, which other corrections then do not change
  bool joins_itself = false;   ///< true if the mistake may occur several times, each for another joint or column
  /// Values worth trying together with another mistake; if null, `values` is used.
  std::vector<std::string> (*values_with_others)(const CheckedMeasurements&) = nullptr;
  /// Step forms of the mistake that may begin at any measurement; null if none.
  std::vector<StepForm> (*steps)(const CheckedMeasurements&) = nullptr;
  /// True if the mistake concerns rotations of a measured frame, which do not affect positions.
  bool is_of_turns = false;
};

/// Returns the table of mistakes. If there are several mistakes, their corrections are applied in this order.
const std::vector<MistakeKind>& mistakeKinds();

/// Returns one correction that applies all corrections of `parts` in sequence. Its value lists the second and further
/// corrections after commas, as in `--assume`.
[[nodiscard]] Correction joined(const std::vector<Correction>& parts);

/// Splits a string such as "joint-sign=q1,tip=0.2", the form in which checks propose several assumptions together.
[[nodiscard]] std::vector<std::string> partedAssumptions(const std::string& text);

[[nodiscard]] const MistakeKind* findMistakeKind(const std::string& name);

/// Returns true if the measurement takes its coordinates from the hole that it names (on the sheet) instead of from the
/// file.
[[nodiscard]] bool isPlacedBySheet(const CheckedMeasurements& checked, const Measurement& measurement);

/// Returns the index of the joint with this name; -1 if there is none.
[[nodiscard]] int jointNamed(const deflection::Arm& arm, const std::string& name);

/// Splits a string such as "JOINT:NUMBER" at its last colon; both parts are empty if there is no colon.
[[nodiscard]] std::pair<std::string, std::string> partedAtColon(const std::string& value);

/// Splits a string at every `mark`.
[[nodiscard]] std::vector<std::string> partedAt(char mark, const std::string& text);

/// Returns the indices of the revolute joints.
[[nodiscard]] std::vector<int> turningJoints(const deflection::Arm& arm);

/// Parses `count` finite numbers separated by colons, such as "0:0.5:0"; nullopt if the string has another form.
[[nodiscard]] std::optional<std::vector<double>> numbersAtColons(const std::string& text, std::size_t count);

/// Returns an empty list, for mistakes that are searched for elsewhere or that are not combined with others.
[[nodiscard]] inline std::vector<std::string> noValues(const CheckedMeasurements&) { return {}; }

}  // namespace tubeplan::calibration
