// Events sent to all browsers: changes of the state, progress of jobs, and the posture of a running arm. Each listener
// asks for events newer than those that it has seen, so that slow listeners do not delay others, and no events are
// queued.
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
  /// Numbers of the newest events that a listener has seen.
  struct Seen {
    std::uint64_t state = 0, jobs = 0, live = 0;
  };

  struct News {
    bool state_changed = false;
    std::vector<std::string> jobs;  ///< newest progress of each changed job, as JSON
    std::string live;               ///< newest posture of a running arm, as JSON; empty if there is no new one
    bool closed = false;
  };

  /// Accepts at most `most_listeners` listeners at a time.
  explicit Events(int most_listeners) : most_listeners_(most_listeners) {}

  /// Returns the number of the newest change. A state read after this call contains all changes up to that number. Of
  /// two answers received over different connections, the answer with the larger number is newer.
  [[nodiscard]] std::uint64_t moment() const { return moment_; }
  std::uint64_t nextMoment() { return ++moment_; }

  void stateChanged();
  void jobMoved(int id, std::string json);
  void liveMoved(std::string json);

  /// Wakes all listeners; wait() returns at once from now on.
  void close();

  /// Waits for new events, at most for the time `most`. Returns empty news on a timeout.
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
