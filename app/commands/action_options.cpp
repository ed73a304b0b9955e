#include "app/commands/action_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

#include "app/commands/option_checks.hpp"
#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

std::string nameOf(const CLI::Option& option) {
  return option.get_lnames().empty() ? option.get_name() : "--" + option.get_lnames().front();
}

/// Returns the actions that have an option; none if all have it.
std::vector<std::string> actionsWith(const CLI::Option& option, const std::vector<ActionOptions>& table) {
  std::vector<std::string> actions;
  for (const ActionOptions& row : table)
    if (std::ranges::find(row.options, nameOf(option)) != row.options.end()) actions.push_back(row.action);
  return actions;
}

std::vector<std::string> splitAt(std::string text, const std::string& mark) {
  std::vector<std::string> parts;
  for (std::size_t end = text.find(mark); end != std::string::npos; end = text.find(mark)) {
    parts.push_back(text.substr(0, end));
    text.erase(0, end + mark.size());
  }
  parts.push_back(text);
  return parts;
}

constexpr std::string_view kOthers = "all others: ";

/// Help text of a command, or of the one of its actions that the command line names.
class ActionHelp : public CLI::Formatter {
 public:
  ActionHelp(const CLI::Option& option, std::vector<ActionOptions> table) : option_(option), table_(std::move(table)) {}

  [[nodiscard]] std::string make_description(const CLI::App* app) const override {
    return chosen() ? chosen()->words + "\n" : Formatter::make_description(app);
  }

  [[nodiscard]] std::string make_usage(const CLI::App* app, std::string name) const override {
    if (!chosen()) return Formatter::make_usage(app, name);
    std::string usage = fmt::format("Usage: {} {} [OPTIONS]", name, chosen()->action);
    for (const CLI::Option* argument : app->get_options())
      if (argument->get_positional() && isShown(*argument)) usage += " " + make_option_usage(argument);
    return usage + "\n";
  }

  [[nodiscard]] std::string make_group(std::string group, bool is_positional,
                                       std::vector<const CLI::Option*> options) const override {
    std::erase_if(options, [&](const CLI::Option* option) { return !isShown(*option); });
    return Formatter::make_group(group, is_positional, options);
  }

  [[nodiscard]] std::string make_option_desc(const CLI::Option* option) const override {
    const std::string all = Formatter::make_option_desc(option);
    if (!chosen()) return all;
    std::string shown;
    bool is_kept = true;
    for (const std::string& part : splitAt(all, "; ")) {
      const auto actions = actionsBefore(part);
      const bool is_of_others = part.starts_with(kOthers);
      if (is_of_others) is_kept = shown.empty();
      if (!actions.empty()) is_kept = std::ranges::find(actions, chosen()->action) != actions.end();
      if (!is_kept) continue;
      const bool is_bare = actions.empty() && !is_of_others;
      shown += (shown.empty() ? "" : "; ") + (is_bare ? part : part.substr(part.find(": ") + 2));
    }
    return shown;
  }

  [[nodiscard]] std::string make_footer(const CLI::App* app) const override {
    if (!chosen()) return Formatter::make_footer(app);
    std::string footer;
    for (const std::string& line : splitAt(app->get_footer(), "\n"))
      if (line.find(fmt::format("{} {} ", app->get_name(), chosen()->action)) != std::string::npos)
        footer += "  " + line.substr(line.find_first_not_of(' ')) + "\n";
    return footer.empty() ? "" : "Example:\n" + footer;
  }

 private:
  /// Returns the action that the command line names; null if it names none.
  [[nodiscard]] const ActionOptions* chosen() const {
    const auto row =
        std::ranges::find(table_, option_.count() > 0 ? option_.results().front() : "", &ActionOptions::action);
    return row == table_.end() ? nullptr : &*row;
  }

  [[nodiscard]] bool isShown(const CLI::Option& option) const {
    if (!chosen()) return true;
    const auto actions = actionsWith(option, table_);
    return &option != &option_ && (actions.empty() || std::ranges::find(actions, chosen()->action) != actions.end());
  }

  /// Returns the actions with whose names a part of a description begins; none if it begins otherwise.
  [[nodiscard]] std::vector<std::string> actionsBefore(const std::string& part) const {
    const auto actions = splitAt(part.substr(0, part.find(": ")), ", ");
    const auto isAction = [&](const std::string& name) {
      return std::ranges::find(table_, name, &ActionOptions::action) != table_.end();
    };
    return std::ranges::all_of(actions, isAction) ? actions : std::vector<std::string>{};
  }

  const CLI::Option& option_;
  std::vector<ActionOptions> table_;
};

}  // namespace

void addAction(CLI::App& cli, std::string& action, const std::vector<ActionOptions>& table) {
  std::vector<std::string> names, words;
  for (const ActionOptions& row : table) {
    names.push_back(row.action);
    words.push_back(fmt::format("{}: {}", row.action, row.words));
  }
  const CLI::Option* option =
      cli.add_option("ACTION", action, fmt::format("{}", fmt::join(words, "; ")))->required()->check(oneOf(names));
  cli.formatter(std::make_shared<ActionHelp>(*option, table));
}

void requireOptionsOf(const CLI::App& cli, const std::string& action, const std::vector<ActionOptions>& table) {
  for (const CLI::Option* option : cli.get_options()) {
    if (option->count() == 0) continue;
    const auto actions = actionsWith(*option, table);
    if (actions.empty() || std::ranges::find(actions, action) != actions.end()) continue;
    const std::string between = fmt::format("` or `{} ", cli.get_name());
    throw InputError::problem(nameOf(*option),
                              fmt::format("this is an option of `{0} {1}`, not of `{0} {2}`", cli.get_name(),
                                          fmt::join(actions, between), action),
                              "leave it out");
  }
}

}  // namespace tubeplan::app
