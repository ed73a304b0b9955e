// Where the figures of a command go: --json, a file or standard output, and --format, what else stands there.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace tubeplan::app {

struct FiguresTarget {
  std::string json;             ///< a file, - for standard output; empty: none is wanted
  std::string format = "text";  ///< of standard output, one of figureFormats()
};

[[nodiscard]] std::vector<std::string> figureFormats();

/// Checks, before the work, that --json can be written and that one document alone is for standard output. Throws
/// InputError.
void checkFigures(const FiguresTarget& target);

/// Writes what was asked for, NaN and infinity as null; nothing where that is the text for people.
void writeFigures(const FiguresTarget& target, nlohmann::json figures);

/// Whether standard output is for that text.
[[nodiscard]] bool printsText(const FiguresTarget& target);

/// Writes the figures, or prints the text.
void showFigures(const FiguresTarget& target, nlohmann::json figures, const std::string& text);

}  // namespace tubeplan::app
