#include "app/cli/json_target.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/files/atomic_file.hpp"
#include "app/files/origin.hpp"

namespace tubeplan::app {

void checkJsonTarget(const std::string& target) {
  if (!target.empty() && target != "-") checkWritableFile(target, "--json");
}

void writeJson(const std::string& target, nlohmann::json json) {
  if (target.empty()) return;
  stateOrigin(json);
  const std::string text = json.dump(2) + "\n";
  if (target == "-")
    fmt::print("{}", text);
  else
    writeFileAtomically(target, text, "--json");
}

}  // namespace tubeplan::app
