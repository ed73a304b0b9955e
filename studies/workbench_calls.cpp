// Study of ten thousand random calls of a workbench: the number of answers of each HTTP status, the growth of memory,
// and whether the workbench left files outside its folder.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "app/workbench/http_server.hpp"
#include "tests/app/workbench/random_calls.hpp"

namespace {

namespace fs = std::filesystem;
using namespace tubeplan::app;

struct Options {
  int calls = 10000;
  std::uint64_t seed = 1;
};

std::size_t countFiles(const fs::path& folder) {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : fs::recursive_directory_iterator(folder)) ++count;
  return count;
}

/// Copies the shipped cells into a folder, with a small tube sheet, so that jobs end while calls arrive.
fs::path copyCells(const fs::path& folder) {
  const std::string large = "rows: 49, columns: 114", small = "rows: 8, columns: 12";
  fs::remove_all(folder);
  fs::create_directories(folder / "opened");
  for (const auto& entry : fs::directory_iterator(fs::path(TUBEPLAN_SOURCE_DIR) / "app/cells")) {
    if (!entry.is_regular_file()) continue;
    std::ifstream stream(entry.path());
    std::string text(std::istreambuf_iterator<char>(stream), {});
    if (const std::size_t at = text.find(large); at != std::string::npos) text.replace(at, large.size(), small);
    std::ofstream(folder / "opened" / entry.path().filename()) << text;
  }
  return folder / "opened";
}

int run(const Options& options) {
  const fs::path folder = fs::temp_directory_path() / fmt::format("tubeplan_calls_{}", ::getpid());
  const fs::path opened = copyCells(folder);
  WorkbenchOptions workbench_options;
  workbench_options.cell = (opened / "mockup.yaml").string();
  workbench_options.truth = (opened / "mockup-true.yaml").string();
  Workbench workbench(workbench_options);
  HttpServer server(workbench, {"127.0.0.1", 0, ""}, "");
  std::thread serving([&] { server.run(); });
  const std::size_t memory = residentMemory();
  RandomCalls calls(server.port(), options.seed);
  for (int done = 0; done < options.calls; done += 1000) {
    for (const auto& [status, count] : calls.make(std::min(1000, options.calls - done)))
      fmt::print("{}: {}  ", status, count);
    fmt::print("  memory {} MB\n", residentMemory() >> 20);
  }
  server.stop();
  serving.join();
  const bool is_clean = countFiles(folder) == countFiles(opened) + 1;
  fmt::print("{} calls; memory grew by {} MB; {} outside the folder\n", options.calls,
             (residentMemory() - memory) >> 20, is_clean ? "nothing" : "something");
  fs::remove_all(folder);
  return is_clean ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App cli("random calls of the workbench");
  Options options;
  cli.add_option("--calls", options.calls)->check(CLI::Range(1, 10000000));
  cli.add_option("--seed", options.seed);
  CLI11_PARSE(cli, argc, argv);
  return run(options);
}
