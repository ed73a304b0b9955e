// Diagnose, add, identify, until nothing more is shown: from a cell and its readings to the improved cell.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/job_steps.hpp"
#include "app/ladder.hpp"
#include "app/reading_input.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

struct ImprovementRequest {
  int steps = 6;  ///< the most rounds
  std::uint64_t seed = 1;
};

/// One round of the loop as it went.
struct ImprovementStep {
  calibration::Verdict verdict = calibration::Verdict::kNotRun;
  std::string sentence;
  std::vector<std::string> added;
};

struct Improvement {
  Cell cell;
  std::vector<ImprovementStep> steps;
  std::vector<Rung> rungs;
  calibration::Identification last;
};

/// Throws InputError for readings that tell nothing, JobStopped.
[[nodiscard]] Improvement improveModel(const CellReadings& input, const ImprovementRequest& request,
                                       const WorkHooks& hooks = {});

/// As `tubeplan improve --json` writes it.
[[nodiscard]] nlohmann::json improvementJson(const Improvement& result);

}  // namespace tubeplan::app
