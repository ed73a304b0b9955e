// Work that is stopped at any stage must report that it was stopped, and return no results. If it is not stopped, hooks
// must not change its results.
#include <gtest/gtest.h>

#include <atomic>
#include <set>

#include "app/studies/measurements/discrimination_candidates.hpp"
#include "calibration/diagnosis/diagnosis.hpp"
#include "calibration/diagnosis/discrimination/discriminating_measurements.hpp"
#include "calibration/diagnosis/effect_warnings.hpp"
#include "calibration/patterns/comparison.hpp"
#include "tests/calibration/bench_measurements.hpp"

namespace tubeplan::calibration {
namespace {

/// Provides hooks that record the reported stages, count the calls of `stop`, and request a stop from call number
/// `stop_at` on (-1 means never).
class Watch {
 public:
  explicit Watch(int stop_at = -1) : stop_at_(stop_at) {}

  [[nodiscard]] WorkHooks hooks() {
    return {[this](std::string_view stage, std::size_t done, std::size_t total) {
              stages_.insert(std::string(stage));
              is_ordered_ = is_ordered_ && (total == 0 || done <= total);
            },
            [this] {
              const int calls = ++calls_;
              return stop_at_ >= 0 && calls >= stop_at_;
            }};
  }
  [[nodiscard]] int calls() const { return calls_; }
  [[nodiscard]] const std::set<std::string>& stages() const { return stages_; }
  [[nodiscard]] bool isOrdered() const { return is_ordered_; }

 private:
  int stop_at_;
  std::atomic<int> calls_ = 0;
  std::set<std::string> stages_;
  bool is_ordered_ = true;
};

/// Returns the numbers of the calls of `stop`, out of `all` calls, at which to request a stop: early, late and in
/// between.
std::vector<int> momentsOf(int all) { return {1, 2, all / 7, all / 3, all / 2, (9 * all) / 10, all}; }

// Largest number of calls of `stop` after a stop was requested, until all solvers have given up.
constexpr int kAsItEnds = 200;

class Stopping : public testing::Test {
 protected:
  const app::Cell cell = shippedBench();
  const std::vector<Measurement> measurements = benchMeasurements(cell, "hysteresis", "theta3", {0.0008}, 60, 5);
  const PlacedArm start = benchStart(cell, measurements);

  [[nodiscard]] IdentificationOptions identification(const WorkHooks& hooks) const {
    IdentificationOptions options;
    options.free = {cell.identify, false};
    options.hooks = hooks;
    return options;
  }
  [[nodiscard]] DiagnosisOptions diagnosis(const WorkHooks& hooks) const {
    DiagnosisOptions options;
    options.baseline.free = {cell.identify, false};
    options.hooks = hooks;
    return options;
  }
  [[nodiscard]] ComparisonOptions comparison(const WorkHooks& hooks) const {
    ComparisonOptions options;
    options.refit.free = {cell.identify, false};
    options.hooks = hooks;
    return options;
  }

  /// Runs the work to its end once, then again for several moments, and expects each of these runs to report that it
  /// was stopped.
  template <class Work, class IsStopped>
  void stopEverywhere(Work work, IsStopped isStopped) {
    Watch unstopped;
    EXPECT_FALSE(isStopped(work(unstopped.hooks())));
    EXPECT_GT(unstopped.calls(), 10);
    EXPECT_TRUE(unstopped.isOrdered());
    for (const int moment : momentsOf(unstopped.calls())) {
      Watch watch(moment);
      EXPECT_TRUE(isStopped(work(watch.hooks()))) << "at question " << moment << " of " << unstopped.calls();
      EXPECT_LT(watch.calls(), moment + kAsItEnds);
    }
  }
};

TEST_F(Stopping, IdentificationSaysThatItWasStopped) {
  stopEverywhere([&](const WorkHooks& hooks) { return identify(start, measurements, identification(hooks)); },
                 [](const Identification& result) {
                   if (result.status != IdentificationStatus::kStopped) return false;
                   EXPECT_TRUE(result.numbers.empty());
                   EXPECT_TRUE(result.fitted.arm.rows.empty());
                   EXPECT_FALSE(result.reason.empty());
                   return true;
                 });
}

/// Fixture with so many measurements that they are processed in blocks, with one call of `stop` per block. A stop
/// between two blocks leaves rows unfilled, from which no result may be computed.
class StoppingBetweenBlocks : public Stopping {
 protected:
  const std::vector<Measurement> many = benchMeasurements(cell, "hysteresis", "theta4", {0.001}, 1100, 6);
  const PlacedArm placed = benchStart(cell, many);

