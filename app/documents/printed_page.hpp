// Printing of a page to PDF by headless Chromium, if installed.
#pragma once

#include <filesystem>

namespace tubeplan::app {

/// Prints a page. Throws InputError, naming --pdf, if there is no Chromium, or if it does not print within a minute.
void printPage(const std::filesystem::path& page, const std::filesystem::path& pdf);

/// Checks before long work that a page can be printed. Throws InputError if there is no Chromium.
void requirePrinter();

}  // namespace tubeplan::app
