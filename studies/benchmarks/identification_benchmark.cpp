// Benchmark of least-squares methods on the thesis's identification problem, with time and final error: the two methods
// of the thesis (Hooke and Jeeves, steepest descent), the program's methods, and Ceres as a reference. All methods
// minimise the same residuals in one run.
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>

#include "studies/benchmarks/ceres_solver.hpp"
#include "studies/benchmarks/run_benchmarks.hpp"
#include "studies/benchmarks/thesis_campaign.hpp"
#include "studies/benchmarks/thesis_methods.hpp"

namespace tubeplan::benchmarks {
namespace {

using calibration::LeastSquaresProblem, calibration::LeastSquaresResult, calibration::LeastSquaresStatus;

using MakeCampaign = Campaign (*)();
using Minimize = std::function<LeastSquaresResult(const LeastSquaresProblem&)>;

/// Measures one method: evaluations of the residuals and of the Jacobian, final chi2, and the largest relative error of
/// a stiffness. Measurement noise limits the error of the best methods. The label states why the method stopped.
void minimize(benchmark::State& state, MakeCampaign make, const Minimize& minimize) {
  const Campaign campaign = make();
  LeastSquaresResult found;
  for (auto _ : state) found = minimize(campaign.problem);
  state.counters["values"] = found.evaluations;
  state.counters["Jacobians"] = found.jacobian_evaluations;
  state.counters["chi2"] = found.chi2;
  state.counters["error_%"] = 100 * campaign.error(found.x);
  state.SetLabel((found.status == LeastSquaresStatus::kConverged ? "" : "NOT CONVERGED: ") + found.reason);
}

void evaluate(benchmark::State& state, MakeCampaign make, bool jacobian) {
  const Campaign campaign = make();
  Eigen::VectorXd r;
  Eigen::MatrixXd J;
  for (auto _ : state) {
    bool ok = campaign.problem.evaluate(campaign.problem.start, r, jacobian ? &J : nullptr);
    benchmark::DoNotOptimize(ok);
  }
}

/// Measures the program's complete identification: identifiability analysis, weights, fit, and intervals.
void identify(benchmark::State& state) {
  const auto session = touchSession();
  calibration::IdentificationOptions options;
  options.free = {session->names, false};
  options.folds = 0;
  calibration::Identification found;
  for (auto _ : state) found = calibration::identify(session->start, session->measurements, options);
  state.counters["values"] = found.evaluations;
  state.counters["Jacobians"] = found.jacobian_evaluations;
  state.counters["chi2"] = found.chi2;
  double error = 0;
  for (std::size_t k = 0; k < session->truth.size(); ++k)
    error = std::max(error, std::abs(found.numbers.at(k).value / session->truth[k] - 1));
  state.counters["error_%"] = 100 * error;
  state.SetLabel(found.status == calibration::IdentificationStatus::kDone
                     ? std::to_string(found.numbers.size()) + " free"
                     : "NOT DONE: " + found.reason);
}

void registerCampaign(const std::string& name, MakeCampaign make) {
  const auto add = [](const std::string& row, auto&&... call) {
    benchmark::RegisterBenchmark(row.c_str(), call...)->Unit(benchmark::kMillisecond);
  };
  add(name + "/one evaluation/values", evaluate, make, false);
  add(name + "/one evaluation/Jacobian", evaluate, make, true);
  for (const auto& kind : calibration::leastSquaresMethods()) {
    const auto by = [method = kind.method](const LeastSquaresProblem& problem) {
      calibration::LeastSquaresOptions options;
      options.method = method;
      return calibration::minimizeLeastSquares(problem, options);
    };
    add(name + "/" + std::string(kind.name), minimize, make, Minimize(by));
  }
  add(name + "/hooke-jeeves", minimize, make, Minimize(minimizeByHookeJeeves));
  add(name + "/steepest-descent", minimize, make, Minimize(minimizeBySteepestDescent));
  add(name + "/ceres", minimize, make, Minimize(minimizeByCeres));
}

void registerAll() {
  registerCampaign("6 of 93 places", thesisCampaign);
  registerCampaign("11 of 45 touch points", touchCampaign);
  benchmark::RegisterBenchmark("11 of 45 touch points/identify", identify)->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace tubeplan::benchmarks

int main(int argc, char** argv) {
  tubeplan::benchmarks::registerAll();
  return tubeplan::benchmarks::runBenchmarks(argc, argv);
}
