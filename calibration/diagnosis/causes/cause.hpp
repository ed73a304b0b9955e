// Possible causes of a lack of fit: effects of the catalogue at their places, one effect at every joint, or numbers of
// the arm's file that the fit holds at the drawing's values.
#pragma once

#include <string>
#include <vector>

#include "calibration/hooks.hpp"
#include "calibration/placed_arm.hpp"
#include "deflection/effects/effect.hpp"

namespace tubeplan::calibration {

/// Value of Cause::effect for a cause that frees numbers of the arm's file.
inline constexpr const char* kFreedNumbers = "free";

/// Value of Cause::at for an effect that acts at every joint.
inline constexpr const char* kAllJoints = "all joints";

/// Returns a neutral effect of this kind for each revolute joint that does not have it already; empty if the kind is
/// none that may act at every joint.
[[nodiscard]] std::vector<deflection::Effect> effectsAtAllJoints(const deflection::Arm& arm, const std::string& effect);

/// Returns a description of the cause with this name: an effect of the catalogue, or freed numbers.
[[nodiscard]] const char* causeWords(const std::string& effect);

/// Returns the names of the variables that the effect's law may depend on, simplest first; empty: it may depend on any.
[[nodiscard]] std::vector<std::string> causeVariables(const std::string& effect);

struct Cause {
  std::string effect, at;  ///< name and place: "backlash", "tool.z"; "free", "latch-link.beam.Iz"
  /// Effects at neutral values; several of one kind if it acts at every joint.
  std::vector<deflection::Effect> effects;
  std::vector<std::string> frees;  ///< dotted names of freed numbers of the arm's file
  int shape = -1;                  ///< index of the effect's value that is scanned, -1: none
  std::vector<double> levels{0};   ///< scanned values of `shape` [internal units]
  double prior = 0;                ///< probability of this cause if exactly one cause is missing
};

/// Returns true if both are the same kind of effect at the same place, whatever their sizes.
[[nodiscard]] inline bool areOne(const deflection::Effect& a, const deflection::Effect& b) {
  return a.kind == b.kind && a.place == b.place;
}

/// Returns true if both causes contain the same effect at the same place, or free the same number.
[[nodiscard]] bool overlap(const Cause& a, const Cause& b);

/// Returns true if the scanned shape of the cause is the time of a step, before which the effect is zero.
[[nodiscard]] bool isStep(const Cause& cause);

/// Adds the cause to the arm with its shape at `level`. Returns the unknowns for its numbers, which are zero at the
/// neutral values. Their typical size is the largest of real machines.
[[nodiscard]] std::vector<Unknown> placeCause(PlacedArm& placed, const Cause& cause, double level);

/// Returns the unknown for number `value` of effect `effect` of the arm; it is zero at the present value. Its typical
/// size is the largest usual one.
[[nodiscard]] Unknown numberUnknown(const deflection::Arm& arm, int effect, int value);

/// Returns the unknown for a scanned shape that has a derivative (a knee), for a fit that begins at `level`. `effect`
/// is the index of the cause's effect in the arm.
[[nodiscard]] Unknown shapeUnknown(const deflection::Arm& arm, const Cause& cause, int effect, double level);

/// Returns the midpoints [s] between consecutive times of the readings, ascending. A step has the same effect on the
/// readings anywhere between two of them.
[[nodiscard]] std::vector<double> timesBetween(const std::vector<Measurement>& readings);

struct CauseList {
  std::vector<Cause> causes;
  /// Names of causes that were left out, with what each would need: "hysteresis: no column <joint>_dir".
  std::vector<std::string> not_tried;
};

/// Lists every cause that these readings could show, beside the numbers in `free`. Effects that the arm already has at
/// a place are left out. Throws WorkStopped on a request to stop.
[[nodiscard]] CauseList listCauses(const PlacedArm& placed, const std::vector<Measurement>& readings,
                                   const std::vector<Unknown>& free, const WorkHooks& hooks = {});

}  // namespace tubeplan::calibration
