#include "app/workbench/path_answer.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/formats/arm/joint_units.hpp"
#include "app/formats/units.hpp"
#include "app/formats/units_json.hpp"
#include "app/storage/input_error.hpp"
#include "planner/collision/arm_clearance.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

constexpr double kMostSamples = 20000;

std::vector<planner::PathRow> samplesOf(const PlanOutcome& outcome) {
  const double step = std::max(0.25, outcome.plan.total_time / kMostSamples);
  return planner::samplePath(outcome.plan, planner::jointSpeedsOf(outcome.model.arm), step);
}

double forPlaying(double value) { return std::round(value * 1e6) / 1e6; }

/// Returns the clearance of a motion or a posture: its margin plus the scene's required clearance; null without
/// objects.
json clearanceJson(const PlanOutcome& outcome, double margin) {
  if (!std::isfinite(margin)) return nullptr;
  return forPlaying(lengthOf(margin + outcome.model.scene.clearance, outcome.cell.units));
}

planner::ContactRule ruleOf(planner::SegmentKind kind) {
  return kind == planner::SegmentKind::kTravel ? planner::ContactRule::kTravel : planner::ContactRule::kApproach;
}

}  // namespace

json pathAnswer(const PlanOutcome& outcome) {
  const Eigen::VectorXd factors = jointFactors(outcome.cell.arm, outcome.cell.units);
  json time = json::array(), segment = json::array(), kind = json::array(), joints = json::array(),
       clearance = json::array(), tube = json::array();
  for (const auto& row : samplesOf(outcome)) {
    time.push_back(forPlaying(row.time));
    segment.push_back(row.segment);
    kind.push_back(planner::nameOf(row.kind));
    json q = json::array();
    for (const double value : row.q.cwiseQuotient(factors)) q.push_back(forPlaying(value));
    joints.push_back(std::move(q));
    tube.push_back(outcome.plan.segments[static_cast<std::size_t>(row.segment)].visit);
  }
  for (const auto& part : outcome.plan.segments) clearance.push_back(clearanceJson(outcome, part.margin));
  return {{"units", unitsJson(outcome.cell.units)},
          {"time", time},
          {"segment", segment},
          {"kind", kind},
          {"joints", joints},
          {"tube", tube},
          {"clearance", clearance}};
}

json clearanceAlong(const PlanOutcome& outcome, std::size_t from, std::size_t count) {
  const auto samples = samplesOf(outcome);
  if (from >= samples.size())
    throw InputError("request (from)", fmt::format("{}", from), fmt::format("0 to {}", samples.size() - 1));
  const planner::ArmClearance clear(outcome.model);
  std::vector<double> margins(std::min({count, kMostClearances, samples.size() - from}));
  oneapi::tbb::parallel_for(std::size_t{0}, margins.size(), [&](std::size_t k) {
    const auto& sample = samples[from + k];
    margins[k] = clear.at(sample.q, ruleOf(sample.kind)).margin;
  });
  json clearance = json::array();
  for (const double margin : margins) clearance.push_back(clearanceJson(outcome, margin));
  return {
      {"units", unitsJson(outcome.cell.units)}, {"from", from}, {"samples", samples.size()}, {"clearance", clearance}};
}

}  // namespace tubeplan::app
