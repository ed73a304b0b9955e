// The path of a plan as a function of time.
#include "planner/timing/flowing_timing.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::planner {

namespace {

std::vector<TimedPosture> samplesOf(const PathSegment& segment, const JointSpeeds& speeds, double max_step) {
  return segment.flows ? sampleFlow(timeFlow(segment.waypoints, speeds), max_step)
                       : samplePolyline(timePolyline(segment.waypoints, speeds), max_step);
}

}  // namespace

double durationOf(const PathSegment& segment, const JointSpeeds& speeds) {
  return segment.flows ? timeFlow(segment.waypoints, speeds).duration
                       : timePolyline(segment.waypoints, speeds).duration;
}

std::vector<Eigen::VectorXd> cornersOf(const PathSegment& segment, const JointSpeeds& speeds) {
  return segment.flows ? cornersOf(timeFlow(segment.waypoints, speeds)) : segment.waypoints;
}

std::vector<PathRow> samplePath(const VisitPlan& plan, const JointSpeeds& speeds, double max_step) {
  std::vector<PathRow> rows;
  double start = 0;
  for (std::size_t k = 0; k < plan.segments.size(); ++k) {
    const auto& segment = plan.segments[k];
    const bool leaves_visit = segment.kind == SegmentKind::kRetreat && segment.visit >= 0;
    const double dwell = leaves_visit ? plan.visits[static_cast<std::size_t>(segment.visit)].dwell : 0;
    start += dwell;
    const auto samples = samplesOf(segment, speeds, max_step);
    // Skip the first row of a segment, which repeats the last row of the previous one, unless the arm dwelt there.
    for (std::size_t s = rows.empty() || dwell > 0 ? 0 : 1; s < samples.size(); ++s)
      rows.push_back({start + samples[s].time, static_cast<int>(k), segment.kind, samples[s].posture});
    start += durationOf(segment, speeds);
  }
  return rows;
}

}  // namespace tubeplan::planner
