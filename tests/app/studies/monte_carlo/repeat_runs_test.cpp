#include "app/studies/monte_carlo/repeat_runs.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <thread>

namespace tubeplan::app {
namespace {

/// Sums the squares of the run indices and counts how often each run was executed.
class SquareSum : public Experiment {
 public:
  explicit SquareSum(std::size_t runs) : times_(runs) {}
  std::optional<TallyWords> run(RunRange runs, const std::function<bool()>& stop) const override {
    std::uint64_t sum = 0;
    for (std::uint64_t run = runs.first; run < runs.end; ++run) {
      if (stop()) return std::nullopt;
      ++times_[run];
      sum += run * run;
    }
    return TallyWords{sum};
  }
  bool add(const TallyWords& tally) override {
    sum_ += tally.at(0);
    return true;
  }
  std::optional<TallyWords> sum(const TallyWords& a, const TallyWords& b) const override {
    return TallyWords{a.at(0) + b.at(0)};
  }
  TallyWords total() const override { return {sum_}; }
  int timesOf(std::size_t run) const { return times_[run]; }

 private:
  mutable std::vector<std::atomic<int>> times_;
  std::uint64_t sum_ = 0;
};

constexpr std::uint64_t kRuns = 1000, kSum = (kRuns - 1) * kRuns * (2 * kRuns - 1) / 6;

RepeatHooks quiet() {
  return {[](std::uint64_t) {}, [] { return false; }, [](bool) {}};
}

TEST(RunSet, KeepsRangesThatNeitherTouchNorOverlap) {
  RunSet set;
  set.insert({10, 20});
  set.insert({30, 40});
  set.insert({0, 5});
  EXPECT_EQ(set.ranges(), (std::vector<RunRange>{{0, 5}, {10, 20}, {30, 40}}));
  set.insert({20, 30});
  set.insert({5, 10});
  EXPECT_EQ(set.ranges(), (std::vector<RunRange>{{0, 40}}));
  EXPECT_EQ(set.size(), 40u);
}

TEST(RunSchedule, GivesWhatIsNotDoneOnce) {
  RunSet done;
  done.insert({7, 9});
  done.insert({20, 30});
  RunSchedule schedule(32, 4, done);
  std::vector<RunRange> given;
  while (const auto runs = schedule.next()) {
    given.push_back(*runs);
    EXPECT_FALSE(schedule.isComplete());
    schedule.finish(*runs);
  }
  EXPECT_EQ(given, (std::vector<RunRange>{{0, 4}, {4, 7}, {9, 13}, {13, 17}, {17, 20}, {30, 32}}));
  EXPECT_TRUE(schedule.isComplete());
}

TEST(RepeatRuns, RunsEachOnceForAnyNumberOfWorkers) {
  for (const int workers : {1, 2, 7}) {
    SquareSum experiment(kRuns);
    RunSchedule schedule(kRuns, 8);
    EXPECT_EQ(repeatRuns(experiment, schedule, workers, quiet(), nullptr), RepeatStatus::kDone);
    EXPECT_EQ(experiment.total(), TallyWords{kSum}) << workers;
    for (std::size_t run = 0; run < kRuns; ++run) EXPECT_EQ(experiment.timesOf(run), 1);
  }
}

TEST(RepeatRuns, StoppedItGoesOnToTheSameSum) {
  SquareSum experiment(kRuns);
  RunSchedule schedule(kRuns, 8);
  std::uint64_t kept = 0;
  RepeatHooks hooks = quiet();
  hooks.stop = [&] { return schedule.done().size() > 300; };
  hooks.keep = [&](bool must) { kept = must ? schedule.done().size() : kept; };
  EXPECT_EQ(repeatRuns(experiment, schedule, 2, hooks, nullptr), RepeatStatus::kStopped);
  EXPECT_GT(kept, 300u);
  EXPECT_LT(kept, kRuns);
  RunSchedule remaining(kRuns, 64, schedule.done());
  EXPECT_EQ(repeatRuns(experiment, remaining, 3, quiet(), nullptr), RepeatStatus::kDone);
  EXPECT_EQ(experiment.total(), TallyWords{kSum});
}

/// Throws std::bad_alloc for every range of runs that begins after run 500.
class FailingSum : public SquareSum {
 public:
  using SquareSum::SquareSum;
  std::optional<TallyWords> run(RunRange runs, const std::function<bool()>& stop) const override {
    if (runs.first > 500) throw std::bad_alloc();
    return SquareSum::run(runs, stop);
  }
};

TEST(RepeatRuns, ARunThatFailsEndsItAndDoesNotHang) {
  for (const int workers : {1, 3}) {
    FailingSum experiment(kRuns);
    RunSchedule schedule(kRuns, 8);
    EXPECT_THROW((void)repeatRuns(experiment, schedule, workers, quiet(), nullptr), std::bad_alloc);
  }
}

}  // namespace
}  // namespace tubeplan::app
