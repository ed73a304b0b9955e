// Single run of a campaign of diagnoses: an arm with a random hidden effect, or none, is read, and the readings are
// diagnosed.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "app/formats/cell/simulation_input.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

/// Outcome of a diagnosis compared with the truth.
enum class DiagnosisOutcomeKind {
  kNotMade,       ///< the arm could not be read, or its readings could not be fitted
  kAdequate,      ///< verdict: nothing is missing
  kInconclusive,  ///< verdict: undecided
  kNamed,         ///< the true effect and nothing else
  kAmong,         ///< several effects, the true one among them
  kOther,         ///< one or several effects without the true one
  kUnexplained,   ///< something is missing that no known effect explains
};
inline constexpr std::array<std::string_view, 7> kDiagnosisOutcomes{"not-made", "adequate", "inconclusive", "named",
                                                                    "among",    "other",    "unexplained"};
inline constexpr std::array<std::string_view, 7> kOutcomeWords{"not made",
                                                               "adequate",
                                                               "inconclusive",
                                                               "the truth named",
                                                               "truth among several",
                                                               "another named",
                                                               "refused as unexplained"};

/// Smallest size of a hidden effect, as a share of the largest that a machine has. Sizes are drawn between this and 1,
/// uniformly in their logarithm.
inline constexpr double kLeastShare = 0.02;
inline constexpr std::size_t kSizeClasses = 4;

struct DiagnosisTrial {
  int effect = -1;             ///< index into effectKinds(); -1: no hidden effect
  std::size_t size_class = 0;  ///< quarter of the logarithmic range of sizes, from the least
  DiagnosisOutcomeKind outcome = DiagnosisOutcomeKind::kNotMade;
};

struct DiagnosisTrialOptions {
  SimulationRequest readings;  ///< all but the seed
  double nothing = 0.5;        ///< share of the runs without a hidden effect
  int effects = 2;             ///< maximum number in one explanation
  std::uint64_t seed = 1;
};

class DiagnosisTrials {
 public:
  /// Prepares the runs. `kinds`: effects that may be hidden, as indices into effectKinds(). Throws InputError for
  /// readings that cannot be taken.
  DiagnosisTrials(const Cell& cell, std::vector<int> kinds, const DiagnosisTrialOptions& options);

  /// Runs one trial; safe for any number of threads at once. Returns nullopt if it was asked to stop.
  [[nodiscard]] std::optional<DiagnosisTrial> run(std::uint64_t index, const calibration::StopQuestion& stop) const;

 private:
  const Cell& cell_;
  std::vector<int> kinds_;
  DiagnosisTrialOptions options_;
};

/// Returns the effects of the catalogue that have a place on the arm and that readings of the design could show.
[[nodiscard]] std::vector<int> hideableKinds(const Cell& cell, const DiagnosisTrialOptions& options);

}  // namespace tubeplan::app
