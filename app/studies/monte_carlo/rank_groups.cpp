#include "app/studies/monte_carlo/rank_groups.hpp"

#include <cmath>

namespace tubeplan::app {

std::vector<int> RankGroups::sendersTo(int rank) const {
  std::vector<int> senders;
  for (int other = 1; other < ranks; ++other)
    if (other != rank && receiverOf(other) == rank) senders.push_back(other);
  return senders;
}

RankGroups rankGroups(int ranks, int most) {
  if (ranks <= most) return {ranks, ranks};
  return {ranks, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(ranks))))};
}

}  // namespace tubeplan::app
