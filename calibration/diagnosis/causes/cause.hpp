// Possible causes of a lack of fit: a catalogued effect at one location or at every joint, or nominal parameters of the
// arm that should be fitted.
#pragma once

#include <string>
#include <vector>

#include "calibration/hooks.hpp"
#include "calibration/placed_arm.hpp"
#include "deflection/effects/effect.hpp"

namespace tubeplan::calibration {

/// Value of Cause::effect for a cause that frees parameters of the arm's file.
inline constexpr const char* kFreedNumbers = "free";

/// Value of Cause::at for a cause that frees all geometric parameters.
inline constexpr const char* kAllGeometry = "geometry";

/// Value of Cause::at for an effect that acts at every joint.
inline constexpr const char* kAllJoints = "all joints";

/// Returns a neutral effect of the kind named `effect` for each revolute joint that does not have such an effect yet.
/// Empty if this kind of effect cannot act at every joint.
[[nodiscard]] std::vector<deflection::Effect> effectsAtAllJoints(const deflection::Arm& arm, const std::string& effect);

/// Returns the description of the cause named `effect`, which is an effect of the catalogue or kFreedNumbers; an empty
/// string if there is no such cause. `at` is its place, which distinguishes one freed parameter from the whole
/// geometry.
[[nodiscard]] const char* causeWords(const std::string& effect, const std::string& at = "");

/// Returns the title of a cause for sentences: "hysteresis at theta4", or for freed parameters "geometry: numbers of
/// the arm's file are off".
[[nodiscard]] std::string causeTitle(const std::string& effect, const std::string& at);

/// Returns the title of a cause in the notation `EFFECT@PLACE`, with or without sizes after a colon.
[[nodiscard]] std::string causeTitle(const std::string& cause);

/// Returns the names of the variables that the effect's law may depend on, simplest first. An empty list means that the
/// law may depend on any variable.
[[nodiscard]] std::vector<std::string> causeVariables(const std::string& effect);

struct Cause {
  std::string effect, at;  ///< name and place, such as "backlash" at "tool.z" or "free" at "latch-link.beam.Iz"
  /// Effects at neutral values; several effects of one kind if the cause acts at every joint.
  std::vector<deflection::Effect> effects;
  std::vector<std::string> frees;  ///< dotted names of the freed parameters of the arm's file
  int shape = -1;                  ///< index of the effect's parameter whose value is scanned; -1 if none
  std::vector<double> levels{0};   ///< scanned values of parameter `shape` [internal units]
  double prior = 0;  ///< prior probability of this cause, given that exactly one cause is missing from the model
};

/// Returns true if both effects are of the same kind and at the same place, regardless of their values.
[[nodiscard]] inline bool areOne(const deflection::Effect& a, const deflection::Effect& b) {
  return a.kind == b.kind && a.place == b.place;
}

/// Returns true if both causes contain the same effect at the same place, or free the same parameter.
[[nodiscard]] bool overlap(const Cause& a, const Cause& b);

/// Returns true unless the cause extends an effect (EffectKind::extends) that is not among `effects` at its place.
[[nodiscard]] bool mayActBeside(const Cause& cause, const std::vector<deflection::Effect>& effects);

/// Returns true if the scanned parameter of the cause is the time of a step, before which the effect is zero.
[[nodiscard]] bool isStep(const Cause& cause);

/// Adds the cause to the arm, with its scanned parameter set to `level`. Returns the unknowns for the cause's other
/// parameters. The unknowns are zero at the neutral values; the typical size of each is the largest value found on real
/// machines.
[[nodiscard]] std::vector<Unknown> placeCause(PlacedArm& placed, const Cause& cause, double level);

/// Returns the unknown for parameter `value` of effect `effect` of the arm; the unknown is zero at the parameter's
/// present value. Its typical size is the largest usual value of the parameter.
[[nodiscard]] Unknown numberUnknown(const deflection::Arm& arm, int effect, int value);

/// Returns the unknown for a scanned parameter, for a fit that starts at the value `level`. The residuals must depend
/// smoothly on the parameter, such as on the knee of a stiffness. `effect` is the index of the cause's effect in the
/// arm.
[[nodiscard]] Unknown shapeUnknown(const deflection::Arm& arm, const Cause& cause, int effect, double level);

/// Returns the midpoints [s] between consecutive times of the measurements, ascending. One step time per interval
/// suffices, because the measurements do not depend on where in the interval the step occurs.
[[nodiscard]] std::vector<double> timesBetween(const std::vector<Measurement>& measurements);

struct CauseList {
  std::vector<Cause> causes;
  /// Effects that were not tried, each with the reason, such as "payload-offset: no measurement is under a load".
  std::vector<std::string> not_tried;
};

/// Lists every cause that these measurements could reveal in addition to the unknowns in `free`, except effects that
/// the arm already has at the same place. Throws WorkStopped on a request to stop.
[[nodiscard]] CauseList listCauses(const PlacedArm& placed, const std::vector<Measurement>& measurements,
                                   const std::vector<Unknown>& free, const WorkHooks& hooks = {});

}  // namespace tubeplan::calibration
