// Common mistakes in readings, as an open table. Each kind is a file in this folder and a row of the table in
// mistakes.cpp; nothing else names it. A kind states which forms of it are worth trying, and how to correct the
// readings for each. measurement_checks.cpp finds the form that explains the readings.
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
  double factor = 1;  ///< internal units per unit
};

/// Units that a file's columns state, and their alternatives.
struct ReadingUnits {
  NamedUnit coordinates{"m", 1}, loads{"N", 1}, angles{"rad", 1}, sigma{"m", 1};
  /// Units in the columns of the noise, for all coordinates and for x, y and z separately; without a name: no such
  /// column.
  NamedUnit sigma_column{"", 1}, axis_sigma_columns{"", 1};
  std::vector<NamedUnit> lengths, forces, angle_units, sigmas;
  std::vector<NamedUnit> joints;  ///< unit of each joint's column; empty if unknown
};

/// Readings of a file, with everything that they are compared with.
struct CheckedReadings {
  PlacedArm start;  ///< arm as stated by the cell, with one base pose for every set-up
  std::vector<Measurement> readings;
  FreeChoice free;
  ReadingUnits units;
  const tubesheets::Sheet* sheet = nullptr;  ///< null: none; must outlive this struct
};

struct Prediction;

/// Set-up that begins within another, with a base that is fitted again.
struct NewSetup {
  std::string name, within;
};

/// Correction of the readings for one mistake.
struct Mend {
  std::string mistake, value;  ///< names in `--assume MISTAKE=VALUE`
  std::string sentence;        ///< description: "the unit of the coordinates is mm, not in as their columns say"
  std::function<void(std::vector<Measurement>&)> change = [](std::vector<Measurement>&) {};
  /// Corrects noise in the same wrong unit; empty if there is none.
  std::function<void(std::vector<Measurement>&)> change_sigma = {};
  bool frees_base = false;         ///< true: the base counts as unknown
  bool parts_setups = false;       ///< true: every set-up is fitted separately, with its own tip
  bool is_of_part = false;         ///< true: applies to some of the readings only
  std::vector<int> zeros_of = {};  ///< joints whose zeros are fitted, starting at the tried values
  int numbers_fitted = 0;          ///< numbers fitted to the readings: zeros and scales
  std::optional<NewSetup> new_setup = {};
  double against = 0;  ///< log odds against it, for the choice among many readings

  /// Applies the corrections and updates the references between readings.
  void apply(std::vector<Measurement>& readings) const {
    change(readings);
    if (change_sigma) change_sigma(readings);
    linkReferences(readings);
  }
};

/// Returns the change of all readings that applies `change` to each.
template <class Change>
[[nodiscard]] auto toEach(Change change) {
  return [change = std::move(change)](std::vector<Measurement>& readings) {
    for (Measurement& reading : readings) change(reading);
  };
}

/// Mistake that may begin at any reading, with constant numbers from there on (step_search.hpp).
struct StepForm {
  int numbers = 1;
  /// Returns the change of a reading per unit of the numbers (rows x numbers). The prediction has slopes by the tip's
  /// x, y, z, by joints and by the base.
  std::function<Eigen::MatrixXd(const Prediction&)> slopes;
  std::function<std::string(const Eigen::VectorXd& size, const std::string& from)> value;
  std::optional<std::string> setup = {};  ///< set-up to which the mistake is limited
  /// True if an effect of the catalogue is equivalent and left to the diagnosis; another form must then explain more.
  bool is_effect = false;
  bool is_of_tip = false;  ///< true: a step of the tip, as from a tool that was mounted again for a set-up
};

struct MistakeKind {
  const char* name;
  const char* value;     ///< form of a value, after the equals sign: "UNIT"
  const char* expected;  ///< description of a value for messages: "a unit of length"
  std::vector<std::string> (*values)(const CheckedReadings&);  ///< values worth trying
  /// Correction for a value; nothing if there is no such value.
  std::optional<Mend> (*mend)(const CheckedReadings&, const std::string& value);
  bool settles_sigma = false;  ///< true: determines the noise, so other corrections do not change it
  bool joins_itself = false;   ///< true: several may occur together, each for one joint or column
  /// Values worth trying together with another mistake, if different from those alone; null: the same.
  std::vector<std::string> (*values_beside)(const CheckedReadings&) = nullptr;
  /// Forms that may begin at any reading; null: none.
  std::vector<StepForm> (*steps)(const CheckedReadings&) = nullptr;
  bool is_of_turns = false;  ///< true: concerns rotations of a measured frame, which positions do not show
};

/// Returns the table of mistakes, in the order in which several are corrected.
const std::vector<MistakeKind>& mistakeKinds();

/// Returns several corrections in sequence as one. Its value lists the further ones after commas as in `--assume`.
[[nodiscard]] Mend joined(const std::vector<Mend>& parts);

/// Returns the assumptions of one text such as "joint-sign=q1,tip=0.2", the form in which checks propose several
/// together.
[[nodiscard]] std::vector<std::string> partedAssumptions(const std::string& text);

[[nodiscard]] const MistakeKind* findMistakeKind(const std::string& name);

/// Returns true if the reading's place is that of the hole it names, so that its coordinates were not written.
[[nodiscard]] bool isPlacedBySheet(const CheckedReadings& checked, const Measurement& reading);

/// Returns the joint's index by its name; -1 if there is none.
[[nodiscard]] int jointNamed(const deflection::Arm& arm, const std::string& name);

/// Returns the two parts of a text at the last colon, such as two joint names or a joint and a number; empty without a
/// colon.
[[nodiscard]] std::pair<std::string, std::string> partedAtColon(const std::string& value);

/// Returns the parts of a text between the marks.
[[nodiscard]] std::vector<std::string> partedAt(char mark, const std::string& text);

/// Returns the indices of the revolute joints.
[[nodiscard]] std::vector<int> turningJoints(const deflection::Arm& arm);

/// Returns so many finite numbers between colons, such as "0:0.5:0"; nothing if the text has another form.
[[nodiscard]] std::optional<std::vector<double>> numbersAtColons(const std::string& text, std::size_t count);

/// Returns no values, for a mistake that is searched for elsewhere, or not together with others.
[[nodiscard]] inline std::vector<std::string> noValues(const CheckedReadings&) { return {}; }

}  // namespace tubeplan::calibration
