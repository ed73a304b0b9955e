#include "app/commands/figures_target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/caller.hpp"
#include "app/documents/figure_list.hpp"
#include "app/storage/atomic_file.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/origin.hpp"

namespace tubeplan::app {

namespace {

struct OutputFormat {
  std::string_view name;
  /// Function that formats the results; null if the command prints its own text.
  std::string (*write)(const nlohmann::json& figures);
};

std::string jsonText(const nlohmann::json& figures) { return figures.dump(2) + "\n"; }

constexpr OutputFormat kFormats[] = {
    {"text", nullptr}, {"json", jsonText}, {"csv", figuresCsv}, {"markdown", figuresMarkdown}};

/// Returns the format of standard output; `--json -` is equivalent to `--format json`.
const OutputFormat& formatOf(const FiguresTarget& target) {
  const std::string name = target.json == "-" ? "json" : target.format;
  return *std::ranges::find(kFormats, name, &OutputFormat::name);
}

}  // namespace

std::vector<std::string> figureFormats() {
  std::vector<std::string> names;
  for (const auto& format : kFormats) names.emplace_back(format.name);
  return names;
}

void checkFigures(const FiguresTarget& target) {
  if (target.json == "-" && target.format != "text" && target.format != "json")
    throw InputError::problem(
        "--format", fmt::format("{} and the JSON of `--json -` cannot both go to standard output", target.format),
        "give --json a file, or leave one of them out");
  if (!target.json.empty() && target.json != "-") checkWritableFile(target.json, "--json");
}

bool printsText(const FiguresTarget& target) { return !formatOf(target).write; }

bool wantsFigures(const FiguresTarget& target) {
  return !target.json.empty() || !printsText(target) || CalledBy::current();
}

void writeFigures(const FiguresTarget& target, const nlohmann::json& figures) {
  if (!wantsFigures(target)) return;
  nlohmann::json stated = figures;
  stateOrigin(stated);
  if (auto* caller = CalledBy::current()) caller->figures = stated;
  if (!target.json.empty() && target.json != "-") writeFileAtomically(target.json, jsonText(stated), "--json");
  if (!printsText(target)) output("{}", formatOf(target).write(stated));
}

void showFigures(const FiguresTarget& target, const nlohmann::json& figures, const std::string& text) {
  writeFigures(target, figures);
  if (printsText(target)) output("{}", text);
}

}  // namespace tubeplan::app
