#include "deflection/shortest_chain.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace tubeplan::deflection {

using Eigen::Vector3d;

namespace {

/// A chain is shortened if its length exceeds its shortest length by more than this factor.
constexpr double kExcessiveLength = 2;
constexpr int kShortenings = 10;
/// Lower bound on a piece's length in the computation of its weight, as a fraction of the chain's length. It avoids
/// division by zero if points coincide.
constexpr double kShortestPiece = 1e-3;

/// Shifts the points so that the weighted sum of squared piece lengths becomes minimal, and adds the shifts to `slid`.
void slideOnce(std::vector<ChainLine>& chain, const std::vector<double>& weights, std::vector<double>& slid) {
  const std::size_t n = chain.size();
  std::vector<double> diagonal(n), right(n), coupling(n, 0.);
  for (std::size_t k = 0; k < n; ++k) {
    diagonal[k] = chain[k].may_slide ? 0 : 1;
    if (!chain[k].may_slide) continue;
    const Vector3d& d = chain[k].direction;
    if (k > 0) {
      diagonal[k] += weights[k - 1];
      right[k] -= weights[k - 1] * d.dot(chain[k].point - chain[k - 1].point);
    }
    if (k + 1 == n) continue;
    diagonal[k] += weights[k];
    right[k] += weights[k] * d.dot(chain[k + 1].point - chain[k].point);
    if (chain[k + 1].may_slide) coupling[k] = -weights[k] * d.dot(chain[k + 1].direction);
  }
  for (std::size_t k = 1; k < n; ++k) {
    const double share = coupling[k - 1] / diagonal[k - 1];
    diagonal[k] -= share * coupling[k - 1];
    right[k] -= share * right[k - 1];
  }
  double next = 0;
  for (std::size_t k = n; k-- > 0;) {
    next = (right[k] - coupling[k] * next) / diagonal[k];
    slid[k] += next;
    chain[k].point += next * chain[k].direction;
  }
}

}  // namespace

double chainLength(const std::vector<ChainLine>& chain) {
  double length = 0;
  for (std::size_t k = 1; k < chain.size(); ++k) length += (chain[k].point - chain[k - 1].point).norm();
  return length;
}

std::vector<double> shortenChain(std::vector<ChainLine>& chain) {
  std::vector<double> slid(chain.size(), 0.), weights(chain.size(), 1.);
  // Solve twice with equal weights: the second solution recovers the digits that the first loses if points are far
  // away.
  slideOnce(chain, weights, slid);
  slideOnce(chain, weights, slid);
  for (int step = 0; step < kShortenings; ++step) {
    const double length = chainLength(chain);
    if (length == 0) break;
    for (std::size_t k = 0; k + 1 < chain.size(); ++k)
      weights[k] = 1 / std::max((chain[k + 1].point - chain[k].point).norm() / length, kShortestPiece);
    slideOnce(chain, weights, slid);
  }
  return slid;
}

std::vector<double> drawTogether(std::vector<ChainLine>& chain) {
  std::vector<ChainLine> drawn = chain;
  const std::vector<double> slid = shortenChain(drawn);
  if (!(chainLength(chain) > kExcessiveLength * chainLength(drawn))) return std::vector<double>(chain.size(), 0.);
  chain = std::move(drawn);
  return slid;
}

}  // namespace tubeplan::deflection
