// Whole text files, refused where they cannot be what a reader wants.
#pragma once

#include <string>

namespace tubeplan::app {

/// The file's text without a byte order mark. Throws InputError for a file that is missing, a folder, unreadable,
/// larger than 64 MB, empty (blanks only) or no text (control characters, bytes that are not UTF-8).
[[nodiscard]] std::string readTextFile(const std::string& path);

}  // namespace tubeplan::app
