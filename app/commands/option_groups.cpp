#include "app/commands/option_groups.hpp"

#include "app/files/assumptions.hpp"

namespace tubeplan::app {

void addCell(CLI::App& cli, std::string& cell) { cli.add_option("CELL", cell, "the cell file")->required(); }

void addReadings(CLI::App& cli, ReadingFiles& files) {
  cli.add_option("MEASUREMENTS", files, "readings of any kind (CSV), taken together")->required();
}

void addJson(CLI::App& cli, std::string& json) {
  cli.add_option("--json", json, "write the figures as JSON to this file, or - for standard output");
}

void addMeasurementOptions(CLI::App& cli, MeasurementOptions& options) {
  cli.add_option("--sigma", options.sigma,
                 "standard deviation of a coordinate where the file states none, in the cell's length unit");
  cli.add_option(
         "--prior", options.priors,
         "NAME=SIGMA, in the cell's units: prior standard deviation of the arm file's values; of `length` and `angle` "
         "of the geometry (0.005 m, 0.02 rad), of the `tip` (0.05 m), or of a parameter by its path; none: no prior")
      ->delimiter(',');
  addAssumeOption(cli, options.assume);
}

void addAssumeOption(CLI::App& cli, std::vector<std::string>& assume) {
  cli.add_option("--assume", assume,
                 "NAME=VALUE: interpret the readings so, without changing their file: " + assumptionsText() +
                     "; as-is: continue despite all warnings")
      ->delimiter(',')
      ->allow_extra_args(false);
}

}  // namespace tubeplan::app
