#include "calibration/watch/disc_probability.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

namespace tubeplan::calibration {

namespace {

using Eigen::Matrix2d, Eigen::Vector2d;

constexpr double kTails = 6;  // standard deviations beyond which a density counts as zero

double density(double z) { return std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi); }

/// Returns the probability that a standard normal variable lies between the limits, without cancellation in the tails.
double between(double low, double high) {
  if (low > 0) return between(-high, -low);
  return (std::erfc(-high / std::numbers::sqrt2) - std::erfc(-low / std::numbers::sqrt2)) / 2;
}

/// Calls `add(place, weight)` at the nodes of a Gauss rule for integrals over [low, high].
template <int Nodes, class Add>
void overNodes(double low, double high, const Add& add) {
  using Rule = boost::math::quadrature::gauss<double, Nodes>;
  const double middle = (low + high) / 2, half = (high - low) / 2;
  for (std::size_t k = 0; k < Rule::abscissa().size(); ++k)
    for (const double side : {-1., 1.}) add(middle + side * half * Rule::abscissa()[k], half * Rule::weights()[k]);
}

/// Calls `add(u, w, weight)` for chords of a disc: u is the chord's distance from the centre, w half its length. Only
/// chords within kTails standard deviations of `mean` count.
template <int Nodes, class Add>
void overChords(double radius, double mean, double sigma, const Add& add) {
  const double from = std::clamp((mean - kTails * sigma) / radius, -1., 1.);
  const double to = std::clamp((mean + kTails * sigma) / radius, -1., 1.);
  if (from >= to) return;
  overNodes<Nodes>(std::asin(from), std::asin(to), [&](double angle, double weight) {
    add(radius * std::sin(angle), radius * std::cos(angle), weight * radius * std::cos(angle));
  });
}

/// Returns the probability of the disc in the principal axes of the covariance.
RegionProbability discAlongAxes(double radius, const Vector2d& mean, const Vector2d& sigma) {
  RegionProbability disc;
  overChords<30>(radius, mean.x(), sigma.x(), [&](double u, double w, double weight) {
    const double z = (u - mean.x()) / sigma.x();
    const double along = weight * density(z) / sigma.x();
    const double high = (w - mean.y()) / sigma.y(), low = (-w - mean.y()) / sigma.y();
    const double inside = between(low, high), rise = (density(low) - density(high)) / sigma.y();
    disc.p += along * inside;
    disc.slope += along * Vector2d(z / sigma.x() * inside, rise);
    disc.curvature(0, 0) += along * (z * z - 1) / (sigma.x() * sigma.x()) * inside;
    disc.curvature(0, 1) += along * z / sigma.x() * rise;
    disc.curvature(1, 1) += along * (low * density(low) - high * density(high)) / (sigma.y() * sigma.y());
  });
  disc.curvature(1, 0) = disc.curvature(0, 1);
  return disc;
}

RadialProbability radialDisc(double radius, double mean) {
  if (mean < radius - kTails) return {1, 0};
  RadialProbability disc;
  overChords<14>(radius, mean, 1, [&](double u, double w, double weight) {
    const double along = weight * density(u - mean) * std::erf(w / std::numbers::sqrt2);
    disc.p += along;
    disc.slope += along * (u - mean);
  });
  return disc;
}

}  // namespace

RegionProbability ringProbability(double lower, double upper, const Vector2d& mean, const Matrix2d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Matrix2d> axes(covariance);
  const Matrix2d turn = axes.eigenvectors();
  const Vector2d along = turn.transpose() * mean, sigma = axes.eigenvalues().cwiseSqrt();
  RegionProbability ring{1, Vector2d::Zero(), Matrix2d::Zero()};
  if (std::isfinite(upper)) ring = discAlongAxes(upper, along, sigma);
  if (lower > 0) {
    const RegionProbability hole = discAlongAxes(lower, along, sigma);
    ring = {ring.p - hole.p, ring.slope - hole.slope, ring.curvature - hole.curvature};
  }
  return {std::max(ring.p, 0.), turn * ring.slope, turn * ring.curvature * turn.transpose()};
}

RadialProbability ringProbability(double lower, double upper, double mean) {
  RadialProbability ring{1, 0};
  if (std::isfinite(upper)) ring = radialDisc(upper, mean);
  if (lower > 0) {
    const RadialProbability hole = radialDisc(lower, mean);
    ring = {ring.p - hole.p, ring.slope - hole.slope};
  }
  return {std::max(ring.p, 0.), ring.slope};
}

}  // namespace tubeplan::calibration
