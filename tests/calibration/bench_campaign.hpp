// Small simulated measurement campaigns with the Cobra arm on the bench.
#pragma once

#include <cmath>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/simulation/simulated_campaign.hpp"
#include "tests/units.hpp"

namespace tubeplan::calibration {

inline const app::Cell& benchCell() {
  static const app::Cell kCell = app::readCell(TUBEPLAN_SOURCE_DIR "/app/cells/bench.yaml");
  return kCell;
}

inline const app::Cell& mockupCell() {
  static const app::Cell kCell = app::readCell(TUBEPLAN_SOURCE_DIR "/app/cells/mockup.yaml");
  return kCell;
}

inline deflection::Arm withEncoders(deflection::Arm arm, double sigma) {
  for (auto& row : arm.rows) row.joint.encoder_sigma = sigma;
  return arm;
}

/// Returns the bench's arm with random changes of its stiffnesses, on bases displaced from their nominal poses.
inline CampaignTruth benchTruth(int setups = 1, double encoder_sigma = 0) {
  TruthOptions options;
  options.parameters = deflection::parametersOf(benchCell().arm);
  options.spread = 0.1;
  options.base_shift_sigma = 0.5 * kInch;
  options.base_turn_sigma = 0.01;
  options.setups = setups;
  return drawTruth(withEncoders(benchCell().arm, encoder_sigma), benchCell().X_WB, options);
}

inline CampaignDesign designOf(MeasurementKind kind, double sigma) {
  CampaignDesign design;
  design.kind = kind;
  design.loads = {0, 20 * kPound, 40 * kPound};
  if (kind == MeasurementKind::kDeflection) design.loads = {20 * kPound, 40 * kPound};
  if (kind == MeasurementKind::kDistance) design.anchor_W = Eigen::Vector3d(1, 2, 0.5);
  design.sigma = sigma;
  return design;
}

inline SimulatedCampaign simulate(const CampaignTruth& truth, const CampaignDesign& design, int measurements,
                                  std::uint64_t seed = 1) {
  CampaignOptions options;
  options.measurements = measurements;
  options.seed = seed;
  return simulateCampaign(truth, design, options);
}

/// Returns the root mean square of the values.
inline double deviation(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace tubeplan::calibration
