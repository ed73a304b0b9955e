#include "calibration/simulation/simulated_campaign.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/simulation/campaign_station.hpp"
#include "calibration/statistics.hpp"
#include "deflection/effects/effect_context.hpp"
#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::calibration {

namespace {

using RefusalCounts = std::array<int, kPostureRefusals>;

constexpr int kHeightDraws = 101;
constexpr int kFreshDraws = 200;  // number of failed draws after which hardly any hole in reach is left

std::vector<CampaignSite> sitesOf(const CampaignTruth& truth) {
  std::vector<CampaignSite> sites;
  for (const auto& base : truth.bases)
    sites.push_back(
        {static_cast<int>(sites.size()), base.setup, base.X_WB, deflection::gravityInBase(truth.arm, base.X_WB)});
  return sites;
}

/// Returns a string such as "2000 postures were drawn: 1400 in collision with the scene, 600 past a joint limit".
std::string explain(const RefusalCounts& counts) {
  int drawn = 0;
  std::string text;
  for (int k = 1; k < kPostureRefusals; ++k) {
    if (counts[k] == 0) continue;
    drawn += counts[k];
    text += (text.empty() ? "" : ", ") + std::to_string(counts[k]) + " " + describe(static_cast<PostureRefusal>(k));
  }
  return std::to_string(drawn) + " postures were drawn: " + text;
}

std::string findCampaignProblem(const CampaignTruth& truth, const CampaignDesign& design,
                                const CampaignOptions& options) {
  if (design.place == CampaignPlace::kHoles && options.holes.empty())
    return "the design is at holes, but there are none";
  if (static_cast<int>(truth.bases.size()) != design.setups)
    return std::to_string(truth.bases.size()) + " bases for " + std::to_string(design.setups) + " set-ups";
  return findDesignProblem(design, options.measurements);
}

class CampaignMaker {
 public:
  CampaignMaker(const CampaignTruth& truth, const CampaignDesign& design, const CampaignOptions& options,
                const CampaignHooks& hooks)
      : arm_(truth.arm),
        design_(design),
        options_(options),
        hooks_(hooks),
        sites_(sitesOf(truth)),
        series_(truth.arm, options.pace, options.measurements, design, options.seed),
        station_(truth.arm, design, options) {}

  SimulatedCampaign make() {
    const int points = pointsOf(design_, options_.measurements);
    bool continues = design_.place != CampaignPlace::kPlane || findPlane();
    for (int point = 0; continues && point < points; ++point) {
      const auto site = static_cast<std::size_t>(point) * sites_.size() / static_cast<std::size_t>(points);
      continues = addPoint(sites_[site], point + 1, point + 1 == points);
    }
    if (!continues) return std::move(result_);
    relate();
    holdOut();
    result_.status = CampaignStatus::kDone;
    return std::move(result_);
  }

 private:
  bool wantsStop() {
    if (!hooks_.stop || !hooks_.stop()) return false;
    result_.status = CampaignStatus::kStopped;
    result_.reason = "stopped after " + std::to_string(result_.measurements.size()) + " readings";
    return true;
  }

  bool failFor(const std::string& what, const RefusalCounts& counts) {
    result_.status = CampaignStatus::kOutOfReach;
    result_.reason = "no posture for " + what + ": " + explain(counts);
    return false;
  }

  /// Sets the height of the plane of touched points to the median tip height over random postures.
  bool findPlane() {
    RefusalCounts counts{};
    std::vector<double> heights;
    for (int draws = 0; draws < options_.max_draws && heights.size() < kHeightDraws; ++draws) {
      if (wantsStop()) return false;
      const TipTrial trial = station_.tryRandomPosture(sites_.front());
      ++counts[static_cast<std::size_t>(trial.refusal)];
      if (trial.refusal == PostureRefusal::kNone) heights.push_back(-arm_.gravity_W.dot(trial.tool.p_W));
    }
    if (heights.empty()) return failFor("the height of the plane", counts);
    station_.setPlaneHeight(median(std::move(heights)));
    return true;
  }

