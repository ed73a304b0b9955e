// Scripts that complete commands and options, for the usual shells.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "app/commands/command_words.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/named_entry.hpp"

namespace tubeplan::app {

namespace {

std::vector<std::string> optionNames(const CommandWords& command) {
  std::vector<std::string> names;
  for (const auto& option : command.options)
    if (!option.is_positional) names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

std::string bash() {
  std::vector<std::string> names;
  std::string cases;
  for (const auto& command : commandWords()) {
    names.push_back(command.name);
    cases += fmt::format("    {}) words='{}' ;;\n", command.name, fmt::join(optionNames(command), " "));
  }
  return fmt::format(
      "_tubeplan() {{\n"
      "  local current=${{COMP_WORDS[COMP_CWORD]}} words=\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -W '{} help' -- \"$current\")\n"
      "    return\n"
      "  fi\n"
      "  case ${{COMP_WORDS[1]}} in\n{}  esac\n"
      "  if [ \"${{current:0:1}}\" = - ]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n"
      "  else\n"
      "    mapfile -t COMPREPLY < <(compgen -f -- \"$current\")\n"
      "  fi\n"
      "}}\n"
      "complete -o filenames -F _tubeplan tubeplan\n",
      fmt::join(names, " "), cases);
}

/// Returns text for use between single quotes; characters that are special in zsh argument descriptions are escaped.
std::string zshText(const std::string& text) {
  return replaced(replaced(replaced(replaced(text, "'", "'\\''"), "[", "\\["), "]", "\\]"), ":", "\\:");
}

std::string zsh() {
  std::string names, cases;
  for (const auto& command : commandWords()) {
    names += fmt::format("    '{}:{}'\n", command.name, zshText(command.summary));
    cases += fmt::format("    {}) _arguments '*:file:_files'", command.name);
    for (const auto& option : command.options)
      for (const auto& name : option.names)
        if (!option.is_positional)
          cases += fmt::format(" \\\n      '{}{}[{}]{}'", name, option.value.empty() ? "" : "=",
                               zshText(option.description), option.value.empty() ? "" : ":value:_files");
    cases += " ;;\n";
  }
  return fmt::format(
      "#compdef tubeplan\n_tubeplan() {{\n  local -a commands=(\n{}  )\n"
      "  if (( CURRENT == 2 )); then\n    _describe command commands\n    return\n  fi\n"
      "  shift words\n  (( CURRENT-- ))\n  case $words[1] in\n{}  esac\n}}\n_tubeplan \"$@\"\n",
      names, cases);
}

std::string fishText(const std::string& text) { return replaced(replaced(text, "\\", "\\\\"), "'", "\\'"); }

std::string fish() {
  std::string script;
  for (const auto& command : commandWords()) {
    script += fmt::format("complete -c tubeplan -n __fish_use_subcommand -f -a {} -d '{}'\n", command.name,
                          fishText(command.summary));
    for (const auto& option : command.options)
      for (const auto& name : option.names)
        if (!option.is_positional)
          script +=
              fmt::format("complete -c tubeplan -n '__fish_seen_subcommand_from {}' {} {}{} -d '{}'\n", command.name,
                          name.starts_with("--") ? "-l" : "-s", name.substr(name.starts_with("--") ? 2 : 1),
                          option.value.empty() ? "" : " -r", fishText(option.description));
  }
  return script;
}

struct Shell {
  const char* name;
  std::string (*script)();
};
constexpr std::array<Shell, 3> kShells{{{"bash", bash}, {"zsh", zsh}, {"fish", fish}}};

}  // namespace

std::string completionScript(const std::string& shell) { return entryNamed(kShells, shell, "SHELL").script(); }

}  // namespace tubeplan::app
