#include "calibration/diagnosis/judgement/diagnosis_views.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "calibration/diagnosis/diagnosis.hpp"
#include "calibration/diagnosis/explanations/explanation_model.hpp"
#include "tests/calibration/bench_readings.hpp"

namespace tubeplan::calibration {
namespace {

constexpr int kReadings = 45;

/// Cell, readings and their diagnosis, computed once for all tests.
struct Diagnosed {
  app::Cell cell = shippedBench();
  std::vector<Measurement> readings;
  Diagnosis result;
};

Diagnosed diagnosed(const std::string& effect, const std::vector<double>& values) {
  Diagnosed all;
  all.readings = benchReadings(all.cell, effect, "theta4", values, kReadings, 11);
  all.readings[4].is_held_out = true;
  DiagnosisOptions options;
  options.baseline.free = {all.cell.identify, !all.cell.base_known};
  options.most_causes = 1;
  all.result = diagnose(benchStart(all.cell, all.readings), all.readings, options);
  return all;
}

const Diagnosed& hysteresis() {
  static const Diagnosed all = diagnosed("hysteresis", {0.1 * kDegree});
  return all;
}

double rootMeanSquare(const std::vector<ReadingView>& views, int explanation) {
  double sum = 0;
  for (const auto& view : views)
    sum += (explanation < 0 ? view.before : view.after.at(static_cast<std::size_t>(explanation))).squaredNorm();
  return std::sqrt(sum / static_cast<double>(views.size()));
}

TEST(DiagnosisViews, errorsAreThoseThatTheDiagnosisReports) {
  const auto& all = hysteresis();
  ASSERT_EQ(all.result.verdict, Verdict::kExplained) << all.result.reason;
  const auto& views = all.result.views;
  EXPECT_NEAR(rootMeanSquare(views.readings, -1), all.result.before.rms, 1e-9 * all.result.before.rms);
  EXPECT_NEAR(rootMeanSquare(views.readings, 0), all.result.after.rms, 1e-9 * all.result.after.rms);
}

TEST(DiagnosisViews, holdsEveryFittedReadingOnceAndNoOther) {
  const auto& all = hysteresis();
  std::set<int> shown;
  for (const auto& view : all.result.views.readings) EXPECT_TRUE(shown.insert(view.reading).second) << view.reading;
  EXPECT_EQ(shown.size() + all.result.set_aside.size() + 1, static_cast<std::size_t>(kReadings));
  EXPECT_EQ(shown.count(4), 0U);
  for (const int reading : all.result.set_aside) EXPECT_EQ(shown.count(reading), 0U) << reading;
}

TEST(DiagnosisViews, errorIsMeasuredLessPredicted) {
  const auto& all = hysteresis();
  for (const auto& view : all.result.views.readings) {
    const auto& measured = *all.readings[static_cast<std::size_t>(view.reading)].p_W;
    EXPECT_LT((view.p_WT + view.before - measured).norm(), 1e-9) << view.reading;
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
    product += point.signature * point.left;
  }
  EXPECT_NEAR(std::sqrt(squares), added.length, 1e-9 * added.length);
  EXPECT_NEAR(product / squares, added.slope, 1e-9);
  // The squared length explained by the plot's line must equal the decrease of chi-square due to the effect.
  const double fall = all.result.chi2 - all.result.alternatives.front().chi2;
  EXPECT_NEAR(added.slope * added.slope * squares, fall, 0.03 * fall);
}

TEST(DiagnosisViews, fewerPointsAreWholeReadingsSpreadEvenly) {
  const auto& all = hysteresis();
  std::vector<Measurement> used;
  for (const auto& view : all.result.views.readings)
    used.push_back(all.readings[static_cast<std::size_t>(view.reading)]);
  const auto basis = basisOf(all.result.baseline, used);
  const auto views = viewsOf(basis, all.result, all.readings, 60);
  const auto& points = views.added.at(0).points;
  EXPECT_LE(points.size(), 66U);
  EXPECT_GE(points.size(), 48U);
  ASSERT_EQ(points.size() % 3, 0U);
  int first_half = 0;
  for (std::size_t k = 0; k < points.size(); k += 3) {
    EXPECT_EQ(points[k].reading, points[k + 2].reading);
    first_half += points[k].reading < kReadings / 2;
  }
  EXPECT_NEAR(first_half, static_cast<double>(points.size()) / 6, 2);
  EXPECT_EQ(views.readings.size(), used.size());
}

TEST(DiagnosisViews, withNothingMissingThereIsNothingBesideTheErrors) {
  const auto all = diagnosed("", {});
  ASSERT_EQ(all.result.verdict, Verdict::kAdequate);
  EXPECT_TRUE(explanationsShown(all.result).empty());
  EXPECT_TRUE(all.result.views.added.empty());
  for (const auto& view : all.result.views.readings) EXPECT_TRUE(view.after.empty());
  EXPECT_NEAR(rootMeanSquare(all.result.views.readings, -1), all.result.before.rms, 1e-9 * all.result.before.rms);
}

}  // namespace
}  // namespace tubeplan::calibration