  /// Adds all measurements of one point, or of one posture.
  bool addPoint(const CampaignSite& site, int number, bool is_last) {
    const auto each = static_cast<std::size_t>(measurementsPerPosture(design_) * design_.postures_per_point);
    const std::size_t remaining = static_cast<std::size_t>(options_.measurements) - result_.measurements.size();
    std::vector<MeasurementConditions> conditions;
    while (conditions.size() < (is_last ? remaining : std::min(each, remaining))) conditions.push_back(series_.next());
    RefusalCounts counts{};
    for (int draws = 0; draws < options_.max_draws; ++draws) {
      if (wantsStop()) return false;
      if (draws == kFreshDraws) station_.renewHoles();
      StationMeasurements taken = station_.read(site, number, conditions);
      ++counts[static_cast<std::size_t>(taken.refusal)];
      if (taken.refusal != PostureRefusal::kNone) continue;
      keep(std::move(taken));
      return true;
    }
    return failFor("reading " + std::to_string(result_.measurements.size() + 1), counts);
  }

  void keep(StationMeasurements taken) {
    const bool is_new = names_.insert(taken.name).second;
    if (taken.p_W && is_new) result_.points.push_back({taken.name, *taken.p_W});
    tips_W_.insert(tips_W_.end(), taken.tips_W.begin(), taken.tips_W.end());
    for (auto& measurement : taken.measurements) {
      measurement.id = std::to_string(result_.measurements.size() + 1);
      result_.measurements.push_back(std::move(measurement));
    }
    if (hooks_.progress) hooks_.progress(result_.measurements.size(), static_cast<std::size_t>(options_.measurements));
  }

  /// Converts measurements into displacements from the preceding measurement of the same set-up. The first measurement
  /// of a set-up is converted to a displacement from the last one.
  void relate() {
    auto& measurements = result_.measurements;
    if (!kindOf(design_.kind).is_from_measurement) return;
    const double scale = deflection::measurementScale(arm_);
    for (std::size_t first = 0, end = 0; first < measurements.size(); first = end) {
      while (end < measurements.size() && measurements[end].setup == measurements[first].setup) ++end;
      for (std::size_t k = first; k < end; ++k) {
        const std::size_t from = k > first ? k - 1 : end - 1;
        *measurements[k].p_W -= scale * tips_W_[from];
        measurements[k].reference = std::make_shared<Measurement>(measurements[from]);
      }
    }
    linkReferences(measurements);
  }

  /// Holds out whole points or postures, because measurements of the same point or posture are not independent tests of
  /// each other.
  void holdOut() {
    if (design_.held_out == 0 || names_.size() < 2) return;
    std::vector<std::string> names(names_.begin(), names_.end());
    CampaignRandom random(options_.seed, CampaignRandom::Stream::kSplit);
    random.shuffle(names);
    const auto wanted = static_cast<std::size_t>(std::lround(design_.held_out * static_cast<double>(names.size())));
    names.resize(std::clamp<std::size_t>(wanted, 1, names.size() - 1));
    const std::set<std::string> kept(names.begin(), names.end());
    for (auto& measurement : result_.measurements) measurement.is_held_out = kept.contains(measurement.point);
  }

  const deflection::Arm& arm_;
  const CampaignDesign& design_;
  const CampaignOptions& options_;
  const CampaignHooks& hooks_;
  std::vector<CampaignSite> sites_;
  ConditionSeries series_;
  CampaignStation station_;
  std::vector<Eigen::Vector3d> tips_W_;  ///< tip positions of the measurements, without noise [m]
  std::set<std::string> names_;          ///< names of the points and postures
  SimulatedCampaign result_;
};

}  // namespace

SimulatedCampaign simulateCampaign(const CampaignTruth& truth, const CampaignDesign& design,
                                   const CampaignOptions& options, const CampaignHooks& hooks) {
  SimulatedCampaign refused;
  refused.reason = findCampaignProblem(truth, design, options);
  refused.status = CampaignStatus::kRefused;
  if (!refused.reason.empty()) return refused;
  return CampaignMaker(truth, design, options, hooks).make();
}

}  // namespace tubeplan::calibration
