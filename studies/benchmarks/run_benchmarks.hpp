// Common main function of the benchmark programs that register benchmarks at run time.
#pragma once

#include <benchmark/benchmark.h>

namespace tubeplan::benchmarks {

/// Runs the registered benchmarks with the options of the command line and returns the program's exit code.
inline int runBenchmarks(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace tubeplan::benchmarks
