// The workbench, fuzzed from three sides: its routes, its HTTP door, its lines of text.
#pragma once

#include <string>

namespace tubeplan::app {

/// The routes alone. "POST pose" or "GET leverage?at=theta3" in the first line, the body after it: JSON where that
/// begins with a brace, else CSV.
void callWorkbench(const std::string& text);

/// Bytes sent to a running server; "PORT" in them stands for its port.
void knockAtDoor(const std::string& text);

/// Bytes sent to where controllers send lines.
void sendLines(const std::string& text);

}  // namespace tubeplan::app
