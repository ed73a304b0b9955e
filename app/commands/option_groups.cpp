#include "app/commands/option_groups.hpp"

#include <filesystem>

#include "app/cli/browser.hpp"
#include "app/commands/option_checks.hpp"
#include "app/formats/measurements/assumptions.hpp"
#include "app/storage/atomic_file.hpp"
#include "app/storage/suggestion.hpp"
#include "tubesheets/tube_columns.hpp"

namespace tubeplan::app {

void addCell(CLI::App& cli, std::string& cell) { cli.add_option("CELL", cell, "the cell file")->required(); }

void addMeasurements(CLI::App& cli, MeasurementFiles& files) {
  cli.add_option("MEASUREMENTS", files, "readings of any kind (CSV), taken together")->required();
}

void addSeed(CLI::App& cli, std::uint64_t& seed, const std::string& of) {
  cli.add_option("--seed", seed, of)->check(seedNumber())->capture_default_str();
}

void addFigures(CLI::App& cli, FiguresTarget& target) {
  cli.add_option("--json", target.json, "write the figures as JSON to this file, or - for standard output");
  cli.add_option("--format", target.format, "format of standard output: text, or the figures as json, csv or markdown")
      ->check(oneOf(figureFormats()))
      ->capture_default_str();
}

void addSigma(CLI::App& cli, double& sigma, const std::string& when) {
  cli.add_option("--sigma", sigma, "standard deviation of a coordinate, in the cell's unit of length, " + when)
      ->type_name("LENGTH")
      ->check(lengthAboveZero());
}

void addMeasurementOptions(CLI::App& cli, MeasurementOptions& options) {
  addSigma(cli, options.sigma, "if the file states none");
  cli.add_option(
         "--prior", options.priors,
         "NAME=SIGMA, in the cell's units: prior standard deviation of the arm file's values; of `length` and `angle` "
         "of the geometry (0.005 m, 0.02 rad), of the `tip` (0.05 m), or of a parameter by its path; none: no prior")
      ->delimiter(',');
  addAssumeOption(cli, options.assume);
}

void addAssumeOption(CLI::App& cli, std::vector<std::string>& assume) {
  cli.add_option("--assume", assume,
                 "NAME=VALUE: correction of the readings, which does not change their file: " + assumptionsText() +
                     "; as-is: continue despite all warnings")
      ->delimiter(',')
      ->allow_extra_args(false);
}

CLI::Option* addListColumns(CLI::App& cli, std::vector<std::string>& columns) {
  std::vector<std::string> names;
  for (const auto& quantity : tubesheets::tubeQuantities()) {
    names.emplace_back(quantity.name);
    if (!quantity.units.empty()) names.back().append("_").append(quantity.units.front());
  }
  return cli
      .add_option("--column", columns,
                  "NAME=COLUMN: meaning of a column of the work list, whatever its heading; columns that are not named "
                  "are then ignored. NAME: " +
                      alternatives(names))
      ->allow_extra_args(false);
}

void addReportOptions(CLI::App& cli, ReportTarget& target, const std::string& words) {
  auto* report = cli.add_option("--report", target.file, words);
  cli.add_flag("--open", target.open, "open the report in a browser")->needs(report);
}

void checkReportTarget(const ReportTarget& target) {
  if (target.isWanted()) checkWritableFile(target.file, "--report");
}

void writeReport(const ReportTarget& target, const std::string& page) {
  writeFileAtomically(target.file, page, "--report");
  if (target.open) openInBrowser(std::filesystem::absolute(target.file).string());
}

}  // namespace tubeplan::app
