// `tubeplan serve`: serves the workbench, a web page, on this machine.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include "app/cli/browser.hpp"
#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/cli/stop_signal.hpp"
#include "app/commands/option_checks.hpp"
#include "app/storage/input_error.hpp"
#include "app/workbench/http_server.hpp"
#include "app/workbench/line_server.hpp"
#include "app/workbench/live.hpp"

namespace tubeplan::app {

namespace {

struct ServeOptions {
  WorkbenchOptions workbench;
  AccessRules access;
  std::string page, watch;
  std::optional<int> lines;
  bool open = false;
};

constexpr std::size_t kShortestToken = 12;
constexpr auto kGlanceAtArm = std::chrono::milliseconds(50);  // interval between checks for new data from a running arm

void requireToken(const AccessRules& access) {
  if (access.token.empty() && isLoopback(access.host)) return;
  if (access.token.empty())
    throw InputError::problem("--host",
                              "others on the network could reach " + inQuotes(access.host) + " without a token",
                              "add --token TEXT, which is then required for access");
  const bool is_plain = std::all_of(access.token.begin(), access.token.end(),
                                    [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '_'; });
  if (!is_plain || access.token.size() < kShortestToken)
    throw InputError::problem("--token", "the token is too short or contains an invalid character",
                              fmt::format("use at least {} characters from letters, digits, - and _", kShortestToken));
}

int run(const ServeOptions& options) {
  requireToken(options.access);
  Workbench workbench(options.workbench);
  HttpServer server(workbench, options.access, options.page);
  noteStopSignals();
  output("{}\n", server.address());
  std::optional<LineServer> lines;
  if (options.lines) {
    lines.emplace(workbench, *options.lines);
    output("postures as lines: 127.0.0.1 port {}\n", lines->port());
  }
  std::fflush(stdout);
  if (options.open) openInBrowser(server.address());
  std::thread serving([&server] { server.run(); });
  WatchedFile watched(options.watch);
  const auto stop = stopCondition();
  while (!stop()) {
    std::this_thread::sleep_for(kGlanceAtArm);
    if (!options.watch.empty()) watched.look(workbench);
    joinArrived(workbench);
  }
  server.stop();
  serving.join();
  return kDone;
}

}  // namespace

Run configureServe(CLI::App& cli) {
  const auto options = std::make_shared<ServeOptions>();
  options->access.port = 8642;
  options->workbench.state = defaultStateFolder();
  cli.add_option("CELL", options->workbench.cell, "the cell file, or a project that was saved")->required();
  cli.add_option("MEASUREMENTS", options->workbench.measurement_files, "readings of any kind (CSV), taken together");
  cli.add_option("--port", options->access.port, "port to listen on; 0 chooses a free one")
      ->check(within(0, 65535))
      ->capture_default_str();
  cli.add_option("--host", options->access.host, "the address to listen at; any but loopback requires --token")
      ->capture_default_str();
  cli.add_option("--token", options->access.token,
                 "the access token that a browser must send, 12 or more letters, digits, - and _");
  cli.add_option("--folder", options->workbench.folder,
                 "the folder whose files the page may open and write (the cell's)");
  cli.add_option("--state", options->workbench.state, "the folder in which the session is saved, to be resumed later")
      ->default_str("$XDG_STATE_HOME/tubeplan");
  cli.add_flag("--fresh", options->workbench.fresh, "start a new session; the old one remains under Open, Recent");
  cli.add_option("--truth", options->workbench.truth, "the cell of the true arm, for simulated touches");
  cli.add_option("--watch", options->watch,
                 "follow this file (CSV): readings that are added to it, or joint readings of a running arm");
  cli.add_option("--lines", options->lines,
                 "also accept postures of a running arm as lines of text at this TCP port; 0 chooses a free one")
      ->check(within(0, 65535));
  cli.add_option("--page", options->page, "serve the page from this folder instead of the program's own");
  cli.add_flag("--open", options->open, "open the page in a browser");
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
