// How long each least-squares method takes for the thesis's identification, and how far it comes: the thesis's own two
// (Hooke and Jeeves, steepest descent), the program's, and Ceres as a yardstick; same residuals, same run.
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>

#include "benchmarks/ceres_solver.hpp"
#include "benchmarks/thesis_campaign.hpp"

namespace tubeplan::benchmarks {
namespace {

using calibration::LeastSquaresProblem, calibration::LeastSquaresResult, calibration::LeastSquaresStatus;

/// One row of the table: calls for values alone and for the Jacobian, chi2 at the end, and the largest error of a
/// parameter. What is left of that at the bottom is the readings' noise. The label says why the method stopped.
void identify(benchmark::State& state, const std::function<LeastSquaresResult(const LeastSquaresProblem&)>& minimize) {
  const Campaign campaign = thesisCampaign();
  LeastSquaresResult found;
  for (auto _ : state) found = minimize(campaign.problem);
  state.counters["values"] = found.evaluations;
  state.counters["Jacobians"] = found.jacobian_evaluations;
  state.counters["chi2"] = found.chi2;
  state.counters["error_%"] = 100 * std::expm1((found.x - campaign.truth).lpNorm<Eigen::Infinity>());
  state.SetLabel((found.status == LeastSquaresStatus::kConverged ? "" : "NOT CONVERGED: ") + found.reason);
}

void evaluate(benchmark::State& state, bool jacobian) {
  const Campaign campaign = thesisCampaign();
  Eigen::VectorXd r;
  Eigen::MatrixXd J;
  for (auto _ : state) {
    bool ok = campaign.problem.evaluate(campaign.problem.start, r, jacobian ? &J : nullptr);
    benchmark::DoNotOptimize(ok);
  }
}

void registerAll() {
  benchmark::RegisterBenchmark("one evaluation/values", evaluate, false)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("one evaluation/Jacobian", evaluate, true)->Unit(benchmark::kMillisecond);
  for (const auto& kind : calibration::leastSquaresMethods()) {
    const auto minimize = [method = kind.method](const LeastSquaresProblem& problem) {
      calibration::LeastSquaresOptions options;
      options.method = method;
      return calibration::minimizeLeastSquares(problem, options);
    };
    benchmark::RegisterBenchmark(("identify/" + std::string(kind.name)).c_str(), identify, minimize)
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::RegisterBenchmark("identify/ceres", identify, minimizeByCeres)->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace tubeplan::benchmarks

int main(int argc, char** argv) {
  tubeplan::benchmarks::registerAll();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
