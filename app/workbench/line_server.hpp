// TCP server that shows postures of a running arm, received as lines of text, for controllers without HTTP.
//
// Each line contains the joint readings in the arm's order, optionally followed by the load, in the cell's units.
// Blanks, commas or semicolons separate the numbers. The answer is one line: the coordinates "x y z" of the deflected
// tip in the world frame, or "error: " with the reason. The server accepts connections from this machine only.
#pragma once

#include <memory>

#include "app/workbench/workbench.hpp"

namespace tubeplan::app {

class LineServer {
 public:
  /// Starts to listen; port 0 selects any free port. Throws InputError if it cannot listen there.
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
