// Study of motion proofs: for each scene, it counts the random motions that are proved collision-free although checks
// in fine steps find a collision. The number should be zero.
#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <CLI/CLI.hpp>
#include <mutex>

#include "app/cli/progress.hpp"
#include "tests/planner/motion/bent_arm_motions.hpp"

namespace {

using namespace tubeplan;
using planner::testing::MotionTally;

constexpr int kMotionsEach = 100;  // motions per parallel task; every task has its own seed

using Tally = std::function<MotionTally(std::uint64_t seed, int motions)>;

MotionTally sharedOut(const std::string& name, int motions, const Tally& tally_of) {
  app::Progress progress(name, static_cast<std::size_t>(motions));
  MotionTally sum;
  std::mutex mutex;
  oneapi::tbb::parallel_for(0, (motions + kMotionsEach - 1) / kMotionsEach, [&](int share) {
    const MotionTally tally =
        tally_of(1 + static_cast<std::uint64_t>(share), std::min(kMotionsEach, motions - share * kMotionsEach));
    const std::scoped_lock lock(mutex);
    sum += tally;
    progress.update(static_cast<std::size_t>(sum.free + sum.blocked));
  });
  return sum;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace planner::testing;
  CLI::App cli{"Motions called free against fine steps"};
  int motions = 10000, samples = 10000;
  cli.add_option("--motions", motions, "of each scene");
  cli.add_option("--samples", samples, "of each motion called free");
  CLI11_PARSE(cli, argc, argv);

  std::vector<std::pair<std::string, Tally>> scenes;
  for (int scene = 0; scene < kAdversarialScenes; ++scene)
    scenes.emplace_back(kAdversarialNames[static_cast<std::size_t>(scene)],
                        [=](std::uint64_t seed, int share) { return tallyMotions(scene, seed, share, samples); });
  scenes.emplace_back("the mock-up's bent arm among thin plates",
                      [=](std::uint64_t seed, int share) { return tallyBentArmMotions(seed, share, samples); });

  fmt::print("{:<42} {:>8} {:>8} {:>8} {:>8}\n", "scene", "motions", "free", "blocked", "refuted");
  int refuted = 0;
  for (const auto& [name, tally_of] : scenes) {
    const MotionTally tally = sharedOut(name, motions, tally_of);
    fmt::print("{:<42} {:>8} {:>8} {:>8} {:>8}\n", name, motions, tally.free, tally.blocked, tally.refuted);
    std::fflush(stdout);
    refuted += tally.refuted;
  }
  return refuted > 0;
}
