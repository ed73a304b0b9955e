// Choice of base positions: the few candidates from which an arm reaches most tubes, and the fewest that reach all.
//
// Both are covering problems over sets of tubes. The choice of at most `most` candidates is found by branch and bound:
// a partial choice can gain no more than its largest remaining gains (Nemhauser, Wolsey and Fisher 1978). The fewest
// candidates are found by branching over the candidates for the tube that the fewest candidates reach. Tubes with the
// same candidates are merged.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tubeplan::planner {

struct BaseCoverOptions {
  int most = 2;           ///< largest number of candidates to choose
  long most_nodes = 5e6;  ///< limit on the nodes of each search
};

enum class BaseCoverStatus {
  kNotRun,
  kProved,          ///< optimum proved: no other choice is better
  kNotProved,       ///< the search ended at its limit; the bounds are valid
  kNothingReached,  ///< empty problem: no candidate reaches a tube
};

struct BaseCover {
  BaseCoverStatus status = BaseCoverStatus::kNotRun;
  std::vector<int> best;  ///< the chosen candidates, at most BaseCoverOptions::most, ascending
  int reached = 0;        ///< number of tubes that `best` reaches
  int at_most = 0;        ///< upper bound on the tubes that any choice of this size reaches
  std::vector<int> all;   ///< the fewest candidates that reach every tube that any candidate reaches, ascending
  int at_least = 0;       ///< lower bound on the number of candidates that reach all of these tubes
  int reachable = 0;      ///< number of tubes that any candidate reaches
};

/// Chooses among candidates; reaches[c][t] states whether candidate c reaches tube t. Ties go to the earlier
/// candidates.
[[nodiscard]] BaseCover coverByBases(const std::vector<std::vector<bool>>& reaches,
                                     const BaseCoverOptions& options = {});

}  // namespace tubeplan::planner
