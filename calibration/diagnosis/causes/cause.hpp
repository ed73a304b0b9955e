// What may be behind a lack of fit: effects of the catalogue at their places, one effect at all joints alike, or
// numbers of the arm's file that the fit holds at their drawing's values.
#pragma once

#include <string>
#include <vector>

#include "calibration/hooks.hpp"
#include "calibration/placed_arm.hpp"
#include "deflection/effects/effect.hpp"

namespace tubeplan::calibration {

/// The name that freed numbers have in the place of an effect's.
inline constexpr const char* kFreedNumbers = "free";

/// The place of an effect that acts at every joint alike.
inline constexpr const char* kAllJoints = "all joints";

/// The catalogue's effect at every joint, neutral; empty where it acts at no joint, or at none that it has not got.
[[nodiscard]] std::vector<deflection::Effect> effectsAtAllJoints(const deflection::Arm& arm, const std::string& effect);

/// What a cause of that name is, for a reader who does not know it: an effect of the catalogue, or freed numbers.
[[nodiscard]] const char* causeWords(const std::string& effect);

/// What its law may hang on, by name, the plainest first; empty: on anything.
[[nodiscard]] std::vector<std::string> causeVariables(const std::string& effect);

struct Cause {
  std::string effect, at;                   ///< "backlash", "tool.z"; "free", "latch-link.beam.Iz"
  std::vector<deflection::Effect> effects;  ///< at neutral values; several of one kind at all joints alike
  std::vector<std::string> frees;           ///< dotted names of the arm's file
  int shape = -1;                           ///< the value of its effect that is scanned, -1: none
  std::vector<double> levels{0};            ///< of that value, in internal units
  double prior = 0;                         ///< its share of the probability that exactly one cause is missing
};

/// Returns true if they are one effect at one place, whatever their sizes.
[[nodiscard]] inline bool areOne(const deflection::Effect& a, const deflection::Effect& b) {
  return a.kind == b.kind && a.place == b.place;
}

/// Whether they hold one effect at one place between them, or free one number.
[[nodiscard]] bool overlap(const Cause& a, const Cause& b);

/// Whether the shape of a cause is the time of a step, before which it does nothing.
[[nodiscard]] bool isStep(const Cause& cause);

/// Puts the cause into the arm, its shape at `level`; the numbers that it frees, 0 where they do nothing. Their typical
/// size is the largest that a real machine has.
[[nodiscard]] std::vector<Unknown> placeCause(PlacedArm& placed, const Cause& cause, double level);

/// A number of an effect that the arm carries, 0 where it stands; its typical size is the largest usual one.
[[nodiscard]] Unknown numberUnknown(const deflection::Arm& arm, int effect, int value);

/// The unknown of a scanned shape that has a derivative (a knee), for a fit that begins at `level`; `effect` is the
/// index that the cause's effect got in the arm.
[[nodiscard]] Unknown shapeUnknown(const deflection::Arm& arm, const Cause& cause, int effect, double level);

/// Returns the midpoints between the times of readings, in order: a step between two readings looks the same wherever
/// it is.
[[nodiscard]] std::vector<double> timesBetween(const std::vector<Measurement>& readings);

struct CauseList {
  std::vector<Cause> causes;
  std::vector<std::string>
      not_tried;  ///< what was left out and what it would need: "hysteresis: no column <joint>_dir"
};

/// Every cause that these readings could show of an arm, beside what `free` names. Effects that the arm already has at
/// a place are left out. Unwinds where it was stopped.
[[nodiscard]] CauseList listCauses(const PlacedArm& placed, const std::vector<Measurement>& readings,
                                   const std::vector<Unknown>& free, const WorkHooks& hooks = {});

}  // namespace tubeplan::calibration
