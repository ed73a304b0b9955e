#include "app/commands/option_groups.hpp"

#include "app/files/assumptions.hpp"

namespace tubeplan::app {

void addMeasurementOptions(CLI::App& cli, MeasurementOptions& options) {
  cli.add_option("--sigma", options.sigma,
                 "noise of a coordinate where the file states none, in the cell's length unit");
  cli.add_option(
         "--prior", options.priors,
         "NAME=SIGMA, in the cell's units: how well the arm's file is known beforehand; of `length` and `angle` of "
         "the geometry (0.005 m, 0.02 rad), of the `tip` (0.05 m), or of a number by its path; none: not at all")
      ->delimiter(',');
  addAssumeOption(cli, options.assume);
}

void addAssumeOption(CLI::App& cli, std::vector<std::string>& assume) {
  cli.add_option("--assume", assume,
                 "NAME=VALUE: take the readings so, their file left as it is: " + assumptionsText() +
                     "; as-is: go on whatever looks wrong")
      ->delimiter(',')
      ->allow_extra_args(false);
}

}  // namespace tubeplan::app
