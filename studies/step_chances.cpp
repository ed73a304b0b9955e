// Study of the predicted probabilities that a given number of the tool's steps enters a hole. For 1,000 random true
// arms whose physics differs from the model, and for three, four and six touches, it compares the predicted with the
// observed fractions of holes for each number of steps.
#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <CLI/CLI.hpp>
#include <map>

#include "studies/step_chance_trials.hpp"

int main(int argc, char** argv) {
  using namespace tubeplan;
  CLI::App cli("step probabilities against random true arms");
  int runs = 1000, holes = 10;
  std::uint64_t seed = 1;
  std::vector<int> touches{3, 4, 6};
  auto hidden = testing::HiddenPhysics::kMixed;
  const std::map<std::string, testing::HiddenPhysics> kinds{{"mixed", testing::HiddenPhysics::kMixed},
                                                            {"effects", testing::HiddenPhysics::kEffects},
                                                            {"field", testing::HiddenPhysics::kField},
                                                            {"stiffnesses", testing::HiddenPhysics::kStiffnesses}};
  cli.add_option("--runs", runs);
  cli.add_option("--holes", holes);
  cli.add_option("--seed", seed);
  cli.add_option("--touches", touches);
  cli.add_option("--hidden", hidden, "mixed, effects, field or stiffnesses")->transform(CLI::CheckedTransformer(kinds));
  CLI11_PARSE(cli, argc, argv);
  app::Cell cell = app::readCell(std::string(TUBEPLAN_SOURCE_DIR) + "/app/cells/mockup.yaml");
  cell.uncertainty = testing::uncertaintyOfTrials();
  bool is_right = true;
  for (const int count : touches) {
    const testing::StepChanceTrials trials(cell, count, holes, hidden);
    std::vector<testing::StepChanceTrial> found(static_cast<std::size_t>(runs));
    oneapi::tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t k) {
      found[k] = trials.run(app::keyOf({seed, k}));
    });
    const auto sum = testing::summaryOf(found);
    fmt::print(
        "{} touches, {} of {} arms calibrated, {} holes\n  steps      predicted   happened   difference  (standard "
        "error)\n",
        count, sum.calibrated, runs, sum.holes);
    for (std::size_t b = 0; b < testing::kBins; ++b) {
      const double off = sum.predicted[b] - sum.happened[b];
      is_right = is_right && std::abs(off) <= 0.03;
      fmt::print("  {:5}      {:8.1f} %  {:8.1f} %  {:+9.1f} %  ({:.1f} %)\n", b, 100 * sum.predicted[b],
                 100 * sum.happened[b], 100 * off, 100 * sum.standard_error[b]);
    }
  }
  return is_right ? 0 : 1;
}
