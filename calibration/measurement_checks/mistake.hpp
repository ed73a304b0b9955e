// What is ordinarily done wrong with readings: the open table of mistakes. Each kind is a file here and a row of the
// table in mistakes.cpp; nothing else names it. A kind says which forms of it are worth trying, and how the readings
// would have to be taken if it were so; which form explains the readings is for measurement_checks.cpp to find.
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
  double factor = 1;  ///< internal units per one of it
};

/// The units that a file's columns say they are in, and those that they might be in.
struct ReadingUnits {
  NamedUnit coordinates{"m", 1}, loads{"N", 1}, angles{"rad", 1}, sigma{"m", 1};
  /// Units by the columns of the noise, of all coordinates alike and of x, y and z apart; without a name: no such
  /// column.
  NamedUnit sigma_column{"", 1}, axis_sigma_columns{"", 1};
  std::vector<NamedUnit> lengths, forces, angle_units, sigmas;
  std::vector<NamedUnit> joints;  ///< of each joint's column; empty where nobody knows
};

/// Readings as their file has them, and what they are held against.
struct CheckedReadings {
  PlacedArm start;  ///< as the cell says; a base pose for every set-up
  std::vector<Measurement> readings;
  FreeChoice free;
  ReadingUnits units;
  const tubesheets::Sheet* sheet = nullptr;  ///< none: null; must outlive this
};

struct Prediction;

/// A set-up that begins within another, whose base is found anew.
struct NewSetup {
  std::string name, within;
};

/// The readings as they would be taken if one mistake had been made.
struct Mend {
  std::string mistake, value;  ///< as `--assume MISTAKE=VALUE` takes them
  std::string sentence;        ///< "the unit of the coordinates is mm, not in as their columns say"
  std::function<void(std::vector<Measurement>&)> change = [](std::vector<Measurement>&) {};
  /// Mends noise that is in the same wrong unit; empty where none is.
  std::function<void(std::vector<Measurement>&)> change_sigma = {};
  bool frees_base = false;         ///< the base is taken as not known
  bool parts_setups = false;       ///< every set-up is taken alone, with a tip of its own
  bool is_of_part = false;         ///< of some of the readings alone
  std::vector<int> zeros_of = {};  ///< joints whose zeros are looked for from the values tried
  int numbers_fitted = 0;          ///< to the readings: zeros and scales
  std::optional<NewSetup> new_setup = {};
  double against = 0;  ///< log of the odds that it has against it beside others: for a choice among many readings

  /// Changes the readings, and what they refer to among themselves with them.
  void apply(std::vector<Measurement>& readings) const {
    change(readings);
    if (change_sigma) change_sigma(readings);
    linkReferences(readings);
  }
};

/// Returns the change of all readings by that of each.
template <class Change>
[[nodiscard]] auto toEach(Change change) {
  return [change = std::move(change)](std::vector<Measurement>& readings) {
    for (Measurement& reading : readings) change(reading);
  };
}

/// A mistake that may begin at any reading, by numbers that are the same from there on (step_search.hpp).
struct StepForm {
  int numbers = 1;
  /// How a reading changes with them, by its prediction with slopes by the tip's x, y, z, by joints and by the base:
  /// rows x numbers.
  std::function<Eigen::MatrixXd(const Prediction&)> slopes;
  std::function<std::string(const Eigen::VectorXd& size, const std::string& from)> value;
  std::optional<std::string> setup = {};  ///< whose readings alone it is of
  /// An effect of the catalogue says the same, for the diagnosis to find: another form has to explain more.
  bool is_effect = false;
  bool is_of_tip = false;  ///< as a tool is that was mounted anew for a set-up
};

struct MistakeKind {
  const char* name;
  const char* value;                                           ///< what stands after the sign of equality: "UNIT"
  const char* expected;                                        ///< the same for messages: "a unit of length"
  std::vector<std::string> (*values)(const CheckedReadings&);  ///< worth trying
  std::optional<Mend> (*mend)(const CheckedReadings&, const std::string& value);  ///< nothing: no such value
  bool settles_sigma = false;  ///< says of the noise what it is: other mends leave it then
  bool joins_itself = false;   ///< several of it may be made at once: each is of a joint or a column
  /// Worth trying beside another mistake, where other forms than alone are; null: the same.
  std::vector<std::string> (*values_beside)(const CheckedReadings&) = nullptr;
  /// Forms of it that may begin at any reading; null: none.
  std::vector<StepForm> (*steps)(const CheckedReadings&) = nullptr;
  bool is_of_turns = false;  ///< of what readings say of a frame's turn: places do not show it
};

/// In the order in which several are undone.
const std::vector<MistakeKind>& mistakeKinds();

/// Several mends one after another as one, whose value has the further ones behind commas as `--assume` takes them.
[[nodiscard]] Mend joined(const std::vector<Mend>& parts);

/// Returns the assumptions of one text, "joint-sign=q1,tip=0.2" say, as checks offer several that go together.
[[nodiscard]] std::vector<std::string> partedAssumptions(const std::string& text);

[[nodiscard]] const MistakeKind* findMistakeKind(const std::string& name);

/// A reading whose place is that of the hole it names: nobody has written its coordinates.
[[nodiscard]] bool isPlacedBySheet(const CheckedReadings& checked, const Measurement& reading);

/// Joint's index by its name; -1 where there is none.
[[nodiscard]] int jointNamed(const deflection::Arm& arm, const std::string& name);

/// Two joint names or a joint and a number, parted at the colon; empty where there is none.
[[nodiscard]] std::pair<std::string, std::string> partedAtColon(const std::string& value);

/// Returns the parts of a text between the marks.
[[nodiscard]] std::vector<std::string> partedAt(char mark, const std::string& text);

/// Returns the joints that turn, by their indices.
[[nodiscard]] std::vector<int> turningJoints(const deflection::Arm& arm);

/// Reads so many finite numbers between colons, such as "0:0.5:0"; nothing where the text is none of that.
[[nodiscard]] std::optional<std::vector<double>> numbersAtColons(const std::string& text, std::size_t count);

/// No values: of a mistake that is looked for elsewhere, or not beside others.
[[nodiscard]] inline std::vector<std::string> noValues(const CheckedReadings&) { return {}; }

}  // namespace tubeplan::calibration
