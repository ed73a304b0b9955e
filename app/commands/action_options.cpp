#include "app/commands/action_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/storage/input_error.hpp"

namespace tubeplan::app {

void requireOptionsOf(const CLI::App& cli, const std::string& action, const std::vector<ActionOptions>& table) {
  for (const CLI::Option* option : cli.get_options()) {
    if (option->count() == 0) continue;
    const std::string name = option->get_lnames().empty() ? option->get_name() : "--" + option->get_lnames().front();
    std::vector<std::string> actions;
    for (const ActionOptions& row : table)
      if (std::ranges::find(row.options, name) != row.options.end()) actions.push_back(row.action);
    if (actions.empty() || std::ranges::find(actions, action) != actions.end()) continue;
    const std::string between = fmt::format("` or `{} ", cli.get_name());
    throw InputError::saying(name,
                             fmt::format("this is an option of `{0} {1}`, not of `{0} {2}`", cli.get_name(),
                                         fmt::join(actions, between), action),
                             "leave it out");
  }
}

}  // namespace tubeplan::app
