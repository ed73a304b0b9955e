// Options of `tubeplan campaign` that belong to some kinds of campaigns only.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/commands/campaign/campaign.hpp"

namespace tubeplan::app {

/// Adds the options of all kinds of campaigns, in groups by kind.
void addKindOptions(CLI::App& cli, CampaignRequest& request);

/// Throws InputError for an option of other kinds of campaigns, because the option would have no effect.
void requireOptionsOf(const CLI::App& cli, const std::string& kind);

/// Throws InputError unless `--nothing` is a fraction.
void requireFractionOfNothing(const CampaignRequest& request);

}  // namespace tubeplan::app
