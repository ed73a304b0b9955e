#include "app/commands/command_line_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>

#include "app/storage/suggestion.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using Words = std::vector<std::string>;

std::string helpOf(const CLI::App& command) { return fmt::format("see `tubeplan {} --help`", command.get_name()); }

/// Returns the value type that the help shows for an option, such as "INT", without the text that the option's checks
/// append.
std::string typeOf(const CLI::Option& option) {
  const std::string name = option.get_type_name();
  return name.substr(0, name.find(':'));
}

/// Returns true for the type of a real number: without a unit, or in the file's unit for the named quantity.
bool isReal(const std::string& type) {
  constexpr std::string_view kReal[] = {"FLOAT", "LENGTH", "ANGLE", "FORCE", "TORQUE", "LENGTH,ANGLE"};
  return std::ranges::find(kReal, type) != std::end(kReal);
}

bool isFlag(const CLI::Option& option) { return option.get_items_expected_max() == 0; }

/// Returns a usage line such as "usage: tubeplan improve CELL MEASUREMENTS... --out TEXT, see `tubeplan improve
/// --help`".
std::string usageOf(const CLI::App& command) {
  std::string positionals, options;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) {
      const std::string name = option->get_name(true) + (option->get_items_expected_max() > 1 ? "..." : "");
      positionals += option->get_required() ? " " + name : " [" + name + "]";
    } else if (option->get_required()) {
      options += fmt::format(" {} {}", option->get_name(), typeOf(*option));
    }
  }
  return fmt::format("usage: tubeplan {}{}{}, {}", command.get_name(), positionals, options, helpOf(command));
}

std::string shown(const std::string& value) { return tubesheets::parseNumber(value) ? value : inQuotes(value); }

/// Returns the arguments that neither the command nor the program accepted.
Words unacceptedWords(const CLI::App& command) {
  Words unaccepted = command.remaining();
  for (auto& word : command.get_parent()->remaining()) unaccepted.push_back(std::move(word));
  return unaccepted;
}

/// Returns the first option among the unaccepted arguments, without its value. Arguments after "--" are not options.
std::optional<std::string> findUnknownOption(const Words& unaccepted) {
  const auto end = std::ranges::find(unaccepted, "--");
  const auto found = std::find_if(unaccepted.begin(), end, [](const std::string& word) {
    return word.size() > 1 && word.front() == '-' && !std::isdigit(static_cast<unsigned char>(word[1]));
  });
  return found == end ? std::nullopt : std::optional(found->substr(0, found->find('=')));
}

InputError unknownOption(const CLI::App& command, const std::string& name) {
  Words names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& long_name : option->get_lnames()) names.push_back("--" + long_name);
  return InputError::problem(nameInLine(name), "there is no such option",
                             name.starts_with("--") ? suggestionOr(name, names, helpOf(command)) : helpOf(command));
}

/// Returns the option at which the parser stopped, while checking its values or (`converting`) while converting them;
/// null if there is none. The parser goes through the options in the order of the help. It checks the values of an
/// option, marks the option as done, and then converts the values.
CLI::Option* stoppedAt(CLI::App& command, bool converting) {
  CLI::Option* before = nullptr;
  for (CLI::Option* option : command.get_options()) {
    if (option->count() == 0) continue;
    if (!option->get_callback_run()) return converting ? before : option;
    before = option;
  }
  return converting ? before : nullptr;
}

std::optional<InputError> missingWords(CLI::App& command) {
  Words names;
  for (const CLI::Option* option : command.get_options())
    if (option->get_required() && option->count() == 0) names.push_back(option->get_name());
  if (names.empty()) return std::nullopt;
  return InputError::problem(
      command.get_name(), enumeration(names) + (names.size() == 1 ? " is missing" : " are missing"), usageOf(command));
}

std::optional<InputError> wrongValue(CLI::App& command) {
  CLI::Option* option = stoppedAt(command, false);
  if (!option) return std::nullopt;
  const CLI::Validator& check = *option->get_validator();
  for (const std::string& value : option->results())
    if (const std::string expected = check(value); !expected.empty())
      return InputError(option->get_name(), shown(value), expected);
  return std::nullopt;
}

