// What a campaign repeats, as its workers and checkpoints see it.
#pragma once

#include <functional>
#include <optional>

#include "app/studies/monte_carlo/tally_words.hpp"

namespace tubeplan::app {

/// Runs by index, from `first` to before `end`. A run depends on its index and on nothing that was run before.
struct RunRange {
  std::uint64_t first = 0, end = 0;
  bool operator==(const RunRange&) const = default;
};

class Experiment {
 public:
  virtual ~Experiment() = default;

  /// The tally of these runs alone; nothing when stopped before the end. From several threads at once.
  [[nodiscard]] virtual std::optional<TallyWords> run(RunRange runs, const std::function<bool()>& stop) const = 0;

  /// Adds a tally to the total, in any order; false where it is none of this experiment's.
  [[nodiscard]] virtual bool add(const TallyWords& tally) = 0;

  /// The total.
  [[nodiscard]] virtual TallyWords total() const = 0;
};

}  // namespace tubeplan::app
