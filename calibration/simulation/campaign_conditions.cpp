#include "calibration/simulation/campaign_conditions.hpp"

#include <algorithm>
#include <cmath>

#include "deflection/rotation.hpp"
#include "deflection/side_chains.hpp"

namespace tubeplan::calibration {

namespace {

// A joint without limits in a side chain ranges over this much on either side of zero [rad or m].
constexpr double kWidest = deflection::kFullTurn / 2;
constexpr double kNoMotion = 1e-9;  // largest motion of a joint that is treated as no motion [rad or m]

bool swings(const deflection::ConditionKind& kind) { return kind.swing.amplitude > 0 || kind.swing.flutter > 0; }

}  // namespace

std::vector<int> MeasurementConditions::approach_directions(const Eigen::VectorXd& from,
                                                            const Eigen::VectorXd& to) const {
  std::vector<int> result;
  for (int k = 0; k < to.size(); ++k) {
    const double way = to[k] - from[k];
    result.push_back(std::abs(way) < kNoMotion ? rests[k] : (way > 0 ? turns[k] : -turns[k]));
  }
  return result;
}

ConditionSeries::ConditionSeries(const deflection::Arm& arm, const CampaignPace& pace, int measurements,
                                 const CampaignDesign& design, std::uint64_t seed)
    : pace_(pace),
      noise_factor_(noiseFactor(design)),
      turn_sigma_(design.turn_sigma),
      push_(design.push),
      period_(std::min(pace.longest_period, measurements * (pace.shortest + pace.longest))),
      usual_(arm.reference),
      conditions_(seed, CampaignRandom::Stream::kConditions),
      noise_(seed, CampaignRandom::Stream::kNoise),
      pushes_(seed, CampaignRandom::Stream::kPushes),
      side_chains_(seed, CampaignRandom::Stream::kSideChains) {
  for (const auto* joint : deflection::sideJoints(arm))
    side_limits_.emplace_back(std::max(joint->lower, -kWidest), std::min(joint->upper, kWidest));
  for (const auto& kind : deflection::kConditionKinds)
    if (swings(kind)) phases_[kind.condition] = conditions_.uniform(0, deflection::kFullTurn);
  for (const auto& joint : arm.joints()) encoder_sigmas_.push_back(joint.encoder_sigma);
}

/// Draws the conditions in the order of kConditionKinds; their oscillations are functions of the simulated time.
void ConditionSeries::drawConditions(deflection::ConditionValues& stated) {
  const double wait = conditions_.uniform(pace_.shortest, pace_.longest);
  time_ += is_first_ ? 0 : wait;
  is_first_ = false;
  stated[Condition::kTime] = time_;
  for (const auto& kind : deflection::kConditionKinds) {
    if (!swings(kind)) continue;
    const double phase = deflection::kFullTurn * time_ / period_ + phases_[kind.condition];
    stated[kind.condition] =
        usual_[kind.condition] + kind.swing.amplitude * std::sin(phase) + conditions_.normal(kind.swing.flutter);
  }
}

MeasurementConditions ConditionSeries::next() {
  MeasurementConditions measurement;
  drawConditions(measurement.stated);
  for (std::size_t k = 0; k < encoder_sigmas_.size(); ++k) {
    measurement.turns.push_back(conditions_.uniform(0, 1) < pace_.overshoot ? -1 : 1);
    measurement.rests.push_back(conditions_.uniform(0, 1) < 0.5 ? -1 : 1);
  }
  measurement.coordinate_noise = noise_factor_ * noise_.vector(1);
  measurement.encoder_noise.resize(static_cast<Eigen::Index>(encoder_sigmas_.size()));
  for (int k = 0; k < measurement.encoder_noise.size(); ++k)
    measurement.encoder_noise[k] = noise_.normal(encoder_sigmas_[k]);
  if (turn_sigma_ > 0) measurement.turn_noise = noise_.vector(turn_sigma_);
  measurement.side_q.resize(static_cast<Eigen::Index>(side_limits_.size()));
  for (Eigen::Index k = 0; k < measurement.side_q.size(); ++k) {
    const auto& [lower, upper] = side_limits_[static_cast<std::size_t>(k)];
    measurement.side_q[k] = side_chains_.uniform(lower, upper);
  }
  if (push_ > 0) measurement.push = push_ * pushes_.uniform(0, 1) * pushes_.vector(1).normalized();
  return measurement;
}

}  // namespace tubeplan::calibration
