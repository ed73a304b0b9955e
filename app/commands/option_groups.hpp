// Declarations of options that several commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "app/commands/figures_target.hpp"
#include "app/formats/measurements/measurement_input.hpp"

namespace tubeplan::app {

void addCell(CLI::App& cli, std::string& cell);
void addMeasurements(CLI::App& cli, MeasurementFiles& files);  ///< MEASUREMENTS: one or more files
void addFigures(CLI::App& cli, FiguresTarget& target);         ///< --json and --format

/// Adds --seed; `of` is its help text, which names the random quantities.
void addSeed(CLI::App& cli, std::uint64_t& seed, const std::string& of);

/// Adds --sigma (above zero): the standard deviation of a coordinate in the cell's length unit. The help text ends with
/// `when`, which states when the option applies.
void addSigma(CLI::App& cli, double& sigma, const std::string& when);

/// Adds --sigma, --prior and --assume, for commands that fit a model to measurements.
void addMeasurementOptions(CLI::App& cli, MeasurementOptions& options);

/// Adds --assume alone, for commands to which measurements are a secondary input.
void addAssumeOption(CLI::App& cli, std::vector<std::string>& assume);

/// Adds --column, the meanings of a work list's columns, for commands whose --tubes may name a work list
/// (app/formats/cell/command_inputs.cpp).
CLI::Option* addListColumns(CLI::App& cli, std::vector<std::string>& columns);

/// Destination of the results page: --report FILE, and --open to show it in a browser.
struct ReportTarget {
  std::string file;  ///< file name; empty if there is no page
  bool open = false;

  [[nodiscard]] bool isWanted() const { return !file.empty(); }
};

/// Adds --report and --open; `words` describe the page for --help.
void addReportOptions(CLI::App& cli, ReportTarget& target, const std::string& words);

/// Throws InputError if the page cannot be written. Call it before long work.
void checkReportTarget(const ReportTarget& target);

/// Writes the page and, with --open, opens it in a browser.
void writeReport(const ReportTarget& target, const std::string& page);

}  // namespace tubeplan::app
