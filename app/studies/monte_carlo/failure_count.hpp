// Number of runs that failed for one reason, and the first of them.
#pragma once

#include <algorithm>
#include <cstdint>

#include "app/studies/monte_carlo/tally_words.hpp"

namespace tubeplan::app {

struct FailureCount {
  std::uint64_t runs = 0, first_run = 0;  ///< number of failed runs, and index of the first of them

  void merge(const FailureCount& other) {
    if (other.runs == 0) return;
    first_run = runs == 0 ? other.first_run : std::min(first_run, other.first_run);
    runs += other.runs;
  }
  void put(TallyWords& words) const { words.insert(words.end(), {runs, first_run}); }
  static FailureCount read(WordReader& reader) {
    const std::uint64_t runs = reader.next();
    return {runs, reader.next()};
  }
};

}  // namespace tubeplan::app
