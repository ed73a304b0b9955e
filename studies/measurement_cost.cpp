// Study of the cost of an identification as a function of the number of measurements: six stiffnesses and the base are
// identified from positions. The output lists processor and wall times and the slope of log time against the log of the
// number of measurements.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <ctime>

#include "calibration/estimation/identification.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

const std::vector<std::string> kFree{
    "tool.joint_stiffness.z", "forearm.joint_stiffness.z",        "latch-link.beam.Iz",
    "mezzanine-beam.beam.Iz", "mezzanine-beam.joint_stiffness.z", "mezzanine-platform.joint_stiffness.x"};

struct Cost {
  double processor = 0, wall = 0;  // times [s]
  int iterations = 0, evaluations = 0;
  bool converged = false;
};

Cost costOf(int measurements) {
  PlacedArm placed = cobra();
  placed.base_poses[0].is_known = false;
  MeasurementMaker maker(placed, 1, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, measurements);
  placed.arm.rows[5].joint_stiffness.z() *= 2;
  IdentificationOptions options;
  options.free.names = kFree;
  options.folds = 0;
  options.intervals_by_profile = false;
  const std::clock_t processor = std::clock();
  const auto wall = std::chrono::steady_clock::now();
  const auto result = identify(placed, maker.measurements, options);
  Cost cost;
  cost.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
  cost.processor = static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
  cost.iterations = result.iterations;
  cost.evaluations = result.evaluations;
  cost.converged = result.status == IdentificationStatus::kDone;
  return cost;
}

}  // namespace
}  // namespace tubeplan::calibration

int main(int argc, char** argv) {
  using tubeplan::calibration::Cost;
  CLI::App cli{"Seconds of an identification with growing numbers of readings"};
  int most = 30000;
  cli.add_option("--most", most, "largest number of readings");
  CLI11_PARSE(cli, argc, argv);
  double before = 0;
  fmt::print("{:>8} {:>12} {:>10} {:>11} {:>12} {:>6}\n", "readings", "processor s", "wall s", "iterations",
             "evaluations", "slope");
  for (int measurements = 30; measurements <= most; measurements *= 10) {
    const Cost cost = tubeplan::calibration::costOf(measurements);
    fmt::print("{:>8} {:>12.3f} {:>10.3f} {:>11} {:>12} {:>6}{}\n", measurements, cost.processor, cost.wall,
               cost.iterations, cost.evaluations,
               before > 0 ? fmt::format("{:.2f}", std::log10(cost.processor / before)) : "",
               cost.converged ? "" : "  not converged");
    std::fflush(stdout);
    before = cost.processor;
  }
  return 0;
}
