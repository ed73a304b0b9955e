#include "app/workbench/jobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/storage/input_error.hpp"
#include "app/workbench/exchange.hpp"

namespace tubeplan::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostWaiting = 4;
constexpr std::size_t kJobsKept = 12;
constexpr std::size_t kLongestLabel = 200;
constexpr auto kBetweenNews = std::chrono::milliseconds(100);

}  // namespace

struct Jobs::Job {
  int id = 0;
  std::string kind, label, status = "running", stage = "waiting", result;
  std::size_t done = 0, total = 0;
  std::uint64_t moment = 0;  ///< number of the job's newest change, see Events::moment()
  Clock::time_point stage_began = Clock::now(), reported;
  nlohmann::json error;
  JobWork work;
  std::atomic<bool> stop = false;
};

/// Context passed to the work of a job on the job thread.
class Jobs::Context : public JobContext {
 public:
  Context(Jobs& jobs, Job& job) : jobs_(jobs), job_(job) {}

  void progress(std::string_view stage, std::size_t done, std::size_t total) override {
    const std::lock_guard lock(jobs_.mutex_);
    const auto now = Clock::now();
    const bool is_new = job_.stage != stage;
    if (is_new) job_.stage_began = now;
    job_.stage = stage;
    job_.done = done;
    job_.total = total;
    job_.moment = jobs_.events_.nextMoment();
    const bool is_last = total > 0 && done >= total;
    if (!is_new && !is_last && now - job_.reported < kBetweenNews) return;
    job_.reported = now;
    jobs_.events_.jobMoved(job_.id, jobs_.jsonOf(job_).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  }
  bool stopRequested() const override { return job_.stop; }

 private:
  Jobs& jobs_;
  Job& job_;
};

void beginStage(JobContext& context, std::string_view stage, std::size_t done, std::size_t total) {
  if (context.stopRequested()) throw JobStopped{};
  context.progress(stage, done, total);
}

Jobs::Jobs(Events& events) : events_(events), thread_([this] { run(); }) {}

Jobs::~Jobs() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
    for (const auto& job : jobs_) job->stop = true;
  }
  wake_.notify_all();
  thread_.join();
}

Jobs::Begun Jobs::begin(const std::string& kind, const std::string& label, JobWork work) {
  const std::lock_guard lock(mutex_);
  const auto is_same = [&](const auto& job) { return job->kind == kind && job->status == "running"; };
  if (std::any_of(jobs_.begin(), jobs_.end(), is_same)) return {"the job '" + kind + "' is still running", {}};
  if (waiting_.size() >= kMostWaiting)
    return {fmt::format("{} jobs are waiting already, and no more can wait", waiting_.size()), {}};
  auto job = std::make_shared<Job>();
  job->id = next_id_++;
  job->kind = kind;
  job->label = label.substr(0, kLongestLabel);
  job->work = std::move(work);
  job->moment = events_.nextMoment();
  jobs_.push_back(job);
  waiting_.push_back(job);
  for (auto old = jobs_.begin(); jobs_.size() > kJobsKept && old != jobs_.end();)
    old = (*old)->status == "running" ? old + 1 : jobs_.erase(old);
  wake_.notify_all();
  return {"", jsonOf(*job)};
}

std::optional<nlohmann::json> Jobs::cancel(int id) {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(jobs_.begin(), jobs_.end(), [&](const auto& job) { return job->id == id; });
  if (found == jobs_.end()) return std::nullopt;
  (*found)->stop = true;
  (*found)->moment = events_.nextMoment();
  return jsonOf(**found);
}

nlohmann::json Jobs::list() const {
  const std::lock_guard lock(mutex_);
  nlohmann::json list = nlohmann::json::array();
  for (const auto& job : jobs_) list.push_back(jsonOf(*job));
  return list;
}

bool Jobs::isBusy() const {
  const std::lock_guard lock(mutex_);
  return std::any_of(jobs_.begin(), jobs_.end(), [](const auto& job) { return job->status == "running"; });
}

nlohmann::json Jobs::jsonOf(const Job& job) const {
  const double seconds = std::chrono::duration<double>(Clock::now() - job.stage_began).count();
  const double rate = job.done > 0 && seconds > 0 ? static_cast<double>(job.done) / seconds : 0;
  const bool is_running = job.status == "running";
  nlohmann::json remaining_time;
  if (is_running && rate > 0) remaining_time = static_cast<double>(job.total - std::min(job.done, job.total)) / rate;
  return {{"id", job.id},
          {"kind", job.kind},
          {"label", job.label},
          {"status", job.status},
          {"stage", job.stage},
          {"done", job.done},
          {"total", job.total},
          {"rate", is_running && rate > 0 ? nlohmann::json(rate) : nlohmann::json()},
          {"left_s", remaining_time},
          {"stopping", is_running && job.stop},
          {"error", job.error},
          {"result", job.result.empty() ? nlohmann::json() : nlohmann::json(job.result)},
          {"moment", job.moment}};
}

void Jobs::run() {
  while (true) {
    std::shared_ptr<Job> job;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [&] { return closing_ || !waiting_.empty(); });
      if (closing_) return;
      job = waiting_.front();
      waiting_.pop_front();
      job->stage_began = Clock::now();
    }
    work(*job);
  }
}

void Jobs::work(Job& job) {
  try {
    Context context(*this, job);
    beginStage(context, job.kind);
    const std::string result = job.work(context);
    {
      const std::lock_guard lock(mutex_);
      job.result = result;
    }
    end(job, "done");
  } catch (const JobStopped&) {
    end(job, "cancelled");
  } catch (const InputError& error) {
    const std::lock_guard lock(mutex_);
    job.error = errorJson(error);
  } catch (const std::exception& error) {
    fmt::print(stderr, "tubeplan: job {} ({}): internal error: {}\n", job.id, job.kind, error.what());
    const std::lock_guard lock(mutex_);
    job.error = {{"message", std::string("internal error: ") + error.what()}};
  }
  if (!job.error.is_null()) end(job, "failed");
}

void Jobs::end(Job& job, const std::string& status) {
  {
    const std::lock_guard lock(mutex_);
    job.status = status;
    job.moment = events_.nextMoment();
    job.work = nullptr;  // frees the captured data
    events_.jobMoved(job.id, jsonOf(job).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  }
  events_.stateChanged();
}

}  // namespace tubeplan::app
