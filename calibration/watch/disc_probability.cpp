#include "calibration/watch/disc_probability.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace tubeplan::calibration {

namespace {

using Eigen::Matrix2d, Eigen::Vector2d;

constexpr double kTails = 6;  // standard deviations beyond which a density counts as zero

double density(double z) { return std::abs(z) > kTails ? 0 : std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi); }

/// Returns the probability that a standard normal variable exceeds `z`.
double tail(double z) {
  if (std::abs(z) > kTails) return z > 0 ? 0 : 1;
  return std::erfc(z / std::numbers::sqrt2) / 2;
}

/// Returns the probability that a standard normal variable lies between the limits, without cancellation in the tails.
double between(double low, double high) { return low > 0 ? tail(low) - tail(high) : tail(-high) - tail(-low); }

/// A node of a rule for integrals over [-1, 1].
struct Node {
  double x, weight;
};

/// Returns the nodes of a Gauss rule in the variable whose sine is x, which removes square roots at the ends.
std::vector<Node> nodesOfRule() {
  using Rule = boost::math::quadrature::gauss<double, 30>;
  constexpr double kQuarterTurn = std::numbers::pi / 2;
  std::vector<Node> nodes;
  for (std::size_t k = 0; k < Rule::abscissa().size(); ++k)
    for (const double side : {-1., 1.}) {
      const double turn = side * kQuarterTurn * Rule::abscissa()[k];
      nodes.push_back({std::sin(turn), kQuarterTurn * Rule::weights()[k] * std::cos(turn)});
    }
  return nodes;
}

/// Calls `add(x, weight)` at the nodes of a rule for integrals over [low, high].
template <class Add>
void overNodes(double low, double high, const Add& add) {
  static const std::vector<Node> kNodes = nodesOfRule();
  const double middle = (low + high) / 2, half = (high - low) / 2;
  for (const Node& node : kNodes) add(middle + half * node.x, half * node.weight);
}

/// A chord of the common part of discs, along y.
struct Chord {
  double low, high;
};
Chord chordAt(double x, const CommonDiscs& discs) {
  Chord chord{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const Disc& disc : discs) {
    const double aside = x - disc.centre.x();
    const double half = std::sqrt(std::max(0., (disc.radius - aside) * (disc.radius + aside)));
    chord.low = std::max(chord.low, disc.centre.y() - half);
    chord.high = std::min(chord.high, disc.centre.y() + half);
  }
  return chord;
}

/// Adds the x at which the rims of two discs meet.
void addMeetings(const Disc& first, const Disc& second, std::vector<double>& breaks) {
  const Vector2d way = second.centre - first.centre;
  const double square = way.squaredNorm();
  if (square == 0) return;
  const double share = (square + first.radius * first.radius - second.radius * second.radius) / (2 * square);
  const double across = first.radius * first.radius / square - share * share;
  if (across < 0) return;
  for (const double side : {-1., 1.})
    breaks.push_back(first.centre.x() + share * way.x() - side * std::sqrt(across) * way.y());
}

/// Returns, in ascending order, the x between `low` and `high` at which the limits of the chords are not smooth.
std::vector<double> breaksOf(const CommonDiscs& discs, double low, double high) {
  for (const Disc& disc : discs) {
    low = std::max(low, disc.centre.x() - disc.radius);
    high = std::min(high, disc.centre.x() + disc.radius);
  }
  if (low >= high) return {};
  std::vector<double> breaks{low, high};
  for (std::size_t k = 0; k < discs.size(); ++k)
    for (std::size_t other = 0; other < k; ++other) addMeetings(discs[k], discs[other], breaks);
  std::erase_if(breaks, [&](double x) { return x < low || x > high; });
  std::ranges::sort(breaks);
  return breaks;
}

/// Returns the probability of a point about the origin whose coordinates are independent.
RegionProbability probabilityAlongAxes(const CommonDiscs& discs, const Vector2d& sigma) {
  RegionProbability region;
  const auto add = [&](double x, double weight) {
    const Chord chord = chordAt(x, discs);
    const double z = x / sigma.x(), along = weight * density(z) / sigma.x();
    const double high = chord.high / sigma.y(), low = chord.low / sigma.y();
    const double inside = between(low, high), rise = (density(low) - density(high)) / sigma.y();
    region.p += along * inside;
    region.slope += along * Vector2d(z / sigma.x() * inside, rise);
    region.curvature(0, 0) += along * (z * z - 1) / (sigma.x() * sigma.x()) * inside;
    region.curvature(0, 1) += along * z / sigma.x() * rise;
    region.curvature(1, 1) += along * (low * density(low) - high * density(high)) / (sigma.y() * sigma.y());
  };
  const std::vector<double> breaks = breaksOf(discs, -kTails * sigma.x(), kTails * sigma.x());
  for (std::size_t k = 1; k < breaks.size(); ++k) {
    const Chord middle = chordAt((breaks[k - 1] + breaks[k]) / 2, discs);
    if (middle.low < middle.high) overNodes(breaks[k - 1], breaks[k], add);
  }
  region.curvature(1, 0) = region.curvature(0, 1);
  return region;
}

}  // namespace

CommonDiscs withoutRedundant(const CommonDiscs& discs) {
  CommonDiscs needed;
  const auto isIn = [](const Disc& inner, const Disc& outer) {
    return (inner.centre - outer.centre).norm() + inner.radius <= outer.radius;
  };
  for (const Disc& disc : discs) {
    if (std::ranges::any_of(needed, [&](const Disc& other) { return isIn(other, disc); })) continue;
    std::erase_if(needed, [&](const Disc& other) { return isIn(disc, other); });
    needed.push_back(disc);
  }
  return needed;
}

RegionProbability probabilityWithin(const CommonDiscs& discs, const Vector2d& mean, const Matrix2d& covariance) {
  Eigen::SelfAdjointEigenSolver<Matrix2d> axes;
  axes.computeDirect(covariance);
  const Matrix2d turn = axes.eigenvectors();
  const Vector2d sigma = axes.eigenvalues().cwiseSqrt();
  CommonDiscs near;  // discs whose rims come near the point, along the axes about its mean
  for (const Disc& disc : discs) {
    const Disc turned{turn.transpose() * (disc.centre - mean), disc.radius};
    const double margin = disc.radius - turned.centre.norm();
    if (disc.radius < 0 || margin <= -kTails * sigma.y()) return {};
    if (margin < kTails * sigma.y()) near.push_back(turned);
  }
  if (near.empty()) return {1, Vector2d::Zero(), Matrix2d::Zero()};
  const RegionProbability region = probabilityAlongAxes(near, sigma);
  return {region.p, turn * region.slope, turn * region.curvature * turn.transpose()};
}

}  // namespace tubeplan::calibration
