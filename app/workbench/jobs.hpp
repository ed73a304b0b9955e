// Queue of long computations, run one after another on a separate thread, each with progress, a result and
// cancellation.
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

/// Interface through which the work of a job reports progress and checks for stop requests.
class JobContext {
 public:
  virtual ~JobContext() = default;
  virtual void progress(std::string_view stage, std::size_t done, std::size_t total) = 0;
  [[nodiscard]] virtual bool stopRequested() const = 0;
};

/// Reports the beginning of a stage. Throws JobStopped if the job was cancelled.
void beginStage(JobContext& context, std::string_view stage, std::size_t done = 0, std::size_t total = 0);

/// Work of a job. Returns the name of the result that it stored in the session. May throw InputError and JobStopped.
using JobWork = std::function<std::string(JobContext&)>;

class Jobs {
 public:
  explicit Jobs(Events& events);
  ~Jobs();  ///< Requests the running job to stop and waits for it.
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;

  struct Begun {
    std::string refused;  ///< reason for the refusal; empty if the job was accepted
    nlohmann::json job;
  };

  /// Adds a job to the queue. Refuses the job if another job of this kind is waiting or running, or if too many jobs
  /// wait.
  [[nodiscard]] Begun begin(const std::string& kind, const std::string& label, JobWork work);

  /// Asks a job to stop. Returns the job, or nullopt for an unknown id. A finished job keeps its status.
  [[nodiscard]] std::optional<nlohmann::json> cancel(int id);

  /// Returns the most recent jobs, newest last.
  [[nodiscard]] nlohmann::json list() const;

  /// Returns true if any job waits or runs.
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
  std::vector<std::shared_ptr<Job>> jobs_;  ///< the oldest finished jobs are dropped first
  std::deque<std::shared_ptr<Job>> waiting_;
  int next_id_ = 1;
  bool closing_ = false;
  std::thread thread_;
};

}  // namespace tubeplan::app
