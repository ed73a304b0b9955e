#include "app/workbench/events.hpp"

namespace tubeplan::app {

namespace {

constexpr std::size_t kMostReportedJobs = 20;

}  // namespace

void Events::stateChanged() {
  const std::lock_guard lock(mutex_);
  ++state_;
  ++moment_;
  changed_.notify_all();
}

void Events::jobMoved(int id, std::string json) {
  const std::lock_guard lock(mutex_);
  jobs_[id] = {++job_number_, std::move(json)};
  while (jobs_.size() > kMostReportedJobs) jobs_.erase(jobs_.begin());
  changed_.notify_all();
}

void Events::liveMoved(std::string json) {
  const std::lock_guard lock(mutex_);
  live_ = std::move(json);
  ++live_number_;
  changed_.notify_all();
}

void Events::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

Events::News Events::wait(Seen& seen, std::chrono::milliseconds most) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, most, [&] {
    return closed_ || seen.state != state_ || seen.jobs != job_number_ || seen.live != live_number_;
  });
  News news;
  news.closed = closed_;
  news.state_changed = seen.state != state_;
  for (const auto& [id, job] : jobs_)
    if (job.number > seen.jobs) news.jobs.push_back(job.json);
  if (seen.live != live_number_) news.live = live_;
  seen = {state_, job_number_, live_number_};
  return news;
}

bool Events::tryEnter() {
  const std::lock_guard lock(mutex_);
  if (listeners_ >= most_listeners_) return false;
  ++listeners_;
  return true;
}

void Events::leave() {
  const std::lock_guard lock(mutex_);
  --listeners_;
}

}  // namespace tubeplan::app
