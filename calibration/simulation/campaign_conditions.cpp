#include "calibration/simulation/campaign_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tubeplan::calibration {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kRest = 1e-9;  // rad or m: less is no motion

}  // namespace

std::vector<int> ReadingConditions::approach_directions(const Eigen::VectorXd& from, const Eigen::VectorXd& to) const {
  std::vector<int> result;
  for (int k = 0; k < to.size(); ++k) {
    const double way = to[k] - from[k];
    result.push_back(std::abs(way) < kRest ? rests[k] : (way > 0 ? turns[k] : -turns[k]));
  }
  return result;
}

ConditionSeries::ConditionSeries(const deflection::Arm& arm, const CampaignPace& pace, int readings, double sigma,
                                 double turn_sigma, std::uint64_t seed)
    : pace_(pace),
      sigma_(sigma),
      turn_sigma_(turn_sigma),
      reference_(arm.reference_temperature),
      period_(std::min(pace.longest_period, readings * (pace.shortest + pace.longest))),
      conditions_(seed, CampaignRandom::Stream::kConditions),
      noise_(seed, CampaignRandom::Stream::kNoise) {
  phase_ = conditions_.uniform(0, kTurn);
  for (const int row : deflection::activeRows(arm)) encoder_sigmas_.push_back(arm.rows[row].joint.encoder_sigma);
}

ReadingConditions ConditionSeries::next() {
  ReadingConditions reading;
  const double wait = conditions_.uniform(pace_.shortest, pace_.longest);
  time_ += is_first_ ? 0 : wait;
  is_first_ = false;
  reading.time = time_;
  reading.temperature =
      reference_ + pace_.swing * std::sin(kTurn * time_ / period_ + phase_) + conditions_.normal(pace_.flutter);
  for (std::size_t k = 0; k < encoder_sigmas_.size(); ++k) {
    reading.turns.push_back(conditions_.uniform(0, 1) < pace_.overshoot ? -1 : 1);
    reading.rests.push_back(conditions_.uniform(0, 1) < 0.5 ? -1 : 1);
  }
  reading.coordinate_noise = noise_.vector(sigma_);
  reading.encoder_noise.resize(static_cast<Eigen::Index>(encoder_sigmas_.size()));
  for (int k = 0; k < reading.encoder_noise.size(); ++k) reading.encoder_noise[k] = noise_.normal(encoder_sigmas_[k]);
  if (turn_sigma_ > 0) reading.turn_noise = noise_.vector(turn_sigma_);
  return reading;
}

}  // namespace tubeplan::calibration
