// Destination of a command's results: --json writes to a file or to standard output, and --format selects the format of
// standard output.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace tubeplan::app {

struct FiguresTarget {
  std::string json;             ///< file name, or "-" for standard output; if empty, no JSON is written
  std::string format = "text";  ///< format of standard output, one of figureFormats()
};

[[nodiscard]] std::vector<std::string> figureFormats();

/// Throws InputError unless the --json file can be written and only one document goes to standard output. Call it
/// before long work.
void checkFigures(const FiguresTarget& target);

/// Returns true if the results go to a file, to another calling program or, in a format other than text, to standard
/// output.
[[nodiscard]] bool wantsFigures(const FiguresTarget& target);

/// Writes the results to all requested destinations, with NaN and infinity as null. Does nothing if only the text is
/// requested.
void writeFigures(const FiguresTarget& target, const nlohmann::json& figures);

/// Returns true if the command's own text goes to standard output.
[[nodiscard]] bool printsText(const FiguresTarget& target);

/// Writes the results to all requested destinations, and prints `text` if printsText().
void showFigures(const FiguresTarget& target, const nlohmann::json& figures, const std::string& text);

}  // namespace tubeplan::app
