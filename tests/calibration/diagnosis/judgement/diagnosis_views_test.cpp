#include "calibration/diagnosis/judgement/diagnosis_views.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "calibration/diagnosis/diagnosis.hpp"
#include "calibration/diagnosis/explanations/explanation_model.hpp"
#include "tests/calibration/bench_measurements.hpp"

namespace tubeplan::calibration {
namespace {

constexpr int kMeasurements = 45;

/// Cell, measurements and their diagnosis, computed once for all tests.
struct Diagnosed {
  app::Cell cell = shippedBench();
  std::vector<Measurement> measurements;
  Diagnosis result;
};

Diagnosed diagnosed(const std::string& effect, const std::vector<double>& values) {
  Diagnosed all;
  all.measurements = benchMeasurements(all.cell, effect, "theta4", values, kMeasurements, 11);
  all.measurements[4].is_held_out = true;
  DiagnosisOptions options;
  options.baseline.free = {all.cell.identify, !all.cell.base_known};
  options.most_causes = 1;
  all.result = diagnose(benchStart(all.cell, all.measurements), all.measurements, options);
  return all;
}

const Diagnosed& hysteresis() {
  static const Diagnosed all = diagnosed("hysteresis", {0.1 * kDegree});
  return all;
}

double rootMeanSquare(const std::vector<MeasurementView>& views, int explanation) {
  double sum = 0;
  for (const auto& view : views)
    sum += (explanation < 0 ? view.before : view.after.at(static_cast<std::size_t>(explanation))).squaredNorm();
  return std::sqrt(sum / static_cast<double>(views.size()));
}

TEST(DiagnosisViews, errorsAreThoseThatTheDiagnosisReports) {
  const auto& all = hysteresis();
  ASSERT_EQ(all.result.verdict, Verdict::kExplained) << all.result.reason;
  const auto& views = all.result.views;
  EXPECT_NEAR(rootMeanSquare(views.measurements, -1), all.result.before.rms, 1e-9 * all.result.before.rms);
  EXPECT_NEAR(rootMeanSquare(views.measurements, 0), all.result.after.rms, 1e-9 * all.result.after.rms);
}

TEST(DiagnosisViews, holdsEveryFittedMeasurementOnceAndNoOther) {
  const auto& all = hysteresis();
  std::set<int> shown;
  for (const auto& view : all.result.views.measurements)
    EXPECT_TRUE(shown.insert(view.measurement).second) << view.measurement;
  EXPECT_EQ(shown.size() + all.result.set_aside.size() + 1, static_cast<std::size_t>(kMeasurements));
  EXPECT_EQ(shown.count(4), 0U);
  for (const int measurement : all.result.set_aside) EXPECT_EQ(shown.count(measurement), 0U) << measurement;
}

TEST(DiagnosisViews, errorIsMeasuredLessPredicted) {
  const auto& all = hysteresis();
  for (const auto& view : all.result.views.measurements) {
    const auto& measured = *all.measurements[static_cast<std::size_t>(view.measurement)].p_W;
    EXPECT_LT((view.p_WT + view.before - measured).norm(), 1e-9) << view.measurement;
  }
}

TEST(DiagnosisViews, anEffectThatIsThereHasSlopeOneAtItsSize) {
  const auto& all = hysteresis();
  ASSERT_EQ(all.result.views.added.size(), 1U);
  const auto& added = all.result.views.added.front();
  EXPECT_NEAR(added.slope, 1, 0.02);  // the refit of the other parameters changes the signature slightly
  EXPECT_GT(added.kept_fraction, 0.3);
  EXPECT_LE(added.kept_fraction, 1 + 1e-12);
  double squares = 0, product = 0;
  for (const auto& point : added.points) {
    squares += point.signature * point.signature;
    product += point.signature * point.residual;
  }
  EXPECT_NEAR(std::sqrt(squares), added.length, 1e-9 * added.length);
  EXPECT_NEAR(product / squares, added.slope, 1e-9);
  // The squared length explained by the plot's line must equal the decrease of chi-square due to the effect.
  const double fall = all.result.chi2 - all.result.alternatives.front().chi2;
  EXPECT_NEAR(added.slope * added.slope * squares, fall, 0.03 * fall);
}

TEST(DiagnosisViews, fewerPointsAreWholeMeasurementsSpreadEvenly) {
  const auto& all = hysteresis();
  std::vector<Measurement> used;
  for (const auto& view : all.result.views.measurements)
    used.push_back(all.measurements[static_cast<std::size_t>(view.measurement)]);
  const auto basis = basisOf(all.result.baseline, used);
  const auto views = viewsOf(basis, all.result, all.measurements, 60);
  const auto& points = views.added.at(0).points;
  EXPECT_LE(points.size(), 66U);
  EXPECT_GE(points.size(), 48U);
  ASSERT_EQ(points.size() % 3, 0U);
  int first_half = 0;
  for (std::size_t k = 0; k < points.size(); k += 3) {
    EXPECT_EQ(points[k].measurement, points[k + 2].measurement);
    first_half += points[k].measurement < kMeasurements / 2;
  }
  EXPECT_NEAR(first_half, static_cast<double>(points.size()) / 6, 2);
  EXPECT_EQ(views.measurements.size(), used.size());
}

TEST(DiagnosisViews, withNothingMissingThereIsNothingBesideTheErrors) {
  const auto all = diagnosed("", {});
  ASSERT_EQ(all.result.verdict, Verdict::kAdequate);
  EXPECT_TRUE(explanationsShown(all.result).empty());
  EXPECT_TRUE(all.result.views.added.empty());
  for (const auto& view : all.result.views.measurements) EXPECT_TRUE(view.after.empty());
  EXPECT_NEAR(rootMeanSquare(all.result.views.measurements, -1), all.result.before.rms, 1e-9 * all.result.before.rms);
}

}  // namespace
}  // namespace tubeplan::calibration
