// Jobs run one after another, report progress, stop on request, and report their failure.
#include "app/workbench/jobs.hpp"

#include <gtest/gtest.h>

#include <future>

#include "app/storage/input_error.hpp"

namespace tubeplan::app {
namespace {

using namespace std::chrono_literals;

nlohmann::json ended(const Jobs& jobs, int id) {
  for (int k = 0; k < 2000; ++k) {
    for (const auto& job : jobs.list())
      if (job["id"] == id && job["status"] != "running") return job;
    std::this_thread::sleep_for(5ms);
  }
  ADD_FAILURE() << "job " << id << " does not end";
  return {};
}

TEST(Jobs, tellHowTheyEnd) {
  Events events(4);
  Jobs jobs(events);
  const auto done = jobs.begin("a", "", [](JobContext&) { return "result"; }).job["id"];
  const auto refused =
      jobs.begin("b", "", [](JobContext&) -> std::string { throw InputError("here", "this", "that", "do"); }).job["id"];
  const auto broken =
      jobs.begin("c", "", [](JobContext&) -> std::string { throw std::runtime_error("oops"); }).job["id"];
  const auto stopped = jobs.begin("d", "", [](JobContext&) -> std::string { throw JobStopped{}; }).job["id"];
  EXPECT_EQ(ended(jobs, done)["status"], "done");
  EXPECT_EQ(ended(jobs, done)["result"], "result");
  EXPECT_EQ(ended(jobs, refused)["status"], "failed");
  EXPECT_EQ(ended(jobs, refused)["error"]["where"], "here");
  EXPECT_EQ(ended(jobs, refused)["error"]["advice"], "do");
  EXPECT_EQ(ended(jobs, broken)["status"], "failed");
  EXPECT_EQ(ended(jobs, stopped)["status"], "cancelled");
}

TEST(Jobs, areNewerWithEveryChange) {
  Events events(4);
  Jobs jobs(events);
  std::promise<void> started, go;
  const auto begun = jobs.begin("long", "", [&](JobContext& context) {
    started.set_value();
    go.get_future().wait();
    beginStage(context, "last");
    return "result";
  });
  started.get_future().wait();
  const auto moment = [&] { return jobs.list().back()["moment"].get<std::uint64_t>(); };
  const std::uint64_t running = moment();
  EXPECT_GT(running, begun.job["moment"].get<std::uint64_t>());
  const std::uint64_t answer_moment = events.moment();  // the moment that an answer would contain now
  EXPECT_GE(answer_moment, running);
  const auto stopping = (*jobs.cancel(begun.job["id"]))["moment"].get<std::uint64_t>();
  EXPECT_GT(stopping, answer_moment);
  go.set_value();
  EXPECT_GT(ended(jobs, begun.job["id"])["moment"].get<std::uint64_t>(), stopping);
}

TEST(Jobs, areStoppedAtTheirNextStep) {
  Events events(4);
  Jobs jobs(events);
  std::promise<void> started;
  const auto job = jobs.begin("long", "", [&](JobContext& context) -> std::string {
    started.set_value();
    while (true) {
      beginStage(context, "step", 1, 2);
      std::this_thread::sleep_for(1ms);
    }
  });
  started.get_future().wait();
  EXPECT_EQ((*jobs.cancel(job.job["id"]))["stopping"], true);
  EXPECT_EQ(ended(jobs, job.job["id"])["status"], "cancelled");
  EXPECT_FALSE(jobs.cancel(999));
}

TEST(Jobs, aJobThatWaitsCanBeStoppedBeforeItBegins) {
  Events events(4);
  Jobs jobs(events);
  std::promise<void> go;
  auto gate = go.get_future().share();
  (void)jobs.begin("first", "", [gate](JobContext&) { return gate.wait(), ""; });
  bool ran = false;
  const auto second = jobs.begin("second", "", [&ran](JobContext&) { return ran = true, ""; });
  (void)jobs.cancel(second.job["id"]);
  go.set_value();
  EXPECT_EQ(ended(jobs, second.job["id"])["status"], "cancelled");
  EXPECT_FALSE(ran);
}

TEST(Jobs, oneOfAKindAndAFewInTheQueue) {
  Events events(4);
  Jobs jobs(events);
  std::promise<void> go;
  auto gate = go.get_future().share();
  const auto wait = [gate](JobContext&) { return gate.wait(), ""; };
  EXPECT_EQ(jobs.begin("a", "", wait).refused, "");
  EXPECT_NE(jobs.begin("a", "", wait).refused, "");
  int taken = 0;
  for (int k = 0; k < 50; ++k) taken += jobs.begin("kind " + std::to_string(k), "", wait).refused.empty();
  EXPECT_GE(taken, 3);
  EXPECT_LE(taken, 6);
  EXPECT_TRUE(jobs.isBusy());
  go.set_value();
}

TEST(Jobs, tellHowFarTheyAre) {
  Events events(4);
  Jobs jobs(events);
  Events::Seen seen;
  (void)events.wait(seen, 0ms);
  const auto job = jobs.begin("counted", "", [](JobContext& context) {
    for (std::size_t k = 0; k <= 40; ++k) {
      context.progress("counting", k, 40);
      std::this_thread::sleep_for(10ms);
    }
    return "";
  });
  const auto began = std::chrono::steady_clock::now();
  int reported = 0;
  bool with_rate = false;
  while (true) {
    const auto news = events.wait(seen, 1000ms);
    reported += static_cast<int>(news.jobs.size());
    if (news.jobs.empty()) continue;
    const auto last = nlohmann::json::parse(news.jobs.back());
    with_rate |= last["stage"] == "counting" && last["rate"].is_number() && last["left_s"].is_number();
    if (last["status"] == "done") break;
  }
  EXPECT_TRUE(with_rate);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  EXPECT_LE(reported, 10 * seconds + 4);  // ten reports a second, plus the first and the last
}

TEST(Jobs, areForgottenInTime) {
  Events events(4);
  Jobs jobs(events);
  for (int k = 0; k < 60; ++k) {
    const auto job = jobs.begin("a", "", [](JobContext&) { return ""; });
    (void)ended(jobs, job.job["id"]);
  }
  EXPECT_LE(jobs.list().size(), 12u);
}

TEST(Events, aSlowListenerGetsTheNewestOnly) {
  Events events(2);
  Events::Seen seen;
  EXPECT_TRUE(events.wait(seen, 0ms).state_changed);
  EXPECT_FALSE(events.wait(seen, 0ms).state_changed);
  for (int k = 0; k < 1000; ++k) events.jobMoved(7, std::to_string(k));
  for (int k = 0; k < 1000; ++k) events.stateChanged();
  const auto news = events.wait(seen, 0ms);
  EXPECT_TRUE(news.state_changed);
  EXPECT_EQ(news.jobs, std::vector<std::string>{"999"});
}

TEST(Events, areBounded) {
  Events events(2);
  EXPECT_TRUE(events.tryEnter());
  EXPECT_TRUE(events.tryEnter());
  EXPECT_FALSE(events.tryEnter());
  events.leave();
  EXPECT_TRUE(events.tryEnter());
  events.close();
  Events::Seen seen;
  EXPECT_TRUE(events.wait(seen, 10000ms).closed);
}

}  // namespace
}  // namespace tubeplan::app
