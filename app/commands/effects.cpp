// `tubeplan effects`: lists the physical effects that a cell's arm can have, and where each can act.
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/command.hpp"
#include "app/commands/option_groups.hpp"
#include "app/documents/effect_catalogue.hpp"
#include "app/documents/figures.hpp"
#include "app/formats/cell/cell_reader.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/named_entry.hpp"
#include "deflection/effects/effect.hpp"

namespace tubeplan::app {

namespace {

struct EffectsOptions {
  std::string cell, effect;
  FiguresTarget figures;
};

void requireEffect(const deflection::Arm& arm, const std::string& name) {
  const auto made = deflection::makeEffect(arm, name, "");
  if (name.empty() || made.status != deflection::EffectStatus::kUnknownEffect) return;
  throw unknownName("EFFECT", name, made.known);
}

int run(const EffectsOptions& options) {
  const Cell cell = readCell(options.cell);
  requireEffect(cell.arm, options.effect);
  checkFigures(options.figures);
  showFigures(options.figures, catalogueJson(cell), catalogueText(cell, options.effect));
  return kDone;
}

}  // namespace

Run configureEffects(CLI::App& cli) {
  const auto options = std::make_shared<EffectsOptions>();
  addCell(cli, options->cell);
  cli.add_option("EFFECT", options->effect, "this one only");
  addFigures(cli, options->figures);
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
