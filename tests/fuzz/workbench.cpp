// Fuzz targets of the workbench: its routes, its HTTP server, its line server, and its project files.
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/workbench/http_server.hpp"
#include "app/workbench/line_server.hpp"
#include "app/workbench/project.hpp"
#include "app/workbench/routes.hpp"
#include "tests/app/workbench/raw_connection.hpp"
#include "tests/fuzz/fuzzed_folder.hpp"
#include "tests/fuzz/fuzzed_reader.hpp"

// Included after Eigen, whose parameter names would clash with macros of the resolver's headers.
#include <httplib.h>

namespace tubeplan::app {

namespace {

/// Returns the workbench. It is never destroyed, like the servers below, because the fuzzer exits abruptly.
Workbench& workbench() {
  static Workbench& workbench = *new Workbench([] {
    WorkbenchOptions options;
    options.cell = fuzzedFolder() + "/bench.yaml";
    return options;
  }());
  return workbench;
}

/// Waits 2 ms for the jobs started by the input, then cancels them and waits until they end.
void endJobs() {
  const auto patience = std::chrono::steady_clock::now() + std::chrono::milliseconds(2);
  while (workbench().jobs().isBusy()) {
    if (std::chrono::steady_clock::now() > patience)
      for (const auto& job : workbench().jobs().list()) (void)workbench().jobs().cancel(job.at("id"));
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
}

/// Calls a route without a server. The first line of the text is method and route, such as "POST pose" or
/// "GET leverage?at=theta3". The rest is the body: JSON if it begins with a brace, else CSV.
void callWorkbench(const std::string& text) {
  const auto line = std::min(text.find('\n'), text.size());
  const auto blank = std::min(text.find(' '), line);
  const auto question = std::min(text.find('?', blank), line);
  Request request;
  request.method = text.substr(0, blank);
  std::istringstream words(text.substr(std::min(blank + 1, line), question - std::min(blank + 1, question)));
  for (std::string word; std::getline(words, word, '/');) request.words.push_back(word);
  httplib::Params parameters;
  httplib::detail::parse_query_text(text.substr(std::min(question + 1, line), line - std::min(question + 1, line)),
                                    parameters);
  for (const auto& [name, value] : parameters) request.query[name] = value;
  request.body = text.substr(std::min(line + 1, text.size()));
  request.content_type = request.body.starts_with("{") ? "application/json" : "text/csv";
  if (answer(workbench(), request).status == 500) std::abort();
  endJobs();
}

/// Sends bytes to a running HTTP server, with "PORT" replaced by the server's port.
void requestAccess(const std::string& text) {
  static HttpServer& server = *new HttpServer(workbench(), {"127.0.0.1", 0, ""}, "");
  static std::thread& serving = *new std::thread([] { server.run(); });
  (void)serving;
  static const std::string kPort = std::to_string(server.port());
  std::string bytes = text;
  for (auto at = bytes.find("PORT"); at != std::string::npos; at = bytes.find("PORT", at)) bytes.replace(at, 4, kPort);
  (void)saidTo(server.port(), bytes);
  endJobs();
}

/// Sends bytes to the line server, which receives lines of text from robot controllers.
void sendLines(const std::string& text) {
  static LineServer& server = *new LineServer(workbench(), 0);
  (void)saidTo(server.port(), text);
}

void readProjectText(const std::string& text) { (void)readProject(fileOf(text, "mine.tubeplan")); }

}  // namespace

const std::vector<FuzzedReader>& fuzzedReaders() {
  static const std::vector<FuzzedReader> kReaders = {{"call", callWorkbench, false},
                                                     {"door", requestAccess, false},
                                                     {"lines", sendLines, false},
                                                     {"project", readProjectText, false}};
  return kReaders;
}

}  // namespace tubeplan::app
