#include "calibration/watch/disc_probability.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <span>

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

double polynomial(std::span<const double> coefficients, double x) {
  double sum = 0;
  for (std::size_t k = coefficients.size(); k > 0; --k) sum = sum * x + coefficients[k - 1];
  return sum;
}

/// Modified Bessel functions of order 0 and 1, times exp(-x), for x of 0 or more (Abramowitz and Stegun 1964, 9.8.1 to
/// 9.8.4; relative error below 3e-7).
struct ScaledBessel {
  double zero, one;
};
ScaledBessel scaledBessel(double x) {
  constexpr double kLimit = 3.75;
  static constexpr double kZeroNear[] = {1, 3.5156229, 3.0899424, 1.2067492, 0.2659732, 0.0360768, 0.0045813};
  static constexpr double kOneNear[] = {0.5, 0.87890594, 0.51498869, 0.15084934, 0.02658733, 0.00301532, 0.00032411};
  static constexpr double kZeroFar[] = {0.39894228,  0.01328592, 0.00225319,  -0.00157565, 0.00916281,
                                        -0.02057706, 0.02635537, -0.01647633, 0.00392377};
  static constexpr double kOneFar[] = {0.39894228, -0.03988024, -0.00362018, 0.00163801, -0.01031555,
                                       0.02282967, -0.02895312, 0.01787654,  -0.00420059};
  if (x < kLimit) {
    const double t = x / kLimit, scale = std::exp(-x);
    return {scale * polynomial(kZeroNear, t * t), scale * x * polynomial(kOneNear, t * t)};
  }
  const double t = kLimit / x, scale = 1 / std::sqrt(x);
  return {scale * polynomial(kZeroFar, t), scale * polynomial(kOneFar, t)};
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
  if (lower <= 0 && upper > mean + kTails) return {1, 0};
  const double from = std::max({lower, mean - kTails, 0.}), to = std::min(upper, mean + kTails);
  RadialProbability ring;
  if (from >= to) return ring;
  overNodes<20>(from, to, [&](double r, double weight) {
    const ScaledBessel bessel = scaledBessel(r * mean);
    const double along = weight * r * std::exp(-(r - mean) * (r - mean) / 2);
    ring.p += along * bessel.zero;
    ring.slope += along * (r * bessel.one - mean * bessel.zero);
  });
  return ring;
}

}  // namespace tubeplan::calibration
