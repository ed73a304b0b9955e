// Random perturbations (kicks) of the tour search, small and local, so that the search repairs each kick quickly.
#include <algorithm>
#include <cmath>

#include "planner/order/tour_search.hpp"

namespace tubeplan::planner {
namespace {

constexpr int kLongestKick = 30;  // longest part of the tour that a kick moves or switches, in positions
constexpr int kBranchKickEvery = 16;

// Returns a random number below `bound`. The standard distributions differ between libraries; the small bias of the
// modulo operation does not matter here.
int below(int bound, std::mt19937_64& random) { return static_cast<int>(random() % static_cast<std::uint64_t>(bound)); }

}  // namespace

void TourSearch::kick(long count, std::mt19937_64& random) {
  for (long i = 0; i < count; ++i) {
    changes_.clear();
    gained_ = 0;
    const bool branches = table_.postures() > table_.nodes() && below(kBranchKickEvery, random) == 0;
    if (branches ? !switchBranches(random) : !swapSegments(random)) continue;
    improveDirty();
    if (gained_ < -1e-9) undo();
  }
}

bool TourSearch::swapSegments(std::mt19937_64& random) {
  const int longest = std::min(kLongestKick, (size() - 2) / 2);
  if (longest < 1) return false;
  const int start = below(size(), random), first = 1 + below(longest, random), second = 1 + below(longest, random);
  const auto at = [&](int offset) { return tour_[(start + offset) % size()]; };
  const Segment segment{at(0), at(1), at(first), at(first + 1)};
  const int d = at(first + second), c = at(first + second + 1);
  const double gain = cost(segment.before, segment.first) + cost(segment.last, segment.after) + cost(d, c) -
                      cost(segment.before, segment.after) - cost(d, segment.first) - cost(segment.last, c);
  if (!std::isfinite(gain)) return false;
  moveSegment(segment, c, d, true);
  gained_ += gain;
  for (const int node : {segment.before, segment.first, segment.last, segment.after, d, c}) markDirty(node);
  return true;
}

// Switches a random visit to another branch, and each later visit to the posture nearest to the previous visit's.
bool TourSearch::switchBranches(std::mt19937_64& random) {
  const int start = below(size(), random), length = 1 + below(std::min(kLongestKick, size() - 2), random);
  int node = tour_[start];
  if (node >= visits_ || table_.last(node) - table_.first(node) < 2) return false;
  const int before = previous(node), old_posture = posture_of_node_[node];
  int posture = table_.first(node) + below(table_.last(node) - table_.first(node), random);
  if (posture == old_posture) return false;
  for (int i = 0; i < length && node < visits_; ++i) {
    const int ahead = next(node);
    gained_ += cost(previous(node), node) + cost(node, ahead);
    setPosture(node, posture);
    gained_ -= cost(previous(node), node) + cost(node, ahead);
    markDirty(node);
    node = ahead;
    if (node >= visits_) break;
    posture = table_.nearestPosture(posture, node);
    if (posture == posture_of_node_[node]) break;
  }
  markDirty(before);
  markDirty(node);
  return true;
}

}  // namespace tubeplan::planner
