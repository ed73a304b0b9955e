#include "app/workbench/open_connections.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>

namespace tubeplan::app {
namespace {

/// The thread sanitizer sees whether a task's thread still touches what it has counted itself out of.
TEST(TaskThreads, MayGoAsSoonAsTheirTasksHaveEnded) {
  for (int round = 0; round < 500; ++round) {
    std::atomic<int> ended = 0;
    auto threads = std::make_unique<TaskThreads>();
    for (int k = 0; k < 3; ++k) threads->enqueue([&ended] { ++ended; });
    threads->shutdown();
    EXPECT_EQ(ended, 3);
    threads.reset();
  }
}

}  // namespace
}  // namespace tubeplan::app
