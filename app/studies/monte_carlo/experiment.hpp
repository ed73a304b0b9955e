// The repeated experiment of a campaign, as workers and checkpoints see it.
#pragma once

#include <functional>
#include <optional>

#include "app/studies/monte_carlo/tally_words.hpp"

namespace tubeplan::app {

/// Runs by index, from `first` to before `end`. A run depends on its index and not on earlier runs.
struct RunRange {
  std::uint64_t first = 0, end = 0;
  bool operator==(const RunRange&) const = default;
};

class Experiment {
 public:
  virtual ~Experiment() = default;

  /// Returns the tally of these runs alone; nothing if stopped before the end. Safe from several threads at once.
  [[nodiscard]] virtual std::optional<TallyWords> run(RunRange runs, const std::function<bool()>& stop) const = 0;

  /// Adds a tally to the total, in any order. Returns false if it is not one of this experiment.
  [[nodiscard]] virtual bool add(const TallyWords& tally) = 0;

  /// Returns the total.
  [[nodiscard]] virtual TallyWords total() const = 0;
};

}  // namespace tubeplan::app
