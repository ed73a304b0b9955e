// Options that several commands share.
#pragma once

#include <CLI/CLI.hpp>

#include "app/reading_input.hpp"

namespace tubeplan::app {

/// --sigma and --prior, of every command that fits a model to readings.
void addMeasurementOptions(CLI::App& cli, MeasurementOptions& options);

}  // namespace tubeplan::app
