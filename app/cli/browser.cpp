#include "app/cli/browser.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <unistd.h>

#include <cstdlib>

namespace tubeplan::app {

void openInBrowser(std::string place) {
  const char* named = std::getenv("BROWSER");
  std::string program = named && *named ? named : "xdg-open";
  char* const words[] = {program.data(), place.data(), nullptr};
  pid_t process = 0;
  if (::posix_spawnp(&process, program.c_str(), nullptr, nullptr, words, environ) != 0)
    fmt::print(stderr, "tubeplan: no browser could be opened ({} is not there): {}\n", program, place);
}

}  // namespace tubeplan::app
