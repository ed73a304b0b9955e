// Changes of a calibrated arm in service that a watch can identify: a displacement of the base, and every cause of the
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

/// Remedy for a change; each has one row in the table of remedies.
enum class Remedy {
  kCalibrateBase,   ///< base calibration with three new touches
  kReferenceJoint,  ///< new reference of the joint's zero
  kInspectJoint,    ///< inspection of the named place for play or compliance
  kRemeasureArm,    ///< new identification of the arm's geometry, weights or measuring system
  kAwaitWarmth,     ///< calibration at a steady or stated temperature
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
  /// Condition that no measurement states and that the change assumes to differ by `assumed_change`; may be empty.
  std::optional<deflection::Condition> assumed;
  double assumed_change = 0;
};

struct CandidateChanges {
  std::vector<CandidateChange> list;  ///< candidates; the displacement of the base comes first
  Eigen::MatrixXd columns;            ///< whitened derivatives, rows of `weights` x numbers
  std::vector<std::string> not_seen;  ///< candidates without any effect on these measurements
};

/// Returns the candidates with their columns at these measurements, whose rows are those of `weights`; `by_base` are
/// the derivatives with respect to a base step. Columns are empty if the model cannot be evaluated.
[[nodiscard]] CandidateChanges candidateChanges(const PlacedArm& placed, const std::vector<Measurement>& measurements,
                                                const MeasurementWeights& weights, const Eigen::MatrixXd& by_base,
                                                const StopQuestion& stop);

}  // namespace tubeplan::calibration
