// Main part of the benchmark programs that register their own rows.
#pragma once

#include <benchmark/benchmark.h>

namespace tubeplan::benchmarks {

/// Runs the registered benchmarks by the command line and returns the program's exit code.
inline int runBenchmarks(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace tubeplan::benchmarks
