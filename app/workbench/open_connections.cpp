#include "app/workbench/open_connections.hpp"

#include <algorithm>
#include <memory>
#include <system_error>
#include <thread>

namespace tubeplan::app {

void TaskThreads::enqueue(std::function<void()> task) {
  {
    const std::lock_guard lock(mutex_);
    ++running_;
  }
  const auto shared = std::make_shared<std::function<void()>>(std::move(task));
  const auto run = [this, shared] {
    (*shared)();
    *shared = nullptr;
    // Within the lock: who waits may put an end to all of this as soon as it is given back.
    const std::lock_guard lock(mutex_);
    --running_;
    ended_.notify_all();
  };
  try {
    std::thread(run).detach();
  } catch (const std::system_error&) {
    run();  // no more threads: the others wait, and nobody is lost
  }
}

void TaskThreads::shutdown() {
  std::unique_lock lock(mutex_);
  ended_.wait(lock, [this] { return running_ == 0; });
}

bool OpenConnections::enter(Connection& connection) {
  const std::lock_guard lock(mutex_);
  if (open_.size() >= most_) {
    const auto idlest = std::min_element(open_.begin(), open_.end(), [](const Connection* a, const Connection* b) {
      return a->awaitedSince() < b->awaitedSince();
    });
    if ((*idlest)->awaitedSince() == Connection::kNotAwaited) return false;
    (*idlest)->end();
    open_.erase(idlest);
  }
  open_.push_back(&connection);
  return true;
}

void OpenConnections::leave(const Connection& connection) {
  const std::lock_guard lock(mutex_);
  std::erase(open_, &connection);
}

}  // namespace tubeplan::app
