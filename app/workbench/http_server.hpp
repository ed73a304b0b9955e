// HTTP server of the workbench: admission, files of the page, events, and the routes for all other requests.
#pragma once

#include <memory>
#include <string>

#include "app/workbench/access.hpp"
#include "app/workbench/workbench.hpp"

namespace tubeplan::app {

class HttpServer {
 public:
  /// Starts to listen; port 0 selects any free port. Throws InputError if it cannot listen there.
  HttpServer(Workbench& workbench, AccessRules access, const std::string& page_folder);
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  [[nodiscard]] int port() const;

  /// Returns the URL of the server, including the token if there is one.
  [[nodiscard]] std::string address() const;

  /// Answers requests until stop().
  void run();

  /// Ends run() and all connections. Must be called from another thread than run(); may be called before run() begins.
  void stop();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace tubeplan::app
