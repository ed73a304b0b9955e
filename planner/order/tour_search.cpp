#include "planner/order/tour_search.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "deflection/resized.hpp"

namespace tubeplan::planner {
namespace {

// smallest gain for which a move is made [s]; exceeds the rounding errors of sums that include forbidden moves
constexpr double kLeastGain = 1e-8;

}  // namespace

TourSearch::TourSearch(const PostureTable& table, const std::vector<std::vector<Neighbour>>& neighbours)
    : table_(table), neighbours_(neighbours), visits_(table.visits()) {
  if (table.startNode() < 0 || table.endNode() < 0) free_anchor_ = table.nodes();
}

void TourSearch::restart(const std::vector<int>& order, const std::vector<int>& posture_of_node) {
  assert(static_cast<int>(order.size()) == visits_);
  tour_ = order;
  if (table_.endNode() >= 0) tour_.push_back(table_.endNode());
  if (free_anchor_ >= 0) tour_.push_back(free_anchor_);
  if (table_.startNode() >= 0) tour_.push_back(table_.startNode());
  place_.assign(tour_.size(), 0);
  for (int i = 0; i < size(); ++i) place_[tour_[i]] = i;
  posture_of_node_ = posture_of_node;
  posture_of_node_.resize(tour_.size(), -1);
  is_dirty_.assign(tour_.size(), 0);
  dirty_.clear();
  changes_.clear();
}

std::vector<int> TourSearch::order() const {
  const bool backwards = table_.startNode() >= 0 ? next(table_.startNode()) >= visits_
                                                 : table_.endNode() >= 0 && previous(table_.endNode()) >= visits_;
  int node = table_.startNode() >= 0 ? table_.startNode() : free_anchor_;
  std::vector<int> order;
  order.reserve(visits_);
  for (int i = 0; i < size(); ++i) {
    node = backwards ? previous(node) : next(node);
    if (node < visits_) order.push_back(node);
  }
  return order;
}

double TourSearch::costAtAnchor(int node_a, int posture_a, int node_b) const {
  // An edge between anchors has a cost of minus infinity, so that removing it never gains. A move that removes and
  // restores it has a gain of NaN, which fails every comparison.
  if (node_a >= visits_ && node_b >= visits_) return -std::numeric_limits<double>::infinity();
  if (node_a == free_anchor_ || node_b == free_anchor_) return 0;
  return table_.cost(posture_a, posture_of_node_[node_b]);
}

void TourSearch::costsFrom(int node_a, int node_b, Eigen::ArrayXd& times) const {
  if (node_a < visits_ && node_b != free_anchor_) {
    table_.costsTo(node_a, posture_of_node_[node_b], times);
  } else {
    deflection::resizeOrEmpty(times, table_.last(node_a) - table_.first(node_a), 1);
    times.setConstant(costAt(node_a, table_.first(node_a), node_b));
  }
}

void TourSearch::improve() {
  for (int i = size(); i-- > 0;) markDirty(tour_[i]);
  improveDirty();
  changes_.clear();
}

void TourSearch::improveDirty() {
  while (!dirty_.empty()) {
    const int node = dirty_.back();
    dirty_.pop_back();
    is_dirty_[node] = 0;
    while (improveNode(node)) continue;
  }
}

bool TourSearch::improveNode(int node) {
  if (node == free_anchor_) return false;
  return moveFrom(node, Side::kNext) || moveFrom(node, Side::kPrevious) || changeBranch(node);
}

bool TourSearch::changeBranch(int node) {
  if (table_.last(node) - table_.first(node) < 2) return false;
  const int before = previous(node), after = next(node);
  const double now = cost(node, before) + cost(node, after);
  costsFrom(node, before, times_);
  costsFrom(node, after, other_times_);
  for (int posture = table_.first(node); posture < table_.last(node); ++posture) {
    const Eigen::Index k = posture - table_.first(node);
    const double gain = now - times_[k] - other_times_[k];
    if (!(gain > kLeastGain)) continue;
    setPosture(node, posture);
    gained_ += gain;
    markDirty(before);
    markDirty(after);
    return true;
  }
  return false;
}

// Replaces the edge from `a` to its neighbour on one side by a shorter edge to `c`. Tries every way of closing the tour
// again.
bool TourSearch::moveFrom(int a, Side side) {
  const int b = adjacent(a, side);
  const double now = cost(a, b);
  if (now <= 0) return false;
  const Stretches stretches = stretchesEndingAt(a, b, side);
  const auto tryWith = [&](int c) {
    if (c == b || c == a) return false;
    const double gain = now - cost(a, c);
    const Junction junction{c, adjacent(c, side), adjacent(c, side == Side::kNext ? Side::kPrevious : Side::kNext)};
    if (gain > 0 && (tryTwoOpt(a, b, junction, gain) || tryOrOpt(stretches, junction, gain))) return true;
    return stretches.size > 0 && tryOtherBranch(stretches, junction, now);
  };
  if (free_anchor_ >= 0 && tryWith(free_anchor_)) return true;
  for (const Neighbour& neighbour : neighbours_[a]) {
    if (neighbour.time >= now) return false;
    if (tryWith(neighbour.node)) return true;
  }
  return false;
}

TourSearch::Stretches TourSearch::stretchesEndingAt(int a, int b, Side side) const {
  Stretches stretches;
  int first = a;
  while (stretches.size < kLongestInsertion) {
    const int before = adjacent(first, side == Side::kNext ? Side::kPrevious : Side::kNext);
    if (before == b || before == a) break;
    stretches.segments[stretches.size] = {before, first, a, b};
    stretches.saved[stretches.size++] = cost(before, first) - cost(before, b);
    first = before;
  }
  return stretches;
}

bool TourSearch::tryTwoOpt(int a, int b, const Junction& at, double gain_so_far) {
  const double gain = gain_so_far + cost(at.node, at.beyond) - cost(b, at.beyond);
  if (!(gain > kLeastGain) || at.beyond == a) return false;
  exchange(a, b, at.node, at.beyond);
  gained_ += gain;
  for (const int node : {at.beyond, at.node, b, a}) markDirty(node);
  return true;
}

// Moves one of the segments to either side of `at.node`, so that the common last node of the segments is adjacent to
// `at.node`.
bool TourSearch::tryOrOpt(const Stretches& stretches, const Junction& at, double gain_so_far) {
  const double beyond = gain_so_far + cost(at.node, at.beyond), behind = gain_so_far + cost(at.node, at.behind);
  for (int i = 0; i < stretches.size; ++i) {
    const Segment& segment = stretches.segments[i];
    if (segment.first == at.node || segment.before == at.node) return false;
    const double gain_beyond = beyond + stretches.saved[i] - cost(segment.first, at.beyond);
    if (gain_beyond > kLeastGain && at.beyond != segment.before)
      return insert(segment, at.node, at.beyond, false, gain_beyond);
    const double gain_behind = behind + stretches.saved[i] - cost(segment.first, at.behind);
    if (gain_behind > kLeastGain) return insert(segment, at.node, at.behind, true, gain_behind);
  }
  return false;
}

// Tries to move a single visit to the junction while it changes to another branch.
bool TourSearch::tryOtherBranch(const Stretches& stretches, const Junction& at, double now) {
  const Segment& segment = stretches.segments[0];
  const int node = segment.last;
  if (table_.last(node) - table_.first(node) < 2 || segment.before == at.node) return false;
  const double beyond = cost(at.node, at.beyond), behind = cost(at.node, at.behind);
  costsFrom(node, at.node, times_);
  for (int posture = table_.first(node); posture < table_.last(node); ++posture) {
    const double gain = now + stretches.saved[0] - times_[posture - table_.first(node)];
    if (posture == posture_of_node_[node] || gain + beyond <= kLeastGain) continue;
    const double gain_beyond = gain + beyond - costAt(node, posture, at.beyond);
    const double gain_behind = gain + behind - costAt(node, posture, at.behind);
    const bool fits_beyond = gain_beyond > kLeastGain && at.beyond != segment.before;
    if (!fits_beyond && !(gain_behind > kLeastGain)) continue;
    setPosture(node, posture);
    return insert(segment, at.node, fits_beyond ? at.beyond : at.behind, !fits_beyond,
                  fits_beyond ? gain_beyond : gain_behind);
  }
  return false;
}

bool TourSearch::insert(const Segment& segment, int c, int d, bool keeps_sense, double gain) {
  moveSegment(segment, c, d, keeps_sense);
  gained_ += gain;
  for (const int node : {d, c, segment.after, segment.before, segment.first, segment.last}) markDirty(node);
  return true;
}

// Moves a segment: before [first..last] after .. c d  ->  before after .. c [last..first] d; if it keeps its direction:
// before [first..last] after .. d c  ->  before after .. d [first..last] c.
void TourSearch::moveSegment(const Segment& segment, int c, int d, bool keeps_sense) {
  const auto [before, first, last, after] = segment;
  const int near = keeps_sense ? d : c, far = keeps_sense ? c : d;
  exchange(before, first, near, far);
  if (near != after) exchange(before, near, after, last);
  if (keeps_sense && first != last) exchange(near, last, first, far);
}

// Replaces edges a-b and c-d, traversed in the same direction, by a-c and b-d.
void TourSearch::exchange(int a, int b, int c, int d) {
  if (next(a) == b) {
    reversePlaces(place_[b], place_[c]);
  } else {
    reversePlaces(place_[a], place_[d]);
  }
}

// Reverses either the given positions or all other positions, whichever are fewer. Both give the same closed tour.
void TourSearch::reversePlaces(int from, int to) {
  int length = to - from + 1;
  if (length <= 0) length += size();
  if (2 * length > size()) {
    std::swap(from, to);
    from = from + 1 == size() ? 0 : from + 1;
    to = to == 0 ? size() - 1 : to - 1;
    length = size() - length;
  }
  changes_.push_back({-1, from, to});
  for (int i = length / 2; i > 0; --i) {
    std::swap(tour_[from], tour_[to]);
    place_[tour_[from]] = from;
    place_[tour_[to]] = to;
    from = from + 1 == size() ? 0 : from + 1;
    to = to == 0 ? size() - 1 : to - 1;
  }
}

void TourSearch::setPosture(int node, int posture) {
  changes_.push_back({node, posture_of_node_[node], posture});
  posture_of_node_[node] = posture;
}

void TourSearch::undo() {
  const std::vector<Change> changes = std::move(changes_);
  changes_.clear();
  for (std::size_t i = changes.size(); i-- > 0;) {
    if (changes[i].node >= 0) {
      posture_of_node_[changes[i].node] = changes[i].first;
    } else {
      reversePlaces(changes[i].first, changes[i].second);
    }
  }
}

void TourSearch::markDirty(int node) {
  if (is_dirty_[node]) return;
  is_dirty_[node] = 1;
  dirty_.push_back(node);
}

}  // namespace tubeplan::planner
