// Opening of pages in the user's browser.
#pragma once

#include <string>

namespace tubeplan::app {

/// Opens an address or a file with the program named by the environment variable BROWSER, or else with xdg-open, and
/// returns without waiting. If that program cannot be started, prints a message on standard error.
void openInBrowser(std::string place);

}  // namespace tubeplan::app
