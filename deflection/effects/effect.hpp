// Catalogue of physical effects: ways in which a real arm can deviate from the model in its file. Each effect has its
// own file, which states its law, and a row of the table in effects.cpp. No other code refers to a particular effect.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deflection/effects/effect_context.hpp"
#include "deflection/parameters.hpp"

namespace tubeplan::deflection {

inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// One parameter of an effect, in internal units. For the readings of prismatic joints, angles are replaced by lengths.
struct EffectParameter {
  const char* name;
  Quantity quantity;
  double neutral;       ///< value at which the effect vanishes, if all other parameters are neutral
  double lower, upper;  ///< hard physical bounds
  double plausible;     ///< largest plausible magnitude on a real machine
  /// True if the parameter has no influence while the effect's other parameters are neutral. A fit must then find its
  /// value by a scan.
  bool is_shape = false;
  double (*least)(const Arm&, const Place&) = nullptr;  ///< replaces `lower` if the bound depends on the arm
};

/// A variable on which a law depends: one of the enumerators of Of, or a condition.
class EffectVariable {
 public:
  enum Of { kJoint, kDirection, kLoad, kMoment, kPosition, kSetup };

  constexpr EffectVariable(Of of) : of_(of) {}                              // NOLINT: a table's entry
  constexpr EffectVariable(Condition condition) : condition_(condition) {}  // NOLINT: a table's entry

  [[nodiscard]] constexpr std::optional<Condition> condition() const { return condition_; }
  [[nodiscard]] constexpr bool is(Of of) const { return !condition_ && of_ == of; }
  [[nodiscard]] constexpr bool operator==(const EffectVariable&) const = default;

 private:
  friend const char* nameOf(EffectVariable variable);

  Of of_ = kJoint;  // unused for a condition
  std::optional<Condition> condition_;
};

/// Returns the name of a variable: "joint", "sense" (for kDirection), "load", "moment", "position", "set-up" or the
/// name of a condition.
[[nodiscard]] const char* nameOf(EffectVariable variable);

/// Part of the model that an effect acts on.
enum class EffectStage { kJointReading, kGeometry, kLoad, kFlexibility, kBase, kMeasurement };

/// Notation for the location of an effect: `theta2`, `theta3<-theta2`, `forearm`, `tool.z`, the name of a set-up of the
/// base, or a fixed word.
enum class PlaceRule { kJoint, kJointPair, kLink, kRowAxis, kSetup, kWord };

/// Requirements for an effect to be observable, in addition to the conditions with which it varies: stated approach
/// directions, a hung load, any moments (weights of the arm, or a load), an arm without stated weights, or measurements
/// that depend on the tool's rotation.
struct EffectNeeds {
  bool approach_directions = false, load = false, moments = false, no_weights = false, tool_turn = false;
};

/// A kind of effect: one row of the effect table.
struct EffectKind {
  const char* name;
  const char* words;  ///< description for a reader who does not know the effect's name
  const char* law;    ///< the law in one line
  const char* validity;
  const char* source;
  EffectStage stage;
  PlaceRule at;
  const char* word = "";  ///< name of the only place, for PlaceRule::kWord
  /// Feature that the arm needs for the effect to have a location, such as "an axis with joint_stiffness in the arm
  /// file".
  const char* place_needs = "";
  /// Name of the effect that this one adds to at the same place; a diagnosis seeks it only beside that effect.
  const char* extends = "";
  const char* places_elsewhere = "";  ///< description of the places, if `places` does not list them
  /// Prior odds of the kind relative to others, divided among its locations; 0 means tried only on request.
  double odds = 1;
  const char* odds_reason = "";             ///< reason for the odds
  std::vector<EffectVariable> varies_with;  ///< variables of the law, simplest first; empty means unknown
  EffectNeeds needs;
  std::vector<EffectParameter> parameters;
  std::vector<Place> (*places)(const Arm&);  ///< returns every place of an arm where the effect can act
  void (*apply)(const EffectOf<double>&, EffectContext<double>&);
  void (*applyDual)(const EffectOf<Dual>&, EffectContext<Dual>&);
};

const std::vector<EffectKind>& effectKinds();

/// Returns the conditions on which an effect depends. Measurements must state these conditions for the effect to be
/// observable.
[[nodiscard]] std::vector<Condition> conditionsOf(const EffectKind& kind);

/// Returns the kind of an effect.
[[nodiscard]] const EffectKind& kindOf(const Effect& effect);

/// Returns the index of the kind named `name`; std::nullopt if there is none.
[[nodiscard]] std::optional<int> findEffectKind(std::string_view name);

/// Returns a place as written in files and reports.
[[nodiscard]] std::string textOf(const Arm& arm, const EffectKind& kind, const Place& place);

/// Returns every place of an arm where effects of a kind can act, as written in files.
[[nodiscard]] std::vector<std::string> placeTexts(const Arm& arm, const EffectKind& kind);

/// Returns an explanation for a kind that has no location in an arm, such as "this arm has no place for this effect,
/// which needs ...".
[[nodiscard]] std::string lackOfPlace(const EffectKind& kind);

[[nodiscard]] std::optional<Place> findPlace(const Arm& arm, const EffectKind& kind, std::string_view text);

/// Returns the place of an effect as written in files, such as `tool.z`; for a formula, its target, with "#2" for the
/// second formula of a target.
[[nodiscard]] std::string placeText(const Arm& arm, const Effect& effect);

/// Returns the full name of an effect, such as `backlash@tool.z`.
[[nodiscard]] std::string textOf(const Arm& arm, const Effect& effect);

enum class EffectStatus { kNotRun, kMade, kUnknownEffect, kUnknownPlace };

struct MadeEffect {
  EffectStatus status = EffectStatus::kNotRun;
  std::string reason;              ///< reason why no effect was made
  std::vector<std::string> known;  ///< valid names, if a name is unknown
  Effect effect;                   ///< the effect at neutral values
};

/// Returns an effect with neutral values for a name and a place, such as "backlash" and "tool.z".
[[nodiscard]] MadeEffect makeEffect(const Arm& arm, std::string_view name, std::string_view at);

/// Returns the parameters of an effect's kind or formula, in the order of the effect's values.
[[nodiscard]] const std::vector<EffectParameter>& numbersOf(const Effect& effect);

/// Quantity and bounds of an effect's parameter, for the effect's place in an arm.
struct EffectNumber {
  Quantity quantity;
  double lower, upper;
};
[[nodiscard]] EffectNumber numberOf(const Arm& arm, const Effect& effect, int value);

/// Returns the problems of the arm's effects: unknown kinds, places that the arm does not have, the same effect twice
/// at a place, and values that are missing or out of bounds.
[[nodiscard]] std::vector<ArmProblem> findEffectProblems(const Arm& arm);

}  // namespace tubeplan::deflection
