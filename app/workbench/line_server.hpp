// Server for postures of a running arm as lines of text over TCP, for controllers without HTTP.
//
// Each line has the joints' readings in the arm's order and, optionally, the load after them, in the cell's units,
// separated by blanks, commas or semicolons. The answer is one line: the deflected tip in the world, "x y z", or
// "error: " with the reason. The server accepts connections from this machine only.
#pragma once

#include <memory>

#include "app/workbench/workbench.hpp"

namespace tubeplan::app {

class LineServer {
 public:
  /// Starts to listen at once; port 0: any free port. Throws InputError if it cannot listen there.
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
