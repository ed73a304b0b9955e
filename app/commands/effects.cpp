// tubeplan effects: the physical effects that a cell's arm can have, and where.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/command.hpp"
#include "app/command_inputs.hpp"
#include "app/effect_catalogue.hpp"
#include "app/figures.hpp"
#include "app/input_error.hpp"
#include "app/readers/cell_reader.hpp"
#include "app/suggestion.hpp"
#include "deflection/effects/effect.hpp"

namespace tubeplan::app {

namespace {

struct EffectsOptions {
  std::string cell, effect, json;
};

void requireEffect(const std::string& name) {
  if (name.empty() || deflection::findEffectKind(name)) return;
  std::vector<std::string> names;
  for (const auto& kind : deflection::effectKinds()) names.emplace_back(kind.name);
  throw InputError("EFFECT", inQuotes(name), alternatives(names), suggestion(name, names));
}

int run(const EffectsOptions& options) {
  requireEffect(options.effect);
  const Cell cell = readCell(options.cell);
  checkJsonTarget(options.json);
  writeJson(options.json, catalogueJson(cell));
  if (printsText(options.json)) fmt::print("{}", catalogueText(cell, options.effect));
  return kDone;
}

}  // namespace

Run configureEffects(CLI::App& cli) {
  const auto options = std::make_shared<EffectsOptions>();
  cli.add_option("CELL", options->cell, "the cell file")->required();
  cli.add_option("EFFECT", options->effect, "this one only");
  cli.add_option("--json", options->json, "write all as JSON to this file, or - for standard output");
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
