#include "calibration/diagnosis/causes/repeated_numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <utility>

#include "calibration/diagnosis/causes/confounding.hpp"
#include "calibration/estimation/span.hpp"
#include "calibration/random_stream.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr std::uint64_t kSeed = 11;
constexpr std::size_t kLeastPostures = 24;

/// Returns measurements of the tip's position at random postures, and of the tool's rotation if the measurements show
/// it. Loads and conditions are those of measurements `all`, taken in turn; every sigma is 1 m or 1 rad.
std::vector<Measurement> measurementsAllOver(const PlacedArm& placed, const std::vector<Measurement>& all,
                                             std::size_t count) {
  RandomStream random(kSeed);
  std::vector<Measurement> made;
  for (std::size_t k = 0; k < count; ++k) {
    Measurement measurement = all[k * all.size() / count];
    measurement.kind = placed.shows_tool_turn ? MeasurementKind::kPose : MeasurementKind::kPosition;
    measurement.point.clear();
    measurement.reference.reset();
    measurement.p_TQ.reset(), measurement.direction_W.reset(), measurement.surface.reset(), measurement.row.reset();
    measurement.sigma_W.reset(), measurement.correlation_W.reset();
    measurement.p_W = Eigen::Vector3d::Zero();
    measurement.kind_values.setZero();
    measurement.sigma = measurement.turn_sigma = 1;
    for (Index j = 0; j < measurement.q.size(); ++j) {
      const auto [lower, upper] = deflection::rangeOf(placed.arm, placed.arm.joint(j));
      measurement.q[j] = random.uniform(lower, upper);
    }
    made.push_back(std::move(measurement));
  }
  return made;
}

/// Returns the fraction of each column's norm that lies outside the span of the orthonormal basis `Q`; 1 for a column
/// of zeros, which shows nothing.
VectorXd fractionOutsideSpan(const MatrixXd& Q, const MatrixXd& columns) {
  const MatrixXd outside = without(Q, columns);
  VectorXd kept(columns.cols());
  for (Index c = 0; c < columns.cols(); ++c) {
    const double length = columns.col(c).norm();
    kept[c] = length > 0 ? outside.col(c).norm() / length : 1;
  }
  return kept;
}

/// Returns true if every column of a cause of one effect is in the span; false for steps and for other causes.
bool isRepeated(const Cause& cause, int index, const Signatures& signatures, const VectorXd& kept) {
  if (cause.effects.size() != 1 || isStep(cause)) return false;
  for (int level = 0; level < static_cast<int>(cause.levels.size()); ++level)
    for (const int column : signatures.columnsOf(index, level))
      if (kept[column] > kHardlyKept) return false;
  return true;
}

/// Removes the effects of the causes `repeated` from the causes that act at every joint, and each such cause with fewer
/// than two effects left.
void removeFromCollective(const std::vector<Cause>& repeated, std::vector<Cause>& causes) {
  std::erase_if(causes, [&](Cause& cause) {
    if (cause.effects.size() < 2) return false;
    std::erase_if(cause.effects, [&](const deflection::Effect& effect) {
      return std::ranges::any_of(
          repeated, [&](const Cause& repeated_cause) { return areOne(repeated_cause.effects.front(), effect); });
    });
    return cause.effects.size() < 2;
  });
}

}  // namespace

bool removeRepeated(const PlacedArm& placed, const std::vector<Measurement>& measurements,
                    const std::vector<Unknown>& fitted, const Signatures& signatures, CauseList& list,
                    const StopQuestion& stop) {
  const bool has_geometry = std::ranges::any_of(
      fitted, [](const Unknown& unknown) { return unknown.owner == Unknown::Owner::kArm && unknown.path.effect < 0; });
  if (!has_geometry || measurements.empty()) return false;
  const auto postures = measurementsAllOver(placed, measurements, std::max(kLeastPostures, 2 * fitted.size()));
  const auto weights = weighMeasurements(placed, postures, {}, 0, stop);
  if (!weights) return false;
  const auto by_fitted = whitenedResidual(placed, fitted, postures, *weights, zerosOf(fitted), true, stop);
  const MatrixXd by_causes = signatures.columnsAt(postures, *weights, stop);
  if (!by_fitted.ok || by_causes.rows() != weights->rows) return false;
  const VectorXd kept = fractionOutsideSpan(spanOf(by_fitted.jacobian), by_causes);
  std::vector<Cause> repeated;
  std::map<std::string, std::vector<std::string>> places_of;
  int index = 0;
  std::erase_if(list.causes, [&](const Cause& cause) {
    if (!isRepeated(cause, index++, signatures, kept)) return false;
    places_of[cause.effect].push_back(cause.at);
    repeated.push_back(cause);
    return true;
  });
  removeFromCollective(repeated, list.causes);
  for (const auto& [effect, places] : places_of)
    list.not_tried.push_back(fmt::format("{}: at {} the free numbers of the arm's file have the same effect", effect,
                                         fmt::join(places, ", ")));
  return !repeated.empty();
}

}  // namespace tubeplan::calibration
