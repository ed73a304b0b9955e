#include "calibration/watch/separating_means.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/random_stream.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr int kMostVirtual = 24;          // number of virtual measurements of each means
constexpr std::size_t kMostCompared = 8;  // number of answers that are compared, the most probable ones
constexpr double kSeparated = 9;          // squared distance in standard deviations from which on a pair is separated
constexpr double kTipLoad = 100;          // load hung from the tip [N]
constexpr double kInclinometer = 2e-4;    // standard deviation of a tilt [rad]

Measurement touchAt(const Measurement& visit) {
  Measurement touch = visit;
  touch.kind = MeasurementKind::kTouch;
  touch.point = "hole";
  touch.kind_values.setConstant(kNotKnown);
  touch.row.reset();
  touch.p_TQ.reset();
  touch.sigma = kTouchSigma;
  touch.sigma_W.reset();
  touch.correlation_W.reset();
  return touch;
}

void leave(const deflection::Arm&, RandomStream&, Measurement&) {}
void hangLoad(const deflection::Arm&, RandomStream&, Measurement& touch) { touch.load += kTipLoad; }
void measureTurn(const deflection::Arm&, RandomStream&, Measurement& touch) {
  touch.kind = MeasurementKind::kOrientation;
  touch.kind_values.setZero();
  touch.turn_sigma = kInclinometer;
  touch.sigma = kTurnLever * kInclinometer;
}
void trackAnywhere(const deflection::Arm& arm, RandomStream& random, Measurement& touch) {
  touch.kind = MeasurementKind::kPosition;
  touch.sigma = kPositionSigma;
  for (Index j = 0; j < arm.jointCount(); ++j) {
    const auto& joint = arm.joint(j);
    const bool is_limited = std::isfinite(joint.lower) && std::isfinite(joint.upper);
    touch.q[j] =
        random.uniform(is_limited ? joint.lower : -std::numbers::pi, is_limited ? joint.upper : std::numbers::pi);
  }
}

struct MeansRow {
  const char *name, *words;
  void (*change)(const deflection::Arm& arm, RandomStream& random, Measurement& touch);
};
constexpr MeansRow kMeans[] = {
    {"touch", "touch a dozen of the visited holes or more", leave},
    {"load", "touch holes with and without 100 N (22 lbf) hung from the tool", hangLoad},
    {"turn", "measure the inclination of the tool at the visited holes", measureTurn},
    {"track", "measure the tip by a tracker over the joints' whole range, with different turns of the tool",
     trackAnywhere},
};

/// An answer as it predicts the virtual measurements.
struct Predicted {
  VectorXd shift;
  MatrixXd spread;  // columns times a square root of the numbers' covariance
};

bool isSeparated(const Predicted& a, const Predicted& b, const MatrixXd& noise) {
  const VectorXd d = a.shift - b.shift;
  return d.dot((noise + b.spread * b.spread.transpose()).llt().solve(d)) >= kSeparated &&
         d.dot((noise + a.spread * a.spread.transpose()).llt().solve(d)) >= kSeparated;
}

Predicted predictedBy(const ChangeAnswer& answer, const RowsAndCandidates& at) {
  for (const CandidateChange& candidate : at.candidates.list) {
    if (candidate.effect != answer.effect || candidate.at != answer.at) continue;
    Predicted predicted{VectorXd::Zero(at.rows.r.size()),
                        MatrixXd(at.rows.r.size(), static_cast<Index>(candidate.columns.size()))};
    for (std::size_t k = 0; k < candidate.columns.size(); ++k) {
      const auto column = at.rows.changes.col(candidate.columns[k]);
      predicted.shift += column * answer.numbers[k].fitted;
      predicted.spread.col(static_cast<Index>(k)) = column * answer.numbers[k].fitted_sigma;
    }
    return predicted;
  }
  return Predicted{VectorXd::Zero(at.rows.r.size()), MatrixXd(at.rows.r.size(), 0)};  // no effect on these rows
}

int separatedPairs(const RowsAndCandidates& at, const ErrorState& state, std::span<const ChangeAnswer> answers) {
  std::vector<Predicted> predicted;
  for (const ChangeAnswer& answer : answers) predicted.push_back(predictedBy(answer, at));
  const Index n = at.rows.r.size();
  const MatrixXd noise = MatrixXd::Identity(n, n) + at.rows.H * state.covariance * at.rows.H.transpose();
  int pairs = 0;
  for (std::size_t a = 0; a < predicted.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) pairs += isSeparated(predicted[a], predicted[b], noise);
  return pairs;
}

/// Returns virtual measurements at a selection of the visits, by the means.
std::vector<Measurement> virtualOnes(const WatchedArm& watched, const std::vector<Measurement>& visits,
                                     const MeansRow& means) {
  RandomStream random(1);
  std::vector<Measurement> chosen;
  const std::size_t step = std::max<std::size_t>(1, visits.size() / kMostVirtual);
  for (std::size_t k = 0; k < visits.size() && chosen.size() < kMostVirtual; k += step) {
    if (!visits[k].p_W) continue;
    Measurement touch = touchAt(visits[k]);
    means.change(watched.arm, random, touch);
    if (predictMeasurement(watched.arm, watched.X_WB, touch).ok) chosen.push_back(std::move(touch));
  }
  return chosen;
}

}  // namespace

std::optional<SeparatingMeans> separatingMeans(const WatchedArm& watched, const std::vector<Measurement>& visits,
                                               const ErrorState& state, const std::vector<ChangeAnswer>& answers,
                                               const StopQuestion& stop) {
  const std::span<const ChangeAnswer> compared(answers.data(), std::min(answers.size(), kMostCompared));
  std::optional<SeparatingMeans> best;
  if (compared.size() < 2) return best;
  const int all = static_cast<int>(compared.size() * (compared.size() - 1) / 2);
  for (const MeansRow& means : kMeans) {
    const auto chosen = virtualOnes(watched, visits, means);
    if (chosen.empty()) continue;
    const RowsAndCandidates at = watchedRows(watched, chosen, stop);
    if (!at.rows.reason.empty()) continue;
    const int pairs = separatedPairs(at, state, compared);
    if (pairs > (best ? best->pairs : 0)) best = SeparatingMeans{means.name, means.words, pairs, all};
  }
  return best;
}

}  // namespace tubeplan::calibration
