// Options that several commands share.
#pragma once

#include <CLI/CLI.hpp>

#include "app/files/reading_input.hpp"

namespace tubeplan::app {

void addCell(CLI::App& cli, std::string& cell);
void addReadings(CLI::App& cli, ReadingFiles& files);  ///< MEASUREMENTS, one or several files
void addJson(CLI::App& cli, std::string& json);

/// --sigma, --prior and --assume, of every command that fits a model to readings.
void addMeasurementOptions(CLI::App& cli, MeasurementOptions& options);

/// --assume alone, of commands that take readings beside their own question.
void addAssumeOption(CLI::App& cli, std::vector<std::string>& assume);

}  // namespace tubeplan::app
