// Display of pages to the user.
#pragma once

#include <string>

namespace tubeplan::app {

/// Passes an address or a file to the desktop's program for it (xdg-open, or the one named by BROWSER), and does not
/// wait for it. If there is none, says so on standard error.
void openInBrowser(std::string place);

}  // namespace tubeplan::app
