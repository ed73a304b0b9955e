// Changes of a calibrated arm at work that a watch can name: a displacement of the base, and every cause of the
// diagnosis at each of its places.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "calibration/diagnosis/causes/signatures.hpp"

namespace tubeplan::calibration {

/// Value of CandidateChange::effect for a displacement of the base.
inline constexpr const char* kBaseMoved = "base-step";

/// What to do about a change; one row of the table of remedies for each.
enum class Remedy {
  kCalibrateBase,   ///< touch three holes again and calibrate the base
  kReferenceJoint,  ///< reference the joint's zero again
  kInspectJoint,    ///< look for play or softness at the named place
  kRemeasureArm,    ///< the arm's geometry, weights or measuring system changed: identify them
  kAwaitWarmth,     ///< wait until the temperature is steady, or state it, and calibrate again
};

/// A number of a candidate change.
struct ChangeNumber {
  std::string name;
  deflection::Quantity quantity = deflection::Quantity::kNone;
  double typical = 1;           ///< largest change found on real machines; columns are derivatives per this change
  double lower = 0, upper = 0;  ///< bounds of the change [typical]
  /// Unknown whose variable changes; empty for the displacement of the base.
  std::optional<Unknown> unknown = {};
};

struct CandidateChange {
  std::string effect, at;
  double prior = 0;  ///< prior probability of this change, given that one of the candidates occurred
  Remedy remedy = Remedy::kRemeasureArm;
  std::vector<ChangeNumber> numbers;
  std::vector<int> columns;  ///< column of each number in the matrix of all candidates
  /// Condition that no measurement states, and which the change assumes to differ by `assumed_change`; empty: none.
  std::optional<deflection::Condition> assumed;
  double assumed_change = 0;
};

struct CandidateChanges {
  std::vector<CandidateChange> list;  ///< the displacement of the base first
  Eigen::MatrixXd columns;            ///< whitened derivatives, rows of `weights` x numbers
  std::vector<std::string> not_seen;  ///< candidates that these measurements cannot show at all
};

/// Returns the candidates with their columns at these measurements, whose rows are those of `weights`; `by_base` are
/// the derivatives with respect to a base step. Columns are empty if the model cannot be evaluated.
[[nodiscard]] CandidateChanges candidateChanges(const PlacedArm& placed, const std::vector<Measurement>& measurements,
                                                const MeasurementWeights& weights, const Eigen::MatrixXd& by_base,
                                                const StopQuestion& stop);

}  // namespace tubeplan::calibration
