// The catalogue of physical effects: what an arm may do that its file does not say. Each is a law in one file and a row
// of the table in effects.cpp; nothing else names it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deflection/effects/effect_context.hpp"
#include "deflection/parameters.hpp"

namespace tubeplan::deflection {

inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// One number of an effect, in internal units. On a prismatic joint the angles of reading effects are lengths.
struct EffectParameter {
  const char* name;
  Quantity quantity;
  double neutral;         ///< where the effect does nothing (with all others neutral)
  double lower, upper;    ///< hard physical bounds
  double plausible;       ///< largest size that a real machine has: what goes beyond is not an explanation
  bool is_shape = false;  ///< has a meaning only while the effect is not neutral, and must be scanned
  double (*least)(const Arm&, const Place&) = nullptr;  ///< in the place of `lower`, where the arm decides it
};

/// What a law may hang on: one of these, or a condition.
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

  Of of_ = kJoint;  // unless it is a condition
  std::optional<Condition> condition_;
};

/// joint, sense, load, moment, position, set-up, or a condition's name
[[nodiscard]] const char* nameOf(EffectVariable variable);

/// What an effect acts on.
enum class EffectStage { kReading, kGeometry, kLoad, kFlexibility, kBase, kMeasurement };

/// How a place is written: `theta2`, `theta3<-theta2`, `forearm`, `tool.z`, the name of a set-up of the base, or the
/// kind's fixed word.
enum class PlaceRule { kJoint, kJointPair, kLink, kRowAxis, kSetup, kWord };

/// What there must be for an effect to be seen, beside the conditions that it varies with: columns of the measurements,
/// a hung load, moments at all (weights of the arm, or a load), an arm whose weights nobody stated, or readings that
/// the tool's turn reaches.
struct EffectNeeds {
  bool approach_directions = false, load = false, moments = false, no_weights = false, tool_turn = false;
};

/// One row of the effect table.
struct EffectKind {
  const char* name;
  const char* words;  ///< what it is, for a reader who does not know its name
  const char* law;    ///< one line
  const char* validity;
  const char* source;
  EffectStage stage;
  PlaceRule at;
  const char* word = "";              ///< the only place's name, for PlaceRule::kWord
  const char* place_needs = "";       ///< what an arm must have for a place, where its file may lack it: "a slide"
  const char* places_elsewhere = "";  ///< where it acts, if its places are none of the arm's own
  double odds = 1;  ///< prior odds of the kind against others, shared by its places; 0: never tried unasked ...
  const char* odds_reason = "";             ///< ... and why
  std::vector<EffectVariable> varies_with;  ///< the plainest first; empty: with anything
  EffectNeeds needs;
  std::vector<EffectParameter> parameters;
  std::vector<Place> (*places)(const Arm&);  ///< every place of an arm where the effect can be
  void (*apply)(const EffectOf<double>&, EffectContext<double>&);
  void (*applyDual)(const EffectOf<Dual>&, EffectContext<Dual>&);
};

const std::vector<EffectKind>& effectKinds();

/// The conditions that it varies with, which readings must state for it to be seen.
[[nodiscard]] std::vector<Condition> conditionsOf(const EffectKind& kind);

/// The row of the catalogue that an effect is of.
[[nodiscard]] const EffectKind& kindOf(const Effect& effect);

/// Index of the kind of that name, or nothing.
[[nodiscard]] std::optional<int> findEffectKind(std::string_view name);

/// A place as it is written in files and reports.
[[nodiscard]] std::string textOf(const Arm& arm, const EffectKind& kind, const Place& place);

/// Every place of an arm where the effect can be, as text.
[[nodiscard]] std::vector<std::string> placeTexts(const Arm& arm, const EffectKind& kind);

/// "this arm has no place for it, which needs a slide": of a kind that has none.
[[nodiscard]] std::string lackOfPlace(const EffectKind& kind);

[[nodiscard]] std::optional<Place> findPlace(const Arm& arm, const EffectKind& kind, std::string_view text);

/// Where it acts, as it is written: `tool.z`; of a formula its target.
[[nodiscard]] std::string placeText(const Arm& arm, const Effect& effect);

/// `backlash@tool.z`
[[nodiscard]] std::string textOf(const Arm& arm, const Effect& effect);

enum class EffectStatus { kNotRun, kMade, kUnknownEffect, kUnknownPlace };

struct MadeEffect {
  EffectStatus status = EffectStatus::kNotRun;
  std::string reason;              ///< why not made
  std::vector<std::string> known;  ///< the names that would have been understood, where one was not
  Effect effect;                   ///< at neutral values
};

/// An effect at its neutral values, from its name and place: ("backlash", "tool.z").
[[nodiscard]] MadeEffect makeEffect(const Arm& arm, std::string_view name, std::string_view at);

/// The numbers of an effect, in the order of its values: those of its kind, or of its formula.
[[nodiscard]] const std::vector<EffectParameter>& numbersOf(const Effect& effect);

/// An effect's number as it is at its place: its quantity there and the bounds that the arm gives it.
struct EffectNumber {
  Quantity quantity;
  double lower, upper;
};
[[nodiscard]] EffectNumber numberOf(const Arm& arm, const Effect& effect, int value);

/// Problems of the arm's effects: unknown kinds, places that the arm does not have, one effect twice at a place,
/// numbers missing or out of their bounds.
[[nodiscard]] std::vector<ArmProblem> findEffectProblems(const Arm& arm);

}  // namespace tubeplan::deflection
