// The workbench on a port: the door, the page's files, the events, and everything else handed to the routes.
#pragma once

#include <memory>
#include <string>

#include "app/workbench/door.hpp"
#include "app/workbench/workbench.hpp"

namespace tubeplan::app {

class HttpServer {
 public:
  /// Listens at once; port 0: any free one. Throws InputError where that cannot be listened at.
  HttpServer(Workbench& workbench, DoorRules door, const std::string& page_folder);
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  [[nodiscard]] int port() const;

  /// With the token, where there is one.
  [[nodiscard]] std::string address() const;

  /// Answers until stop().
  void run();

  /// Ends run(), all connections with it; for another thread than the one that runs, or is about to run, it.
  void stop();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace tubeplan::app
