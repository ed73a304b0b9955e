// What the programs of benchmarks that register their own rows do with them.
#pragma once

#include <benchmark/benchmark.h>

namespace tubeplan::benchmarks {

/// Runs what is registered, as the command line asks; the program's exit code.
inline int runBenchmarks(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace tubeplan::benchmarks
