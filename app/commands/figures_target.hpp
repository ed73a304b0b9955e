// Destination of a command's figures: --json, a file or standard output, and --format, the form on standard output.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace tubeplan::app {

struct FiguresTarget {
  std::string json;             ///< file, - for standard output; empty: not written
  std::string format = "text";  ///< form on standard output, one of figureFormats()
};

[[nodiscard]] std::vector<std::string> figureFormats();

/// Checks before the work that --json can be written and that only one document is for standard output. Throws
/// InputError.
void checkFigures(const FiguresTarget& target);

/// Returns true if the figures are for a file or for standard output; else only the text is requested.
[[nodiscard]] bool wantsFigures(const FiguresTarget& target);

/// Writes the figures to their destinations, NaN and infinity as null; does nothing if only the text is requested.
void writeFigures(const FiguresTarget& target, const nlohmann::json& figures);

/// Returns true if standard output is for the text.
[[nodiscard]] bool printsText(const FiguresTarget& target);

/// Writes the figures, or prints the text.
void showFigures(const FiguresTarget& target, const nlohmann::json& figures, const std::string& text);

}  // namespace tubeplan::app