  /// Stops the work at each of the first `first` calls of `stop`, then at later calls spaced by the factor `growth`.
  template <class Work, class IsStopped>
  void stopAtAll(Work work, IsStopped isStopped, int first, double growth) {
    Watch unstopped;
    EXPECT_FALSE(isStopped(work(unstopped.hooks())));
    for (int moment = 1; moment <= unstopped.calls();
         moment = std::max(moment + 1, moment < first ? 0 : static_cast<int>(growth * moment))) {
      Watch watch(moment);
      EXPECT_TRUE(isStopped(work(watch.hooks()))) << "at question " << moment << " of " << unstopped.calls();
    }
  }
};

TEST_F(StoppingBetweenBlocks, IdentificationGivesNoFigure) {
  stopAtAll([&](const WorkHooks& hooks) { return identify(placed, many, identification(hooks)); },
            [](const Identification& result) { return result.status == IdentificationStatus::kStopped; }, 100, 1.1);
}

TEST_F(StoppingBetweenBlocks, DiagnosisGivesNoFigure) {
  stopAtAll([&](const WorkHooks& hooks) { return diagnose(placed, many, diagnosis(hooks)); },
            [](const Diagnosis& result) { return result.verdict == Verdict::kStopped; }, 5, 2);
}

TEST_F(StoppingBetweenBlocks, ComparisonGivesNoFigure) {
  stopAtAll([&](const WorkHooks& hooks) { return compare(placed, many, comparison(hooks)); },
            [](const Comparison& result) { return result.status == ComparisonStatus::kStopped; }, 5, 1.4);
}

TEST_F(Stopping, EverySolverStops) {
  for (const auto& kind : leastSquaresMethods()) {
    Watch watch(5);
    IdentificationOptions options = identification(watch.hooks());
    options.solver.method = kind.method;
    EXPECT_EQ(identify(start, measurements, options).status, IdentificationStatus::kStopped) << kind.name;
    EXPECT_LT(watch.calls(), 5 + kAsItEnds) << kind.name;
  }
}

TEST_F(Stopping, DiagnosisSaysThatItWasStopped) {
  stopEverywhere([&](const WorkHooks& hooks) { return diagnose(start, measurements, diagnosis(hooks)); },
                 [](const Diagnosis& result) {
                   if (result.verdict != Verdict::kStopped) return false;
                   EXPECT_TRUE(result.ranking.empty() && result.alternatives.empty() && result.closest.empty());
                   EXPECT_TRUE(result.baseline.numbers.empty());
                   return true;
                 });
}

TEST_F(Stopping, ComparisonSaysThatItWasStopped) {
  stopEverywhere([&](const WorkHooks& hooks) { return compare(start, measurements, comparison(hooks)); },
                 [](const Comparison& result) {
                   if (result.status != ComparisonStatus::kStopped) return false;
                   EXPECT_TRUE(result.measurements.empty() && result.patterns.tests.empty());
                   EXPECT_EQ(result.verdict, Adequacy::kNotRun);
                   return true;
                 });
}

TEST_F(Stopping, ProposalsSayThatTheyWereStopped) {
  Diagnosis open = diagnose(start, measurements, diagnosis({}));
  ASSERT_FALSE(open.closest.empty());
  open.verdict = Verdict::kInconclusive;  // otherwise there would be no explanations to discriminate between
  const auto candidates = app::discriminationCandidates(cell, open.baseline.fitted, measurements);
  stopEverywhere(
      [&](const WorkHooks& hooks) {
        DiscriminationOptions options;
        options.hooks = hooks;
        return proposeDiscriminatingMeasurements(open, measurements, candidates, options);
      },
      [](const DiscriminatingMeasurements& result) {
        if (result.status != DiscriminationStatus::kStopped) return false;
        EXPECT_TRUE(result.measurements.empty() && result.pairs.empty());
        return true;
      });
}

TEST_F(Stopping, ThereAreNoWarningsOfWorkThatWasStopped) {
  auto carrying = start;
  carrying.arm.effects.push_back(deflection::makeEffect(carrying.arm, "backlash", "tool.z").effect);
  IdentificationOptions options = identification({});
  options.free.names.emplace_back("backlash@tool.z.gap");
  const auto fit = identify(carrying, measurements, options);
  Watch unstopped;
  options.hooks = unstopped.hooks();
  EXPECT_FALSE(warnOfEffects(carrying, measurements, options, fit).empty());
  for (const int moment : momentsOf(unstopped.calls())) {
    Watch watch(moment);
    options.hooks = watch.hooks();
    EXPECT_TRUE(warnOfEffects(carrying, measurements, options, fit).empty()) << moment;
    EXPECT_LT(watch.calls(), moment + kAsItEnds);
  }
}

TEST_F(Stopping, HooksChangeNothing) {
  Watch watch;
  const Diagnosis with = diagnose(start, measurements, diagnosis(watch.hooks())),
                  without = diagnose(start, measurements, diagnosis({}));
  EXPECT_EQ(with.verdict, without.verdict);
  EXPECT_EQ(with.chi2, without.chi2);
  EXPECT_EQ(with.heldout_after.rms, without.heldout_after.rms);
  ASSERT_EQ(with.ranking.size(), without.ranking.size());
  for (std::size_t k = 0; k < with.ranking.size(); ++k) {
    EXPECT_EQ(with.ranking[k].at, without.ranking[k].at);
    EXPECT_EQ(with.ranking[k].size.value, without.ranking[k].size.value);
  }
  for (const char* stage : {"fit", "catalogue", "causes", "models", "readings kept out"})
    EXPECT_TRUE(watch.stages().contains(stage)) << stage;
  for (const auto& kind : leastSquaresMethods()) {
    IdentificationOptions watched = identification(watch.hooks()), alone = identification({});
    watched.solver.method = alone.solver.method = kind.method;
    watched.folds = alone.folds = 0;
    const auto a = identify(start, measurements, watched), b = identify(start, measurements, alone);
    ASSERT_EQ(a.numbers.size(), b.numbers.size()) << kind.name;
    for (std::size_t k = 0; k < a.numbers.size(); ++k) {
      EXPECT_EQ(a.numbers[k].value, b.numbers[k].value) << kind.name;
      EXPECT_EQ(a.numbers[k].lower, b.numbers[k].lower) << kind.name;
    }
  }
}

}  // namespace
}  // namespace tubeplan::calibration
