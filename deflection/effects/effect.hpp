// The catalogue of physical effects: deviations of an arm from its file. Each is a law in one file and a row of the
// table in effects.cpp; nothing else names it.
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
  double neutral;         ///< value without effect, all other numbers being neutral
  double lower, upper;    ///< hard physical bounds
  double plausible;       ///< largest size on a real machine; anything beyond is no explanation
  bool is_shape = false;  ///< true: has a meaning only while the effect is not neutral, and must be scanned
  double (*least)(const Arm&, const Place&) = nullptr;  ///< replaces `lower` if the arm decides it
};

/// A variable on which a law depends: one of these, or a condition.
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

/// Returns joint, sense, load, moment, position, set-up, or a condition's name.
[[nodiscard]] const char* nameOf(EffectVariable variable);

/// Part of the model that an effect acts on.
enum class EffectStage { kReading, kGeometry, kLoad, kFlexibility, kBase, kMeasurement };

/// Notation of a place: `theta2`, `theta3<-theta2`, `forearm`, `tool.z`, the name of a set-up of the base, or the
/// kind's fixed word.
enum class PlaceRule { kJoint, kJointPair, kLink, kRowAxis, kSetup, kWord };

/// Requirements for an effect to be observable, besides the conditions that it varies with: columns of the
/// measurements, a hung load, any moments (weights of the arm, or a load), an arm without stated weights, or readings
/// that depend on the tool's rotation.
struct EffectNeeds {
  bool approach_directions = false, load = false, moments = false, no_weights = false, tool_turn = false;
};

/// One row of the effect table.
struct EffectKind {
  const char* name;
  const char* words;  ///< description for a reader who does not know its name
  const char* law;    ///< the law in one line
  const char* validity;
  const char* source;
  EffectStage stage;
  PlaceRule at;
  const char* word = "";              ///< name of the only place, for PlaceRule::kWord
  const char* place_needs = "";       ///< feature of an arm that a place requires, if its file may lack it: "a slide"
  const char* places_elsewhere = "";  ///< place of its action, if it has none in the arm
  double odds = 1;  ///< prior odds of the kind against others, shared by its places; 0: tried only on request
  const char* odds_reason = "";             ///< reason for the odds
  std::vector<EffectVariable> varies_with;  ///< plainest first; empty: may vary with anything
  EffectNeeds needs;
  std::vector<EffectParameter> parameters;
  std::vector<Place> (*places)(const Arm&);  ///< returns every place of an arm where the effect can be
  void (*apply)(const EffectOf<double>&, EffectContext<double>&);
  void (*applyDual)(const EffectOf<Dual>&, EffectContext<Dual>&);
};

const std::vector<EffectKind>& effectKinds();

/// Returns the conditions that the effect varies with, which readings must state for it to be seen.
[[nodiscard]] std::vector<Condition> conditionsOf(const EffectKind& kind);

/// Returns the kind of an effect.
[[nodiscard]] const EffectKind& kindOf(const Effect& effect);

/// Returns the index of the kind of that name, or nothing.
[[nodiscard]] std::optional<int> findEffectKind(std::string_view name);

/// Returns a place as it is written in files and reports.
[[nodiscard]] std::string textOf(const Arm& arm, const EffectKind& kind, const Place& place);

/// Returns every place of an arm where the effect can be, as text.
[[nodiscard]] std::vector<std::string> placeTexts(const Arm& arm, const EffectKind& kind);

/// Returns "this arm has no place for it, which needs a slide", for a kind without places.
[[nodiscard]] std::string lackOfPlace(const EffectKind& kind);

[[nodiscard]] std::optional<Place> findPlace(const Arm& arm, const EffectKind& kind, std::string_view text);

/// Returns the place of an effect as written, `tool.z`; for a formula its target.
[[nodiscard]] std::string placeText(const Arm& arm, const Effect& effect);

/// Returns the full name of an effect, `backlash@tool.z`.
[[nodiscard]] std::string textOf(const Arm& arm, const Effect& effect);

enum class EffectStatus { kNotRun, kMade, kUnknownEffect, kUnknownPlace };

struct MadeEffect {
  EffectStatus status = EffectStatus::kNotRun;
  std::string reason;              ///< reason if not made
  std::vector<std::string> known;  ///< valid names, if the name was unknown
  Effect effect;                   ///< the effect at neutral values
};

/// Makes an effect at its neutral values from its name and place: ("backlash", "tool.z").
[[nodiscard]] MadeEffect makeEffect(const Arm& arm, std::string_view name, std::string_view at);

/// Returns the numbers of an effect, in the order of its values: those of its kind, or of its formula.
[[nodiscard]] const std::vector<EffectParameter>& numbersOf(const Effect& effect);

/// An effect's number at its place: its quantity there and the bounds that the arm gives it.
struct EffectNumber {
  Quantity quantity;
  double lower, upper;
};
[[nodiscard]] EffectNumber numberOf(const Arm& arm, const Effect& effect, int value);

/// Returns the problems of the arm's effects: unknown kinds, places that the arm does not have, one effect twice at a
/// place, numbers missing or out of their bounds.
[[nodiscard]] std::vector<ArmProblem> findEffectProblems(const Arm& arm);

}  // namespace tubeplan::deflection
