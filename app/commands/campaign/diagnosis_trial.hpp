// One run of a diagnosis campaign: simulates measurements of an arm, with a random hidden effect or without one, and
// diagnoses them.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "app/formats/cell/simulation_input.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

/// Outcome of a diagnosis, compared with the truth.
enum class DiagnosisOutcomeKind {
  kNotMade,       ///< the measurements could not be simulated or fitted
  kAdequate,      ///< verdict that the model lacks no effect
  kInconclusive,  ///< verdict that the measurements leave the cause undecided
  kNamed,         ///< only the true effect was named
  kAmong,         ///< several effects were named, including the true effect
  kOther,         ///< effects were named, but not the true one
  kUnexplained,   ///< verdict that something is missing that no known effect explains
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

/// Smallest magnitude of a hidden effect, as a fraction of the largest magnitude usual on a machine. Magnitudes are
/// log-uniform between this fraction and 1.
inline constexpr double kLeastShare = 0.02;
inline constexpr std::size_t kSizeClasses = 4;

struct DiagnosisTrial {
  int effect = -1;             ///< index in effectKinds(); -1 if there is no hidden effect
  std::size_t size_class = 0;  ///< quarter of the logarithmic range of magnitudes; 0 for the smallest
  DiagnosisOutcomeKind outcome = DiagnosisOutcomeKind::kNotMade;
};

struct DiagnosisTrialOptions {
  SimulationRequest measurements;  ///< request for the simulated measurements; its seed is not used
  double nothing = 0.5;            ///< fraction of the runs without a hidden effect
  int effects = 2;                 ///< largest number of effects in one explanation
  std::uint64_t seed = 1;
};

class DiagnosisTrials {
 public:
  /// Prepares the runs. `kinds` lists the effects that may be hidden, as indices in effectKinds(). Throws InputError
  /// for measurements that cannot be simulated.
  DiagnosisTrials(const Cell& cell, std::vector<int> kinds, const DiagnosisTrialOptions& options);

  /// Performs the trial with this index, and returns its result; std::nullopt if `stop` has returned true. Thread-safe.
  [[nodiscard]] std::optional<DiagnosisTrial> run(std::uint64_t index, const calibration::StopQuestion& stop) const;

 private:
  const Cell& cell_;
  std::vector<int> kinds_;
  DiagnosisTrialOptions options_;
};

/// Returns the catalogue effects that can act on the cell's arm and that measurements of the requested design could
/// show, as indices in effectKinds().
[[nodiscard]] std::vector<int> observableKinds(const Cell& cell, const DiagnosisTrialOptions& options);

}  // namespace tubeplan::app
