// Complete text files, checked for size and encoding.
#pragma once

#include <string>
#include <string_view>

#include "tubesheets/problem.hpp"

namespace tubeplan::app {

/// Returns the file's text without a byte order mark. Throws InputError for a file that is missing, a folder,
/// unreadable, larger than 64 MB, empty (blanks only) or no text (control characters, bytes that are not UTF-8).
[[nodiscard]] std::string readTextFile(const std::string& path);

/// Returns the text of a file with its byte order mark, for text that is written again with some changes. Throws
/// InputError as readTextFile() does.
[[nodiscard]] std::string readTextBytes(const std::string& path);

/// Returns the text of a file of the program's own, which is no input of a result (origin.hpp). Throws InputError as
/// readTextFile() does.
[[nodiscard]] std::string readKeptFile(const std::string& path);

/// Throws InputError unless the text meets the conditions of readTextFile(), for text from another source. `path` is
/// its name in messages.
void checkText(const std::string& path, std::string_view text);

/// Throws InputError for a problem of that file's text, with its line.
[[noreturn]] void refuseText(const std::string& path, const tubesheets::Problem& problem);

}  // namespace tubeplan::app
