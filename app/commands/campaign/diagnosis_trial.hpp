// One run of a campaign of diagnoses: an arm hides a random effect, or none, is read, and the readings are diagnosed.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "app/formats/cell/simulation_input.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

/// What a diagnosis came to, seen from the truth.
enum class DiagnosisOutcomeKind {
  kNotMade,       ///< the arm could not be read, or its readings not be fitted
  kAdequate,      ///< nothing is missing
  kInconclusive,  ///< perhaps
  kNamed,         ///< the truth, and nothing else
  kAmong,         ///< several, the truth among them
  kOther,         ///< one or several, not the truth
  kUnexplained,   ///< something is missing that nothing known explains
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

/// A hidden effect's size as a share of the largest that a machine has: drawn between the least and 1, all orders of
/// size alike.
inline constexpr double kLeastShare = 0.02;
inline constexpr std::size_t kSizeClasses = 4;

struct DiagnosisTrial {
  int effect = -1;             ///< index into effectKinds(); -1: nothing was hidden
  std::size_t size_class = 0;  ///< quarter of the orders of size, from the least
  DiagnosisOutcomeKind outcome = DiagnosisOutcomeKind::kNotMade;
};

struct DiagnosisTrialOptions {
  SimulationRequest readings;  ///< but for the seed
  double nothing = 0.5;        ///< share of the runs in which nothing is hidden
  int effects = 2;             ///< the most in one explanation
  std::uint64_t seed = 1;
};

class DiagnosisTrials {
 public:
  /// `kinds`: the effects that may be hidden, as indices into effectKinds(). Throws InputError for readings that cannot
  /// be taken.
  DiagnosisTrials(const Cell& cell, std::vector<int> kinds, const DiagnosisTrialOptions& options);

  /// For any number of threads at once. None where it was asked to stop.
  [[nodiscard]] std::optional<DiagnosisTrial> run(std::uint64_t index, const calibration::StopQuestion& stop) const;

 private:
  const Cell& cell_;
  std::vector<int> kinds_;
  DiagnosisTrialOptions options_;
};

/// Effects of the catalogue that have a place on the arm and that readings of the design could show.
[[nodiscard]] std::vector<int> hideableKinds(const Cell& cell, const DiagnosisTrialOptions& options);

}  // namespace tubeplan::app
