// How many random motions called free are refuted by fine steps, scene by scene. None should be.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "tests/planner/adversarial_motions.hpp"

int main(int argc, char** argv) {
  using namespace tubeplan::planner::testing;
  CLI::App cli{"Motions called free against fine steps"};
  int motions = 10000, samples = 10000;
  cli.add_option("--motions", motions, "of each scene");
  cli.add_option("--samples", samples, "of each motion called free");
  CLI11_PARSE(cli, argc, argv);
  fmt::print("{:>6} {:>8} {:>8} {:>8} {:>8}\n", "scene", "motions", "free", "blocked", "refuted");
  int refuted = 0;
  for (int scene = 0; scene < kAdversarialScenes; ++scene) {
    const MotionTally tally = tallyMotions(scene, 1, motions, samples);
    fmt::print("{:>6} {:>8} {:>8} {:>8} {:>8}\n", scene, motions, tally.free, tally.blocked, tally.refuted);
    refuted += tally.refuted;
  }
  return refuted > 0;
}
