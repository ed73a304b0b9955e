#include "app/documents/printed_page.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* kBrowsers[] = {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable"};
constexpr auto kPatience = std::chrono::seconds(60);

/// Returns the path in the environment variable TUBEPLAN_CHROMIUM, or else the first browser of kBrowsers found in
/// PATH; empty if there is none.
fs::path findBrowser() {
  if (const char* own = std::getenv("TUBEPLAN_CHROMIUM")) return ::access(own, X_OK) == 0 ? own : "";
  const char* path = std::getenv("PATH");
  std::stringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    for (const char* name : kBrowsers)
      if (::access((fs::path(folder) / name).c_str(), X_OK) == 0) return fs::path(folder) / name;
  return {};
}

fs::path requiredBrowser() {
  const fs::path browser = findBrowser();
  if (const char* own = std::getenv("TUBEPLAN_CHROMIUM"); own && *own != '\0' && browser.empty())
    throw InputError::problem(
        "--pdf", fmt::format("'{}' of $TUBEPLAN_CHROMIUM is not a program that can be run", own),
        "set the variable to the path of Chromium, or leave out --pdf and print the page from any browser");
  if (browser.empty())
    throw InputError::problem("--pdf", "Chromium is not installed",
                              "install the package chromium, set $TUBEPLAN_CHROMIUM to the path of Chromium, or leave "
                              "out --pdf and print the page from any browser");
  return browser;
}

/// Starts a process with its output discarded, and returns its process id.
pid_t start(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const auto& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t quiet;
  ::posix_spawn_file_actions_init(&quiet);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    ::posix_spawn_file_actions_addopen(&quiet, stream, "/dev/null", O_WRONLY, 0);
  pid_t process = 0;
  const int failed = ::posix_spawn(&process, arguments.front(), &quiet, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&quiet);
  return failed ? -1 : process;
}

/// Returns true if the process exits with code 0 within the time limit. A process that is still running then is killed.
bool finishes(pid_t process) {
  int status = 0;
  for (const auto end = std::chrono::steady_clock::now() + kPatience; std::chrono::steady_clock::now() < end;) {
    if (::waitpid(process, &status, WNOHANG) == process) return WIFEXITED(status) && WEXITSTATUS(status) == 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  ::kill(process, SIGKILL);
  ::waitpid(process, &status, 0);
  return false;
}

}  // namespace

void requirePrinter() { (void)requiredBrowser(); }

void printPage(const fs::path& page, const fs::path& pdf) {
  const fs::path browser = requiredBrowser();
  std::vector<std::string> words = {browser.string(),
                                    "--headless",
                                    "--disable-gpu",
                                    "--no-pdf-header-footer",
                                    "--virtual-time-budget=4000",
                                    "--print-to-pdf=" + fs::absolute(pdf).string()};
  if (::geteuid() == 0) words.emplace_back("--no-sandbox");  // Chromium refuses to run as root without --no-sandbox
  words.push_back("file://" + fs::absolute(page).string());
  const pid_t process = start(words);
  if (process <= 0 || !finishes(process) || !fs::exists(pdf))
    throw InputError::problem("--pdf", browser.string() + " did not produce a PDF within a minute",
                              "leave out --pdf and print the page from any browser");
}

}  // namespace tubeplan::app
