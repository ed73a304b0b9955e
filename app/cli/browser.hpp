// Pages shown to the user.
#pragma once

#include <string>

namespace tubeplan::app {

/// Hands an address or a file to the program that the desktop opens such with (xdg-open, or what BROWSER names), and
/// does not wait for it; where there is none, says so on standard error.
void openInBrowser(std::string place);

}  // namespace tubeplan::app
