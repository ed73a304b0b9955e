// Whole text files, refused where they cannot be what a reader wants.
#pragma once

#include <string>
#include <string_view>

#include "tubesheets/problem.hpp"

namespace tubeplan::app {

/// The file's text without a byte order mark. Throws InputError for a file that is missing, a folder, unreadable,
/// larger than 64 MB, empty (blanks only) or no text (control characters, bytes that are not UTF-8).
[[nodiscard]] std::string readTextFile(const std::string& path);

/// Returns the text of a file with its byte order mark, for a text that is written again with some of it changed.
[[nodiscard]] std::string readTextBytes(const std::string& path);

/// The same of a file that the program itself keeps: no input of a result (origin.hpp).
[[nodiscard]] std::string readKeptFile(const std::string& path);

/// What readTextFile asks of a file's text, of text that comes another way. `path` is its name for messages.
void checkText(const std::string& path, std::string_view text);

/// Throws InputError for a problem of that file's text, with its line.
[[noreturn]] void refuseText(const std::string& path, const tubesheets::Problem& problem);

}  // namespace tubeplan::app
