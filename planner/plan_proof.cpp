#include "planner/plan_proof.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <mutex>

#include "planner/motion/side_by_side.hpp"

namespace tubeplan::planner {

namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

SegmentProof proofOf(const PlanContext& context, const PathSegment& segment) {
  const ArmClearance& clearance = context.clearance;
  MotionCheckOptions check = context.options.motion.check;
  check.accuracy = context.options.report_accuracy;
  const ContactRule rule = segment.kind == SegmentKind::kTravel ? ContactRule::kTravel : ContactRule::kApproach;
  const PostureClearance margin = sideBySide(clearance, rule, 0);
  SegmentProof proof{kUnbounded, {}};
  const std::vector<Eigen::VectorXd> corners = cornersOf(segment, context.speeds);
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    const MotionCheckResult result = checkMotion(corners[k], corners[k + 1], margin, clearance.travel(), check);
    const double proved = result.status == MotionCheckStatus::kFree ? result.proved_margin : -kUnbounded;
    if (proved < proof.margin) proof = {proved, result.tightest};
  }
  return proof;
}

/// Records the proofs in the plan; the proof of an approach also holds for its retreat. A retreat without a visit, from
/// the start posture, is proved separately.
void fillIn(const std::vector<MotionEnds>& ends, const PlanCache& cache, VisitPlan& plan) {
  plan.min_margin = kUnbounded;
  for (std::size_t k = 0; k < plan.segments.size(); ++k) {
    const SegmentProof& proof = cache.proofs.at(ends[k]);
    plan.segments[k].margin = proof.margin;
    plan.segments[k].tightest = proof.tightest;
    if (proof.margin >= plan.min_margin) continue;
    plan.min_margin = proof.margin;
    plan.tightest = proof.tightest;
  }
}

}  // namespace

bool proveAll(const PlanContext& context, const std::vector<MotionEnds>& ends, VisitPlan& plan) {
  auto& proofs = context.cache.proofs;
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < plan.segments.size(); ++k) {
    if (plan.segments[k].kind == SegmentKind::kRetreat && plan.segments[k].visit >= 0) continue;
    if (proofs.contains(ends[k]))
      ++plan.kept.proofs;
    else
      open.push_back(k);
  }
  std::mutex mutex;
  std::size_t done = 0;
  bool stopped = false;
  oneapi::tbb::parallel_for(std::size_t{0}, open.size(), [&](std::size_t k) {
    if (context.isStopped()) {
      const std::lock_guard lock(mutex);
      stopped = true;
      return;
    }
    const SegmentProof proof = proofOf(context, plan.segments[open[k]]);
    const std::lock_guard lock(mutex);
    proofs[ends[open[k]]] = proof;
    context.showProgress("proof", ++done, open.size());
    context.keepCache();
  });
  if (!stopped) fillIn(ends, context.cache, plan);
  return !stopped;
}

}  // namespace tubeplan::planner
