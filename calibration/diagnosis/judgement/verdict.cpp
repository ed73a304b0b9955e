#include "calibration/diagnosis/judgement/verdict.hpp"

#include <algorithm>
#include <array>

namespace tubeplan::calibration {

namespace {

struct VerdictRow {
  Verdict verdict;
  const char* name;
  const char* words;
};

constexpr std::array kVerdicts{
    VerdictRow{Verdict::kNotRun, "not-run", "Not diagnosed"},
    VerdictRow{Verdict::kAdequate, "adequate", "Adequate: nothing is missing"},
    VerdictRow{Verdict::kExplained, "explained", "Explained"},
    VerdictRow{Verdict::kPartlyExplained, "partly-explained", "Partly explained: certain causes, and a remainder"},
    VerdictRow{Verdict::kAmbiguous, "ambiguous", "Ambiguous: one of several"},
    VerdictRow{Verdict::kUnexplained, "unexplained", "Unexplained: none of the known effects"},
    VerdictRow{Verdict::kInconclusive, "inconclusive", "Inconclusive: more readings are needed"},
    VerdictRow{Verdict::kStopped, "stopped", "Stopped"},
};

const VerdictRow& rowOf(Verdict verdict) {
  return *std::find_if(kVerdicts.begin(), kVerdicts.end() - 1,
                       [&](const VerdictRow& row) { return row.verdict == verdict; });
}

}  // namespace

const char* nameOf(Verdict verdict) { return rowOf(verdict).name; }
const char* wordsOf(Verdict verdict) { return rowOf(verdict).words; }

}  // namespace tubeplan::calibration
