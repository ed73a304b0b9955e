// Program that only solves postures of the Cobra arm in rounds, to be run under an instruction counter. The difference
// in instructions between two runs, divided by the difference in postures, is the cost of one posture (see bench.py).
#include <CLI/CLI.hpp>
#include <random>

#include "deflection/prepared_arm.hpp"
#include "deflection/tip_differentiation.hpp"
#include "tests/deflection/cobra.hpp"

int main(int argc, char** argv) {
  using namespace tubeplan;
  using namespace tubeplan::deflection;
  CLI::App cli{"Solves the same 64 postures again and again"};
  int rounds = 1;
  bool derive = false;
  cli.add_option("--rounds", rounds, "how often");
  cli.add_flag("--jacobian", derive, "with the exact Jacobian by the joints");
  CLI11_PARSE(cli, argc, argv);

  const Arm arm = cobraArm();
  const auto variables = jointVariables(arm);
  PreparedArm prepared(arm);
  TipDifferentiation tip(arm);
  std::mt19937_64 random(3);
  std::vector<Posture> postures;
  for (int k = 0; k < 64; ++k) postures.push_back({randomJoints(arm, random), 20 * kPound * (k % 3)});
  double sum = 0;
  for (int round = 0; round < rounds; ++round)
    for (const Posture& posture : postures)
      if (derive) {
        tip.solve(posture, variables);
        sum += tip.columns()(0, 0);
      } else {
        prepared.solve(posture);
        sum += prepared.X_BD().p.x();
      }
  return sum == 12345;  // prevents the compiler from omitting the work
}
