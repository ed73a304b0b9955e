#include "app/commands/campaign/campaign_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "app/commands/option_groups.hpp"
#include "app/storage/input_error.hpp"
#include "app/studies/monte_carlo/centring_trial.hpp"
#include "calibration/simulation/hidden_changes.hpp"

namespace tubeplan::app {

namespace {

using Kinds = std::span<const std::string_view>;

constexpr std::array<std::string_view, 1> kCentring{"centre"}, kDiagnosing{"diagnose"}, kOutages{"outage"};
constexpr std::array<std::string_view, 2> kTouching{"centre", "outage"}, kHiding{"diagnose", "outage"};
constexpr std::array<Kinds, 5> kOptionGroups{kCentring, kTouching, kHiding, kDiagnosing, kOutages};

/// Returns the heading of the options that belong to these kinds.
std::string groupOf(Kinds kinds) {
  return fmt::format("Of kind {}, in the cell's units", fmt::join(kinds, " and of kind "));
}

std::string choiceHelp() {
  std::string text = "how the touched holes are chosen, one or more of these:";
  for (const auto& row : touchRules()) text += fmt::format("\n{}: {}", row.name, row.summary);
  return text;
}

void configureTouching(CLI::App& cli, CampaignRequest& request) {
  const std::string group = groupOf(kTouching);
  cli.add_option("--truth", request.truth, "the cell about which true arms are drawn (default: CELL)")->group(group);
  cli.add_option("--tubes", request.tubes,
                 "the tubes whose holes may be visited, as for plan (spread:80, and of kind outage "
                 "spread:300)")
      ->group(group);
  addListColumns(cli, request.columns)->group(group);
  cli.add_option("--touches", request.touches,
                 "number of touched holes; a list compares several (of kind centre): 3,4,6,12")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->group(group);
  cli.add_option("--choice", request.choices, choiceHelp())->delimiter(',')->allow_extra_args(false)->group(group);
  cli.add_option("--touch-sigma", request.touch_sigmas,
                 "standard deviation of each coordinate of a touch; a list compares several. Default: half the radial "
                 "clearance of the last step")
      ->type_name("LENGTH")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->group(group);
  cli.add_option("--base-shift", request.base_shift,
                 "standard deviation of the true base's position, per coordinate (0.5 in)")
      ->type_name("LENGTH")
      ->group(group);
  cli.add_option("--base-turn", request.base_turn, "standard deviation of the true base's rotation, per axis (0.5 deg)")
      ->type_name("ANGLE")
      ->group(group);
  cli.add_option("--stiffness", request.stiffness, "relative standard deviation of the true arm's stiffnesses (0.02)")
      ->group(group);
  cli.add_option("--unmodelled", request.unmodelled,
                 "standard deviation of the true arm's unmodelled error, per coordinate (0.0197 in; of kind outage: "
                 "the cell's model error)")
      ->type_name("LENGTH")
      ->group(group);
  cli.add_option("--encoder-sigma", request.encoder_sigma, "encoder noise of a joint (default: that of the arm file)")
      ->type_name("ANGLE")
      ->group(group);
}

void configureCentring(CLI::App& cli, CampaignRequest& request) {
  cli.add_option("--holes", request.holes, "number of these holes that each run visits")
      ->capture_default_str()
      ->group(groupOf(kCentring));
}

void configureDiagnosis(CLI::App& cli, CampaignRequest& request) {
  const std::string group = groupOf(kDiagnosing);
  cli.add_option("--design", request.design, "the design of the readings, as for simulate")
      ->capture_default_str()
      ->group(group);
  cli.add_option("--readings", request.measurements, "readings of each run")->capture_default_str()->group(group);
  cli.add_option("--effects", request.effects, "largest number of effects in one explanation")
      ->capture_default_str()
      ->group(group);
}

std::string hideHelp() {
  std::string text =
      "effect (of kind diagnose) or change (of kind outage) hidden in the other runs, any: a random one. Changes:";
  for (const auto& row : calibration::hiddenChanges().subspan(1)) text += fmt::format("\n{}: {}", row.name, row.words);
  return text;
}

void configureHiding(CLI::App& cli, CampaignRequest& request) {
  const std::string group = groupOf(kHiding);
  cli.add_option("--nothing", request.nothing, "fraction of the runs in which nothing is hidden")
      ->capture_default_str()
      ->group(group);
  cli.add_option("--hide", request.hide, hideHelp())->capture_default_str()->group(group);
}

void configureOutages(CLI::App& cli, CampaignRequest& request) {
  const std::string group = groupOf(kOutages);
  cli.add_option("--visits", request.visits, "number of these tubes that each run visits")
      ->capture_default_str()
      ->group(group);
  cli.add_option("--touch-every", request.touch_every,
                 "every so many visits, the hole is touched and not only its steps counted; 0: never")
      ->capture_default_str()
      ->group(group);
}

}  // namespace

void addKindOptions(CLI::App& cli, CampaignRequest& request) {
  configureTouching(cli, request);
  configureCentring(cli, request);
  configureHiding(cli, request);
  configureDiagnosis(cli, request);
  configureOutages(cli, request);
}

void requireOptionsOf(const CLI::App& cli, const std::string& kind) {
  for (const Kinds kinds : kOptionGroups) {
    if (std::ranges::find(kinds, kind) != kinds.end()) continue;
    for (const auto* option :
         cli.get_options([&](const auto* candidate) { return candidate->get_group() == groupOf(kinds); }))
      if (option->count() > 0)
        throw InputError::problem(
            option->get_name(),
            fmt::format("this option is for campaigns of kind {}, not of kind {}", fmt::join(kinds, " or "), kind),
            fmt::format("add --kind {}, or leave it out", kinds.front()));
  }
}

void requireFractionOfNothing(const CampaignRequest& request) {
  if (!(request.nothing >= 0 && request.nothing <= 1))
    throw InputError("--nothing", fmt::format("{}", request.nothing), "a fraction from 0 to 1");
}

}  // namespace tubeplan::app
