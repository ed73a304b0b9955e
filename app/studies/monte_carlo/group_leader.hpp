// Leader of a group of ranks: shares out runs among its group, adds up the group's tallies and passes on their sum. It
// knows messages alone, and nothing of MPI.
#pragma once

#include <deque>
#include <map>

#include "app/studies/monte_carlo/rank_messages.hpp"

namespace tubeplan::app {

class GroupLeader {
 public:
  /// `members` are the ranks of the group, with the leader's own `rank`; `experiment` must outlive this object.
  GroupLeader(const Experiment& experiment, int rank, const std::vector<int>& members);

  /// Takes a message from a member or from the first rank, and returns the messages that follow from it. A message to
  /// the leader's own rank is for its own workers.
  [[nodiscard]] std::vector<RankMessage> take(const RankMessage& message);

  /// Returns the sum of the tallies since the last call as a message to the first rank; no message if there are none.
  [[nodiscard]] std::vector<RankMessage> pass();

  /// Returns true if no member works on runs, so that waiting for further tallies is useless.
  [[nodiscard]] bool isIdle() const { return under_way_ == 0; }

 private:
  [[nodiscard]] std::vector<RankMessage> shareOut();
  [[nodiscard]] std::vector<RankMessage> toAll(int subject) const;
  void add(DoneRuns done);

  const Experiment& experiment_;
  int rank_;
  std::map<int, std::uint64_t> wanted_;  ///< number of chunks that each member waits for
  std::deque<RunRange> waiting_;         ///< chunks that no member has yet
  DoneRuns done_;
  std::size_t under_way_ = 0;         ///< number of chunks that members work on
  std::size_t finished_members_ = 0;  ///< number of members that have left
};

}  // namespace tubeplan::app
