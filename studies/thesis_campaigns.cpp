// Study of the two campaigns that identified the Cobra's stiffnesses (Calkins 1994, section 5.3), repeated many times
// on a known arm. In the first campaign the arm is bolted to a rigid platform: 31 points are touched without load and
// under 20, 30 and 40 lbf, and eight stiffnesses are free. In the second it is mounted on its mezzanine: 14 points are
// touched and three stiffnesses are free, with the arm's stiffnesses as found in the first campaign. In every fit, each
// stiffness starts with an error of a factor of three. The output states how often the fit reaches the optimum found
// from the true values, how often the 95 % intervals contain the truth, and the touch error compared with the thesis.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <map>

#include "calibration/estimation/identification.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

constexpr double kStiffnessUnit = kInch * kPound / kDegree;
const double kInch4 = std::pow(kInch, 4);
const std::vector<double> kLoads{0, 20 * kPound, 30 * kPound, 40 * kPound};

struct StudyOptions {
  int seeds = 200;
  double sigma = 0.010;  // noise of each coordinate of a touch [in]
};

/// Number of touch points, free stiffnesses, and mean touch error of a campaign of Calkins 1994.
struct Campaign {
  const char* name;
  int points;
  std::vector<std::string> free;
  double printed_error;  // mean touch error stated by Calkins 1994 [in]
};

const Campaign kArmCampaign{
    "arm, bolted rigid",
    31,
    {"base-link.beam.Iy", "base-link.joint_stiffness.y", "latch-link.beam.Iz", "latch-link.joint_stiffness.z",
     "forearm.beam.Iz", "forearm.joint_stiffness.z", "tool.beam.Iz", "tool.joint_stiffness.z"},
    0.0245};
const Campaign kMezzanineCampaign{
    "mezzanine, arm as found",
    14,
    {"mezzanine-beam.joint_stiffness.z", "mezzanine-beam.beam.Iz", "mezzanine-platform.joint_stiffness.x"},
    0.0300};

/// Returns the arm with all stiffnesses that the thesis identified, at the values of its second table 5.4; values of
/// 1e9 and more mean rigid.
PlacedArm truth() {
  deflection::Arm arm = deflection::cobraArm();
  const double E = arm.rows[3].beam->E;
  for (const std::size_t row : {2U, 4U, 5U}) {
    arm.rows[row].beam.emplace();
    arm.rows[row].beam->E = E;
  }
  arm.rows[2].beam->I.y() = arm.rows[4].beam->I.z() = arm.rows[5].beam->I.z() = 1e9 * kInch4;
  arm.rows[2].joint_stiffness.y() = 37e15 * kStiffnessUnit;
  arm.rows[3].joint_stiffness.z() = 1e15 * kStiffnessUnit;
  return {arm, {{"", Eigen::Isometry3d::Identity(), true}}};
}

PlacedArm boltedRigid(PlacedArm placed) {
  placed.arm.rows.erase(placed.arm.rows.begin(), placed.arm.rows.begin() + 2);
  return placed;
}

double& numberOf(deflection::Arm& arm, const std::string& name) {
  return deflection::locate(arm, deflection::findParameter(arm, name)->path);
}

/// Returns the mean distance between the predicted tips of a loaded and the unloaded touch of the same point [in].
double meanTouchError(const PlacedArm& placed, const std::vector<Measurement>& measurements) {
  double sum = 0;
  int pairs = 0;
  Eigen::VectorXd bare;
  for (const auto& m : measurements) {
    const Eigen::VectorXd tip = predictMeasurement(placed.arm, placed.base_poses[0].X_WB, m).value;
    if (m.load == 0)
      bare = tip;
    else
      sum += (tip - bare).norm(), ++pairs;
  }
  return sum / pairs / kInch;
}

struct Tally {
  int runs = 0, same_optimum = 0, not_converged = 0;
  double error = 0, chi2 = 0, freedom = 0, evaluations = 0;
  struct Number {
    int identifiable = 0, covered = 0;
    double sigma = 0;
  };
  std::map<std::string, Number> numbers;
};

