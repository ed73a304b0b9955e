// Commands of the program, called from Python.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace tubeplan::app {

/// Runs the command with these words of a command line, without the program's name. Returns its exit code, the text
/// that it prints, its remarks, and its figures as JSON (None if it has none): in SI units if `are_si`, else in the
/// units of the file. `file` is the cell that names the joints of the figures, or empty. Throws InputError, and
/// Python's KeyboardInterrupt or the exception of `progress` that stopped the work.
[[nodiscard]] pybind11::tuple callCommand(const std::vector<std::string>& words, const std::string& file, bool are_si,
                                          const pybind11::object& progress);

/// Runs the command for the terminal and returns its exit code.
[[nodiscard]] int callForTerminal(const std::vector<std::string>& words);

/// Returns the table of commands as JSON: names, summaries, examples and options.
[[nodiscard]] std::string commandsJson();

/// Returns the units of a cell or of the record of a job as JSON: the SI value of each unit, and for each joint
/// `length` or `angle`. Throws InputError for any other file.
[[nodiscard]] std::string unitsOfFile(const std::string& path);

/// Returns all values of a document as JSON: `list`, `row`, `column`, `description`, `value`, `unit`, `note`.
[[nodiscard]] std::string figureListJson(const std::string& document);

}  // namespace tubeplan::app
