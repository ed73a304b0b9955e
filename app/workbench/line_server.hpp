// Postures of a running arm as lines of text over TCP, for controllers that speak no HTTP.
//
// Each line has the joints' readings in the arm's order and, where one hangs there, the load behind them, in the cell's
// units, apart by blanks, commas or semicolons. Each is answered by one line: the deflected tip in the world, "x y z",
// or "error: " with what is wrong. Only this machine is listened to.
#pragma once

#include <memory>

#include "app/workbench/workbench.hpp"

namespace tubeplan::app {

class LineServer {
 public:
  /// Listens at once; port 0: any free one. Throws InputError where that cannot be listened at.
  LineServer(Workbench& workbench, int port);

  /// Ends all connections.
  ~LineServer();
  LineServer(const LineServer&) = delete;
  LineServer& operator=(const LineServer&) = delete;

  [[nodiscard]] int port() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace tubeplan::app
