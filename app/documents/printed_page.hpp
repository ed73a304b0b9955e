// A page printed to PDF by headless Chromium, where it is installed.
#pragma once

#include <filesystem>

namespace tubeplan::app {

/// Throws InputError, naming --pdf, where there is no Chromium, or where it does not print within a minute.
void printPage(const std::filesystem::path& page, const std::filesystem::path& pdf);

/// For use before long work: throws where there is no Chromium.
void requirePrinter();

}  // namespace tubeplan::app
