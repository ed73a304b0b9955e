// Two levels of ranks: with many ranks, the first rank of each group adds up the tallies of its group, so that the
// first rank of all receives few messages.
#pragma once

#include <vector>

namespace tubeplan::app {

/// Number of ranks up to which all of them send to the first rank.
inline constexpr int kMostRanksOfOneGroup = 64;

/// Groups of consecutive ranks; the first rank of a group is its leader.
struct RankGroups {
  int ranks = 1, size = 1;  ///< number of all ranks, and of those in a group

  [[nodiscard]] bool isLeader(int rank) const { return rank % size == 0; }

  /// Returns the rank that gives runs to this rank and receives its tallies: its leader, or the first rank for leaders.
  [[nodiscard]] int receiverOf(int rank) const { return isLeader(rank) ? 0 : rank - rank % size; }

  /// Returns the other ranks whose tallies this rank receives.
  [[nodiscard]] std::vector<int> sendersTo(int rank) const;
};

/// Returns one group for up to `most` ranks, otherwise groups of about the square root of the number of ranks.
[[nodiscard]] RankGroups rankGroups(int ranks, int most = kMostRanksOfOneGroup);

}  // namespace tubeplan::app
