// All connections of a server: each has a thread of its own, and a new one always finds room.
#pragma once

#include <httplib.h>

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <vector>

#include "app/workbench/connection.hpp"

namespace tubeplan::app {

/// A thread for each task, so that none waits for another's end.
class TaskThreads : public httplib::TaskQueue {
 public:
  void enqueue(std::function<void()> task) override;
  void shutdown() override;  ///< waits for all

 private:
  std::mutex mutex_;
  std::condition_variable ended_;
  int running_ = 0;
};

class OpenConnections {
 public:
  explicit OpenConnections(std::size_t most) : most_(most) {}

  /// Takes a connection in. Where there are too many, the one that has left the server waiting for its request the
  /// longest is ended; false where all are being answered.
  [[nodiscard]] bool enter(Connection& connection);
  void leave(const Connection& connection);

 private:
  std::size_t most_;
  std::mutex mutex_;
  std::vector<Connection*> open_;
};

}  // namespace tubeplan::app
