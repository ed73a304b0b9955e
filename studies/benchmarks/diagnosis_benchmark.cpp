// Benchmark of a diagnosis with the whole catalogue on one core. The ranking linearises every effect at every location
// about a fit and scores it. The verdict includes the fit, the ranking, the detectable sizes, and the fits of the
// leading candidates.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include "calibration/diagnosis/causes/signatures.hpp"
#include "calibration/diagnosis/diagnosis.hpp"
#include "calibration/diagnosis/evidence/linear_evidence.hpp"
#include "calibration/diagnosis/explanations/explanation_model.hpp"
#include "calibration/measurements/measurement_placement.hpp"
#include "studies/benchmarks/run_benchmarks.hpp"
#include "tests/calibration/bench_measurements.hpp"

namespace tubeplan::benchmarks {
namespace {

using namespace calibration;

constexpr int kMeasurements = 150;

struct Case {
  app::Cell cell = shippedBench();
  std::vector<Measurement> measurements = benchMeasurements(cell, "hysteresis", "theta3", {0.001}, kMeasurements, 1);
  PlacedArm start = placeForMeasurements(cell.arm, cell.X_WB, true, measurements);
  DiagnosisOptions options = optionsOf(cell);

  static DiagnosisOptions optionsOf(const app::Cell& cell) {
    DiagnosisOptions options;
    options.baseline.free.names = cell.identify;
    return options;
  }
};

void rankCatalogue(benchmark::State& state) {
  const Case c;
  IdentificationOptions quick = c.options.baseline;
  quick.folds = 0;
  const FittedBasis basis = basisOf(identify(c.start, c.measurements, quick), c.measurements);
  std::size_t candidates = 0;
  for (auto _ : state) {
    const CauseList list = listCauses(basis.fitted, basis.measurements, basis.unknowns);
    const Signatures signatures(basis.fitted, list.causes);
    const Eigen::MatrixXd S = signatures.columnsAt(basis.measurements, basis.weights);
    EvidenceGram gram;
    gram.add(basis.residual.jacobian, S, Eigen::MatrixXd(S.rows(), 0), -basis.residual.r);
    const LinearEvidence evidence(gram, basis.unknowns, {});
    for (int column = 0; column < S.cols(); ++column) benchmark::DoNotOptimize(evidence.of({{.column = column}}).log);
    candidates = list.causes.size();
  }
  state.counters["candidates"] = static_cast<double>(candidates);
}

void reachVerdict(benchmark::State& state) {
  const Case c;
  for (auto _ : state) benchmark::DoNotOptimize(diagnose(c.start, c.measurements, c.options).verdict);
}

BENCHMARK(rankCatalogue)->Name("diagnosis/ranking")->Unit(benchmark::kMillisecond);
BENCHMARK(reachVerdict)->Name("diagnosis/verdict")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tubeplan::benchmarks

int main(int argc, char** argv) {
  const tbb::global_control one_core(tbb::global_control::max_allowed_parallelism, 1);
  return tubeplan::benchmarks::runBenchmarks(argc, argv);
}
