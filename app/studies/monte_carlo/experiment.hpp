// Interface through which workers and checkpoints use the experiment that a campaign repeats.
#pragma once

#include <functional>
#include <optional>

#include "app/studies/monte_carlo/tally_words.hpp"

namespace tubeplan::app {

/// Runs with indices from `first` up to, but not including, `end`. A run depends on its index, not on earlier runs.
struct RunRange {
  std::uint64_t first = 0, end = 0;
  bool operator==(const RunRange&) const = default;
};

class Experiment {
 public:
  virtual ~Experiment() = default;

  /// Returns the tally of the given runs alone; std::nullopt if the runs were stopped early. Thread-safe.
  [[nodiscard]] virtual std::optional<TallyWords> run(RunRange runs, const std::function<bool()>& stop) const = 0;

  /// Adds a tally to the total; the order of additions does not matter. Returns false if the tally does not belong to
  /// this experiment.
  [[nodiscard]] virtual bool add(const TallyWords& tally) = 0;

  /// Returns the sum of two tallies; std::nullopt if one of them does not belong to this experiment. Thread-safe.
  [[nodiscard]] virtual std::optional<TallyWords> sum(const TallyWords& a, const TallyWords& b) const = 0;

  /// Returns the sum of all added tallies.
  [[nodiscard]] virtual TallyWords total() const = 0;
};

}  // namespace tubeplan::app
