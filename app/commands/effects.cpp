// tubeplan effects: the physical effects that a cell's arm can have, and where.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/command.hpp"
#include "app/cli/json_target.hpp"
#include "app/commands/option_groups.hpp"
#include "app/documents/effect_catalogue.hpp"
#include "app/documents/figures.hpp"
#include "app/files/cell_reader.hpp"
#include "app/files/input_error.hpp"
#include "app/files/suggestion.hpp"
#include "deflection/effects/effect.hpp"

namespace tubeplan::app {

namespace {

struct EffectsOptions {
  std::string cell, effect, json;
};

void requireEffect(const deflection::Arm& arm, const std::string& name) {
  const auto made = deflection::makeEffect(arm, name, "");
  if (name.empty() || made.status != deflection::EffectStatus::kUnknownEffect) return;
  throw InputError("EFFECT", inQuotes(name), alternatives(made.known), suggestion(name, made.known));
}

int run(const EffectsOptions& options) {
  const Cell cell = readCell(options.cell);
  requireEffect(cell.arm, options.effect);
  checkJsonTarget(options.json);
  writeJson(options.json, catalogueJson(cell));
  if (printsText(options.json)) fmt::print("{}", catalogueText(cell, options.effect));
  return kDone;
}

}  // namespace

Run configureEffects(CLI::App& cli) {
  const auto options = std::make_shared<EffectsOptions>();
  addCell(cli, options->cell);
  cli.add_option("EFFECT", options->effect, "this one only");
  cli.add_option("--json", options->json, "write all as JSON to this file, or - for standard output");
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
