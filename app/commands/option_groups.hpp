// Options that several commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "app/commands/figures_target.hpp"
#include "app/formats/measurements/reading_input.hpp"

namespace tubeplan::app {

void addCell(CLI::App& cli, std::string& cell);
void addReadings(CLI::App& cli, ReadingFiles& files);   ///< MEASUREMENTS, one or several files
void addFigures(CLI::App& cli, FiguresTarget& target);  ///< --json and --format

/// --seed; `of`: what it is the seed of, for --help.
void addSeed(CLI::App& cli, std::uint64_t& seed, const std::string& of);

/// --sigma above zero, a standard deviation of a coordinate in the cell's unit of length; `when`: where it counts.
void addSigma(CLI::App& cli, double& sigma, const std::string& when);

/// --sigma, --prior and --assume, of every command that fits a model to readings.
void addMeasurementOptions(CLI::App& cli, MeasurementOptions& options);

/// --assume alone, of commands that take readings beside their own question.
void addAssumeOption(CLI::App& cli, std::vector<std::string>& assume);

/// --column, of every command whose --tubes may be a work list: what its columns are
/// (app/formats/cell/command_inputs.cpp).
CLI::Option* addListColumns(CLI::App& cli, std::vector<std::string>& columns);

/// A page about what was found: --report FILE, and --open.
struct ReportTarget {
  std::string file;  ///< empty: none is wanted
  bool open = false;

  [[nodiscard]] bool isWanted() const { return !file.empty(); }
};

/// `words`: what the page shows, for --help.
void addReportOptions(CLI::App& cli, ReportTarget& target, const std::string& words);

/// Before the work: whether it can be written. Throws InputError.
void checkReportTarget(const ReportTarget& target);

/// Writes the page, and opens it in a browser where that was asked for.
void writeReport(const ReportTarget& target, const std::string& page);

}  // namespace tubeplan::app
