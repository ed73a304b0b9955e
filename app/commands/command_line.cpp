#include "app/commands/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include "app/cli/caller.hpp"
#include "app/commands/command_line_error.hpp"
#include "app/commands/command_table.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/origin.hpp"
#include "app/storage/suggestion.hpp"
#include "app/version.hpp"

namespace tubeplan::app {

namespace {

std::string overview() {
  std::string text = "tubeplan: plans the visits of a flexible arm to the tubes of a steam generator\n\n";
  for (const Command& command : commands()) {
    text += fmt::format("  {:<10}  {}\n", command.name, command.summary);
    text += fmt::format("  {:<10}    {}\n", "", command.example.substr(0, command.example.find('\n')));
  }
  return text + fmt::format(
                    "\n`tubeplan COMMAND --help` describes one, `tubeplan --cells` prints the folder of the "
                    "example cells. Exit codes: {}.\n",
                    kExitCodes);
}

/// Returns the folder of the example cells, which is installed next to the program. A program that was built in the
/// source tree finds them there. Throws InputError if there is none.
std::string exampleCells() {
  const auto folder = std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path();
  for (const char* cells : {"share/tubeplan/cells", "app/cells"})
    if (std::filesystem::is_directory(folder / cells)) return (folder / cells).string();
  throw InputError::problem("--cells", "the example cells are not installed with this program",
                            "install the whole package, or take them from the source tree: app/cells");
}

// Replaces `help CMD ACTION` by `CMD ACTION --help`. Returns true if the overview of all commands is requested: by
// `help`, --help, -h or an empty command line.
bool isOverviewRequested(std::vector<std::string>& words) {
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    if (!words.empty()) words.emplace_back("--help");
  }
  return words.empty() || words.front() == "--help" || words.front() == "-h";
}

void refuseUnknownCommand(const std::string& word) {
  std::vector<std::string> names;
  for (const Command& command : commands()) names.emplace_back(command.name);
  if (std::find(names.begin(), names.end(), word) != names.end()) return;
  if (word.starts_with("-"))
    throw InputError::problem(nameInLine(word), "the command is missing before this option",
                              "begin with a command; `tubeplan help` lists the commands");
  throw InputError("COMMAND", inQuotes(word), alternatives(names), suggestionOr(word, names, "see `tubeplan help`"));
}

}  // namespace

int runCommandLine(std::vector<std::string> words) {
  if (isOverviewRequested(words)) {
    output("{}", overview());
    return kDone;
  }
  if (words.front() == "--version") {
    output("tubeplan {}\n", kVersion);
    return kDone;
  }
  if (words.front() == "--cells") {
    output("{}\n", exampleCells());
    return kDone;
  }
  const std::string name = words.front();
  refuseUnknownCommand(name);
  CLI::App cli("tubeplan");
  cli.require_subcommand(1);
  std::map<std::string, Run> runs;
  for (const Command& command : commands()) {
    CLI::App* sub = cli.add_subcommand(std::string(command.name), std::string(command.summary));
    sub->footer(fmt::format("Example:\n  {}", command.example));
    runs[std::string(command.name)] = command.configure(*sub);
  }
  try {
    std::vector<std::string> reversed(words.rbegin(), words.rend());  // CLI11 expects the arguments in reverse order
    cli.parse(reversed);
  } catch (const CLI::CallForHelp&) {
    output("{}", cli.get_subcommand(name)->help("tubeplan"));
    return kDone;
  } catch (const CLI::ParseError& error) {
    throw commandLineError(error, *cli.get_subcommand(name), words);
  }
  const InputRecord inputs;  // records the input files of this command
  return runs.at(cli.get_subcommands().front()->get_name())();
}

}  // namespace tubeplan::app
