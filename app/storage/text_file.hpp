// Reader of whole text files, with checks of size and encoding.
#pragma once

#include <string>
#include <string_view>

#include "tubesheets/problem.hpp"

namespace tubeplan::app {

/// Returns the text of a file without a byte order mark. Throws InputError if the file is missing, a folder,
/// unreadable, larger than 64 MB, blank, or not text (control characters, or bytes that are not UTF-8).
[[nodiscard]] std::string readTextFile(const std::string& path);

/// Returns the text of a file including a byte order mark, for a file that is written back with changes. Throws
/// InputError as readTextFile() does.
[[nodiscard]] std::string readTextBytes(const std::string& path);

/// Returns the text of one of the program's own files, which is not recorded as an input of the result (origin.hpp).
/// Throws InputError as readTextFile() does.
[[nodiscard]] std::string readKeptFile(const std::string& path);

/// Throws InputError if the text is blank or not text, as defined for readTextFile(). The text need not come from a
/// file; `path` is its name in messages.
void checkText(const std::string& path, std::string_view text);

/// Throws InputError for a problem in the text of the file `path`, with the line of the problem.
[[noreturn]] void refuseText(const std::string& path, const tubesheets::Problem& problem);

}  // namespace tubeplan::app
