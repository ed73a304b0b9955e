// Caller of a command: the terminal, or another program that takes the command's words and results and may stop it.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "calibration/hooks.hpp"

namespace tubeplan::app {

/// Printed text and results of a command that another program calls, and the hooks of its work.
struct CommandCaller {
  calibration::WorkHooks hooks;
  std::string output;      ///< text that the command prints on standard output
  std::string remarks;     ///< text that the command prints on standard error
  nlohmann::json figures;  ///< results, as --json writes them; null if the command has none
};

/// Scope in which commands of the calling thread have a caller other than the terminal.
class CalledBy {
 public:
  explicit CalledBy(CommandCaller& caller);
  ~CalledBy();
  CalledBy(const CalledBy&) = delete;
  CalledBy& operator=(const CalledBy&) = delete;

  /// Returns the caller of the calling thread's command; null if it is the terminal.
  [[nodiscard]] static CommandCaller* current();

 private:
  CommandCaller* before_;
};

/// Writes text to the terminal's standard output or, for another caller, to `output`.
void writeOutput(std::string_view text);

/// Writes text to the terminal's standard error or, for another caller, to `remarks`.
void writeRemark(std::string_view text);

/// Formats text as fmt::print() does and gives it to the caller.
template <class... Args>
void output(fmt::format_string<Args...> format, Args&&... args) {
  writeOutput(fmt::format(format, std::forward<Args>(args)...));
}

/// Formats a remark as fmt::print() does and gives it to the caller.
template <class... Args>
void remark(fmt::format_string<Args...> format, Args&&... args) {
  writeRemark(fmt::format(format, std::forward<Args>(args)...));
}

/// Returns the condition on which work of the calling thread's command stops: a signal to the program, or the caller's
/// request. The returned function may be called from any thread.
[[nodiscard]] std::function<bool()> stopCondition();

}  // namespace tubeplan::app
