// Server of the workbench on a port: admission, the page's files, the events, and the routes for all other requests.
#pragma once

#include <memory>
#include <string>

#include "app/workbench/door.hpp"
#include "app/workbench/workbench.hpp"

namespace tubeplan::app {

class HttpServer {
 public:
  /// Starts to listen at once; port 0: any free port. Throws InputError if it cannot listen there.
  HttpServer(Workbench& workbench, DoorRules door, const std::string& page_folder);
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  [[nodiscard]] int port() const;

  /// Returns the address, including the token if there is one.
  [[nodiscard]] std::string address() const;

  /// Answers requests until stop().
  void run();

  /// Ends run() and all connections. Called from a thread other than that of run(), also shortly before run() begins.
  void stop();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace tubeplan::app