/// Returns the kind of value that an option takes, such as "a whole number"; empty for a string.
std::string kindOfValue(const CLI::Option& option) {
  const std::string type = typeOf(option);
  if (isReal(type)) return "a number";
  if (type == "INT") return "a whole number";
  return type == "UINT" ? "a whole number of zero or more" : "";
}

bool isOfKind(const CLI::Option& option, const std::string& value) {
  double real = 0;
  std::int64_t integer = 0;
  return isReal(typeOf(option)) ? CLI::detail::lexical_cast(value, real) : CLI::detail::lexical_cast(value, integer);
}

std::optional<InputError> unreadableValue(CLI::App& command) {
  const CLI::Option* option = stoppedAt(command, true);
  if (!option) return std::nullopt;
  const std::string name = option->get_name();
  const Words& values = option->results();
  if (isFlag(*option)) return InputError(name, inQuotes(values.back()), "no value", "write " + name + " alone");
  const auto wrong = std::ranges::find_if(values, [&](const auto& value) { return !isOfKind(*option, value); });
  if (wrong != values.end()) return InputError(name, shown(*wrong), kindOfValue(*option));
  return InputError(name, fmt::format("{}", fmt::join(values, ",")), "a whole number of at most 9 digits");
}

/// Returns the last option on the command line that takes a value; null if there is none.
const CLI::Option* lastWithValue(const CLI::App& command, const Words& words) {
  for (auto word = words.rbegin(); word != words.rend(); ++word)
    for (const CLI::Option* option : command.get_options())
      if (option->nonpositional() && !isFlag(*option) && option->check_name(word->substr(0, word->find('='))))
        return option;
  return nullptr;
}

std::optional<InputError> wrongCount(CLI::App& command, const Words& words) {
  for (const CLI::Option* option : command.get_options()) {
    const int count = static_cast<int>(option->count()), most = std::max(1, option->get_items_expected_max());
    if (count > most && option->get_multi_option_policy() == CLI::MultiOptionPolicy::Throw)
      return InputError(option->get_name(), fmt::format("{} values", count), most == 1 ? "one" : std::to_string(most),
                        "give the option once");
  }
  const CLI::Option* option = lastWithValue(command, words);
  if (!option) return std::nullopt;
  const std::string kind = kindOfValue(*option);
  if (!kind.empty()) return InputError(option->get_name(), "no value", kind);
  return InputError::problem(option->get_name(), "the value is missing", helpOf(command));
}

std::optional<InputError> optionWithout(CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    for (const CLI::Option* needed : option->get_needs())
      if (option->count() > 0 && needed->count() == 0)
        return InputError::problem(option->get_name(), "the option also needs " + needed->get_name(),
                                   fmt::format("add {}, or leave {} out", needed->get_name(), option->get_name()));
  return std::nullopt;
}

std::optional<InputError> superfluousWords(CLI::App& command) {
  for (const std::string& word : unacceptedWords(command))
    if (word != "--")
      return InputError::problem(command.get_name(), "too many arguments, starting at " + inQuotes(word),
                                 usageOf(command));
  return std::nullopt;
}

std::optional<InputError> mistakeOf(CLI::ExitCodes kind, CLI::App& command, const Words& words) {
  switch (kind) {
    case CLI::ExitCodes::RequiredError:
      return missingWords(command);
    case CLI::ExitCodes::ValidationError:
      return wrongValue(command);
    case CLI::ExitCodes::ConversionError:
      return unreadableValue(command);
    case CLI::ExitCodes::ArgumentMismatch:
      return wrongCount(command, words);
    case CLI::ExitCodes::RequiresError:
      return optionWithout(command);
    case CLI::ExitCodes::ExtrasError:
      return superfluousWords(command);
    default:
      return std::nullopt;
  }
}

}  // namespace

InputError commandLineError(const CLI::ParseError& error, CLI::App& command, const Words& words) {
  if (const auto unknown = findUnknownOption(unacceptedWords(command))) return unknownOption(command, *unknown);
  const auto kind = static_cast<CLI::ExitCodes>(error.get_exit_code());
  if (auto mistake = mistakeOf(kind, command, words)) return *std::move(mistake);
  return InputError::problem(command.get_name(), error.what(), helpOf(command));
}

}  // namespace tubeplan::app
