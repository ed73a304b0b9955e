// Long work, one job after another on a thread of its own, each with its progress, its end and a way to stop it.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "app/studies/job_steps.hpp"
#include "app/workbench/events.hpp"

namespace tubeplan::app {

/// What a job's work is given: where to report its progress, and whether it shall go on.
class JobContext {
 public:
  virtual ~JobContext() = default;
  virtual void progress(std::string_view stage, std::size_t done, std::size_t total) = 0;
  [[nodiscard]] virtual bool stopRequested() const = 0;
};

/// Throws JobStopped where that has been asked for; reports the stage that begins.
void beginStage(JobContext& context, std::string_view stage, std::size_t done = 0, std::size_t total = 0);

/// The work; returns the name of the result that it has put into the state. Throws InputError, JobStopped.
using JobWork = std::function<std::string(JobContext&)>;

class Jobs {
 public:
  explicit Jobs(Events& events);
  ~Jobs();  ///< asks the running job to stop and waits for it
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;

  struct Begun {
    std::string refused;  ///< why not; empty where it was taken
    nlohmann::json job;
  };

  /// Puts a job in the queue. Refused where one of that kind is waiting or running, or where too many wait.
  [[nodiscard]] Begun begin(const std::string& kind, const std::string& label, JobWork work);

  /// Asks a job to stop; nothing for an unknown one. A job that has ended stays as it is.
  [[nodiscard]] std::optional<nlohmann::json> cancel(int id);

  /// The last ones, newest last.
  [[nodiscard]] nlohmann::json list() const;

  /// Whether any job waits or runs.
  [[nodiscard]] bool isBusy() const;

 private:
  struct Job;
  class Context;

  void run();
  void work(Job& job);
  [[nodiscard]] nlohmann::json jsonOf(const Job& job) const;
  void end(Job& job, const std::string& status);

  Events& events_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::vector<std::shared_ptr<Job>> jobs_;  ///< ended ones first forgotten
  std::deque<std::shared_ptr<Job>> waiting_;
  int next_id_ = 1;
  bool closing_ = false;
  std::thread thread_;
};

}  // namespace tubeplan::app
