// The workbench, fuzzed from four sides: its routes, its HTTP door, its lines of text, its projects.
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

// After Eigen, whose parameters have names that the resolver's headers define.
#include <httplib.h>

namespace tubeplan::app {

namespace {

/// Never ended, like the servers of it: the fuzzer leaves without a word.
Workbench& workbench() {
  static Workbench& workbench = *new Workbench([] {
    WorkbenchOptions options;
    options.cell = fuzzedFolder() + "/bench.yaml";
    return options;
  }());
  return workbench;
}

/// A job that the input began belongs to it: it has a moment, then it is stopped and waited for.
void endJobs() {
  const auto patience = std::chrono::steady_clock::now() + std::chrono::milliseconds(2);
  while (workbench().jobs().isBusy()) {
    if (std::chrono::steady_clock::now() > patience)
      for (const auto& job : workbench().jobs().list()) (void)workbench().jobs().cancel(job.at("id"));
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
}

/// The routes alone. "POST pose" or "GET leverage?at=theta3" in the first line, the body after it: JSON where that
/// begins with a brace, else CSV.
void callWorkbench(const std::string& text) {
  const auto line = std::min(text.find('\n'), text.size());
  const auto blank = std::min(text.find(' '), line);
  const auto question = std::min(text.find('?', blank), line);
  Request request;
  request.method = text.substr(0, blank);
  std::istringstream words(text.substr(std::min(blank + 1, line), question - std::min(blank + 1, question)));
  for (std::string word; std::getline(words, word, '/');) request.words.push_back(word);
  httplib::Params asked;
  httplib::detail::parse_query_text(text.substr(std::min(question + 1, line), line - std::min(question + 1, line)),
                                    asked);
  for (const auto& [name, value] : asked) request.query[name] = value;
  request.body = text.substr(std::min(line + 1, text.size()));
  request.content_type = request.body.starts_with("{") ? "application/json" : "text/csv";
  if (answer(workbench(), request).status == 500) std::abort();
  endJobs();
}

/// Bytes sent to a running server; "PORT" in them stands for its port.
void knockAtDoor(const std::string& text) {
  static HttpServer& server = *new HttpServer(workbench(), {"127.0.0.1", 0, ""}, "");
  static std::thread& serving = *new std::thread([] { server.run(); });
  (void)serving;
  static const std::string kPort = std::to_string(server.port());
  std::string bytes = text;
  for (auto at = bytes.find("PORT"); at != std::string::npos; at = bytes.find("PORT", at)) bytes.replace(at, 4, kPort);
  (void)saidTo(server.port(), bytes);
  endJobs();
}

/// Bytes sent to where controllers send lines.
void sendLines(const std::string& text) {
  static LineServer& server = *new LineServer(workbench(), 0);
  (void)saidTo(server.port(), text);
}

void readProjectText(const std::string& text) { (void)readProject(fileOf(text, "mine.tubeplan")); }

}  // namespace

const std::vector<FuzzedReader>& fuzzedReaders() {
  static const std::vector<FuzzedReader> kReaders = {{"call", callWorkbench, false},
                                                     {"door", knockAtDoor, false},
                                                     {"lines", sendLines, false},
                                                     {"project", readProjectText, false}};
  return kReaders;
}

}  // namespace tubeplan::app
