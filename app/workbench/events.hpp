// What is sent to all browsers: that the state has changed, how far the jobs are, and where a running arm is. Each
// listener asks for what is newer than what it has seen, so that a slow one holds up nobody and nothing is kept for it.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace tubeplan::app {

class Events {
 public:
  /// How much a listener has seen.
  struct Seen {
    std::uint64_t state = 0, jobs = 0, live = 0;
  };

  struct News {
    bool state_changed = false;
    std::vector<std::string> jobs;  ///< the newest of each job that has moved, as JSON
    std::string live;               ///< the newest from a running arm, as JSON; empty: nothing new
    bool closed = false;
  };

  /// At most that many listeners at a time.
  explicit Events(int most_listeners) : most_listeners_(most_listeners) {}

  /// The number of the newest change. What was made of the state after asking for it has all changes up to it: of two
  /// answers that come by two connections, the one with the greater number is the newer.
  [[nodiscard]] std::uint64_t moment() const { return moment_; }
  std::uint64_t nextMoment() { return ++moment_; }

  void stateChanged();
  void jobMoved(int id, std::string json);
  void liveMoved(std::string json);

  /// Wakes every listener for good.
  void close();

  /// Waits until there is news, at most that long; nothing after it is a heartbeat's moment.
  [[nodiscard]] News wait(Seen& seen, std::chrono::milliseconds most);

  [[nodiscard]] bool tryEnter();
  void leave();

 private:
  struct JobNews {
    std::uint64_t number = 0;
    std::string json;
  };

  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<std::uint64_t> moment_ = 1;
  std::uint64_t state_ = 1, job_number_ = 0, live_number_ = 0;
  std::string live_;
  std::map<int, JobNews> jobs_;
  bool closed_ = false;
  int listeners_ = 0, most_listeners_;
};

}  // namespace tubeplan::app