IdentificationOptions identificationOptions(const Campaign& campaign) {
  IdentificationOptions options;
  options.free.names = campaign.free;
  options.folds = 0;
  return options;
}

void count(const Identification& result, deflection::Arm& true_arm, Tally& tally) {
  for (const auto& number : result.numbers) {
    auto& entry = tally.numbers[number.unknown.name];
    if (number.identifiable != calibration::Identifiability::kYes) continue;
    const double value = numberOf(true_arm, number.unknown.name);
    ++entry.identifiable;
    entry.covered += number.lower <= value && value <= number.upper;
    entry.sigma += number.sigma / value;
  }
}

/// Runs one campaign and returns the fitted arm. The measurements are simulated with `truth`; the free stiffnesses
/// start a factor of three too high or too low, and all other parameters are those of `start`.
PlacedArm runCampaign(const Campaign& campaign, PlacedArm truth, PlacedArm start, const StudyOptions& options,
                      std::uint64_t seed, Tally& tally) {
  MeasurementMaker maker(truth, seed, MeasurementMaker::Noise::kStated, options.sigma * kInch);
  maker.addTouches(campaign.points, kLoads, false);
  for (const auto& name : campaign.free)
    numberOf(start.arm, name) = numberOf(truth.arm, name) * (maker.uniform(0, 1) < 0.5 ? 3 : 1 / 3.);
  const auto result = identify(start, maker.measurements, identificationOptions(campaign));
  auto from_truth = identificationOptions(campaign);
  from_truth.intervals_by_profile = false;
  PlacedArm near = start;
  for (const auto& name : campaign.free) numberOf(near.arm, name) = numberOf(truth.arm, name);
  const auto reference = identify(near, maker.measurements, from_truth);
  ++tally.runs;
  tally.not_converged += result.status != IdentificationStatus::kDone;
  if (result.status != IdentificationStatus::kDone) return start;
  tally.same_optimum += std::abs(result.chi2 - reference.chi2) < 1e-3 * reference.chi2;
  tally.error += meanTouchError(result.fitted, maker.measurements);
  tally.chi2 += result.chi2;
  tally.freedom += result.degrees_of_freedom;
  tally.evaluations += result.evaluations;
  count(result, truth.arm, tally);
  return result.fitted;
}

void print(const Campaign& campaign, const Tally& tally, const StudyOptions& options) {
  const double done = tally.runs - tally.not_converged;
  fmt::print("{}: {} runs, {} points, touches within {} in and 0.002 deg\n", campaign.name, tally.runs, campaign.points,
             options.sigma);
  fmt::print("  same optimum from every stiffness off by three: {} of {}; not converged: {}\n", tally.same_optimum,
             tally.runs, tally.not_converged);
  if (tally.error > 0)
    fmt::print(
        "  mean touch error {:.4f} in (the thesis: {:.4f}); chi-square {:.3f} per degree of freedom; {:.0f} "
        "evaluations a fit\n",
        tally.error / done, campaign.printed_error, tally.chi2 / tally.freedom, tally.evaluations / done);
  int identifiable = 0, covered = 0;
  for (const auto& [name, number] : tally.numbers) {
    fmt::print("  {:<38} identifiable {:>4} of {}", name, number.identifiable, tally.runs);
    if (number.identifiable)
      fmt::print("  covered {:5.1f} %  sigma {:.3g} of it", 100. * number.covered / number.identifiable,
                 number.sigma / number.identifiable);
    fmt::print("\n");
    identifiable += number.identifiable, covered += number.covered;
  }
  if (identifiable) fmt::print("  all intervals: {:.1f} % of {}\n", 100. * covered / identifiable, identifiable);
}

/// Returns the arm with two set-ups of known base pose; in the set-up `bench`, the rows of the mezzanine are rigid.
PlacedArm onBenchAndMezzanine(deflection::Arm arm) {
  arm.mountings = {{"bench", {0, 1}}};
  return {arm, {{"bench", Eigen::Isometry3d::Identity(), true}, {"mezzanine", Eigen::Isometry3d::Identity(), true}}};
}

