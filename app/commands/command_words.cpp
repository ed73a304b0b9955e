#include "app/commands/command_words.hpp"

#include <CLI/CLI.hpp>

#include "app/commands/command_table.hpp"

namespace tubeplan::app {

namespace {

OptionWords wordsOf(const CLI::Option& option) {
  OptionWords words;
  words.description = option.get_description();
  words.initial = option.get_default_str();
  words.is_positional = option.get_positional();
  words.is_required = option.get_required();
  words.is_list = option.get_items_expected_max() > 1;
  words.delimiter = option.get_delimiter();
  if (words.is_positional) {
    words.names = {option.get_name(true)};
    return words;
  }
  for (const std::string& name : option.get_snames()) words.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) words.names.push_back("--" + name);
  if (option.get_items_expected_max() > 0)
    words.value = option.get_type_name().empty() ? "VALUE" : option.get_type_name();
  return words;
}

}  // namespace

std::vector<CommandWords> commandWords() {
  std::vector<CommandWords> all;
  for (const Command& command : commands()) {
    CLI::App cli;
    (void)command.configure(cli);
    CommandWords words{std::string(command.name), std::string(command.summary), std::string(command.example), {}};
    for (const CLI::Option* option : cli.get_options()) words.options.push_back(wordsOf(*option));
    all.push_back(std::move(words));
  }
  return all;
}

}  // namespace tubeplan::app
