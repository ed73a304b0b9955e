// Printing of HTML pages to PDF by headless Chromium, if it is installed.
#pragma once

#include <filesystem>

namespace tubeplan::app {

/// Prints the HTML file `page` to the file `pdf`. Throws InputError, naming --pdf, if there is no Chromium or printing
/// takes more than a minute.
void printPage(const std::filesystem::path& page, const std::filesystem::path& pdf);

/// Throws InputError if no Chromium is installed. Call it before long work.
void requirePrinter();

}  // namespace tubeplan::app