/// Fits the measurements of both campaigns together, with all free stiffnesses in one fit.
void runTogether(const Campaign& both, const StudyOptions& options, std::uint64_t seed, Tally& tally) {
  PlacedArm bolted = onBenchAndMezzanine(truth().arm);
  for (const std::size_t row : {0U, 1U}) {
    bolted.arm.rows[row].joint_stiffness.setConstant(deflection::kRigid);
    bolted.arm.rows[row].beam.reset();
  }
  MeasurementMaker bench(bolted, seed, MeasurementMaker::Noise::kStated, options.sigma * kInch);
  bench.addTouches(kArmCampaign.points, kLoads, false, "bench");
  PlacedArm true_arm = onBenchAndMezzanine(truth().arm), start = true_arm;
  MeasurementMaker mezzanine(true_arm, seed + 100000, MeasurementMaker::Noise::kStated, options.sigma * kInch);
  mezzanine.addTouches(kMezzanineCampaign.points, kLoads, false, "mezzanine");
  std::vector<Measurement> measurements = bench.measurements;
  for (auto& measurement : mezzanine.measurements) {
    measurement.id = "m" + measurement.id;
    measurements.push_back(std::move(measurement));
  }
  for (const auto& name : both.free)
    numberOf(start.arm, name) = numberOf(true_arm.arm, name) * (bench.uniform(0, 1) < 0.5 ? 3 : 1 / 3.);
  const auto result = identify(start, measurements, identificationOptions(both));
  auto from_truth = identificationOptions(both);
  from_truth.intervals_by_profile = false;
  const auto reference = identify(true_arm, measurements, from_truth);
  ++tally.runs;
  tally.not_converged += result.status != IdentificationStatus::kDone;
  if (result.status != IdentificationStatus::kDone) return;
  tally.same_optimum += std::abs(result.chi2 - reference.chi2) < 1e-3 * reference.chi2;
  tally.chi2 += result.chi2;
  tally.freedom += result.degrees_of_freedom;
  tally.evaluations += result.evaluations;
  count(result, true_arm.arm, tally);
}

void run(const StudyOptions& options) {
  Tally arm, mezzanine, mezzanine_alone, together;
  Campaign both = kArmCampaign;
  both.name = "both campaigns in one fit";
  both.points += kMezzanineCampaign.points;
  both.free.insert(both.free.end(), kMezzanineCampaign.free.begin(), kMezzanineCampaign.free.end());
  Campaign alone = kMezzanineCampaign;
  alone.name = "mezzanine, arm known";
  for (int k = 1; k <= options.seeds; ++k) {
    const auto seed = static_cast<std::uint64_t>(k);
    const PlacedArm found = runCampaign(kArmCampaign, boltedRigid(truth()), boltedRigid(truth()), options, seed, arm);
    PlacedArm start = truth();
    for (const auto& name : kArmCampaign.free)
      numberOf(start.arm, name) = deflection::findParameter(found.arm, name)->value;
    (void)runCampaign(kMezzanineCampaign, truth(), start, options, seed + 100000, mezzanine);
    (void)runCampaign(alone, truth(), truth(), options, seed + 100000, mezzanine_alone);
    runTogether(both, options, seed, together);
  }
  print(kArmCampaign, arm, options);
  print(kMezzanineCampaign, mezzanine, options);
  print(alone, mezzanine_alone, options);
  print(both, together, options);
}

}  // namespace
}  // namespace tubeplan::calibration

int main(int argc, char** argv) {
  CLI::App cli{"The thesis's two stiffness campaigns on a known arm"};
  tubeplan::calibration::StudyOptions options;
  cli.add_option("--seeds", options.seeds, "campaigns of each kind");
  cli.add_option("--sigma", options.sigma, "noise of a touch's coordinate, in");
  CLI11_PARSE(cli, argc, argv);
  tubeplan::calibration::run(options);
  return 0;
}
