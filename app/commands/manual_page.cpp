// Manual page, generated from the declarations of the commands.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/cli/command.hpp"
#include "app/commands/command_words.hpp"
#include "app/version.hpp"

namespace tubeplan::app {

namespace {

/// Returns text in which characters that are special in roff are escaped.
std::string plain(const std::string& text) {
  std::string out;
  bool begins = true;
  for (const char c : text) {
    if (begins && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
    begins = c == '\n';
  }
  return out;
}

std::string optionText(const OptionWords& option) {
  const std::string value = option.value.empty() ? "" : fmt::format(" \\fI{}\\fR", plain(option.value));
  const std::string initial = option.initial.empty() ? "" : fmt::format(" (default: {})", plain(option.initial));
  std::vector<std::string> names;
  for (const auto& name : option.names)
    names.push_back(fmt::format("\\f{}{}\\fR", option.is_positional ? 'I' : 'B', plain(name)));
  return fmt::format(".TP\n{}{}\n{}{}\n", fmt::join(names, ", "), value, plain(option.description), initial);
}

}  // namespace

std::string manualPage() {
  std::string page = fmt::format(
      ".TH TUBEPLAN 1 \"\" \"tubeplan {}\" \"User Commands\"\n.SH NAME\n"
      "tubeplan \\- plans and calibrates a flexible arm under a steam generator's tube sheet\n"
      ".SH SYNOPSIS\n.B tubeplan\n\\fICOMMAND\\fR [\\fIARGUMENT\\fR ...]\n.SH COMMANDS\n",
      plain(kVersion));
  for (const auto& command : commandWords()) {
    page += fmt::format(".SS {}\n{}\n", command.name, plain(command.summary));
    for (const auto& option : command.options) page += optionText(option);
    page += fmt::format(".PP\n.nf\n{}\n.fi\n", plain(command.example));
  }
  return page + fmt::format(".SH EXIT STATUS\n{}.\n", plain(kExitCodes));
}

}  // namespace tubeplan::app
