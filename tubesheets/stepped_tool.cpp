#include "tubesheets/stepped_tool.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>

namespace tubeplan::tubesheets {
namespace {

constexpr double kTail = 9;  // half the range of integration in standard deviations; the probability beyond is 1e-19
// width, as a fraction of the radius, below which distributions are treated as a line or a point
constexpr double kNoWidth = 1e-14;
// A variance that should be zero may be negative by this fraction of the larger variance, because of rounding.
constexpr double kRoundOff = 1e-12;
constexpr double kQuadrature = 1e-12;  // largest absolute error of the integral over each piece
constexpr int kDeepest = 14;           // largest number of times that a piece is bisected
// the same for a tilted tool: its integrand has corners, so more bisections do not help
constexpr int kDeepestLeaning = 3;

// The offset's distribution along its principal axes; `wide` is the axis with the larger standard deviation [m].
struct PrincipalOffset {
  double wide_mean, wide_sigma, thin_mean, thin_sigma;
};

std::optional<PrincipalOffset> findPrincipalOffset(const Eigen::Vector2d& mean, const Eigen::Matrix2d& covariance) {
  if (!mean.allFinite() || !covariance.allFinite()) return std::nullopt;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes((covariance + covariance.transpose()) / 2);
  const Eigen::Vector2d variances = axes.eigenvalues();  // in ascending order
  if (variances[0] < -kRoundOff * std::abs(variances[1])) return std::nullopt;
  const Eigen::Vector2d along = axes.eigenvectors().transpose() * mean;
  return PrincipalOffset{along[1], std::sqrt(std::max(0.0, variances[1])), along[0],
                         std::sqrt(std::max(0.0, variances[0]))};
}

// Returns P(-half <= X <= half) of a normal X, computed from the tails on the mean's side so that no digits cancel.
double probabilityOfBand(double half, double mean, double sigma) {
  const double scale = sigma * std::numbers::sqrt2, near = std::abs(mean);
  return (std::erfc((near - half) / scale) - std::erfc((near + half) / scale)) / 2;
}

// Integrates by bisecting the interval until the error is below an absolute tolerance. Boost's own refinement uses a
// tolerance relative to each piece, which never terminates on pieces with an integral near zero. Its error estimate is
// correct on [-1, 1] only.
template <class Function>
double integrate(const Function& function, double from, double to, int depth = kDeepest) {
  const double middle = (from + to) / 2, half = (to - from) / 2;
  const auto scaled = [&](double u) { return half * function(middle + half * u); };
  double error = 0;
  const double sum = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(scaled, -1.0, 1.0, 0, 0.0, &error);
  if (error <= kQuadrature || depth == 0) return sum;
  return integrate(function, from, middle, depth - 1) + integrate(function, middle, to, depth - 1);
}

// Integrates the probability within the disc over strips perpendicular to the thin axis, at y = mean + u sigma, |u| <=
// kTail. If the range ends at the disc's rim, the half-length of a strip contains a square root, which the substitution
// u = middle + span sin(turn) removes.
double integrateStrips(double radius, const PrincipalOffset& offset) {
  const double mean = offset.thin_mean, sigma = offset.thin_sigma;
  const double lowest = std::max(-kTail, (-radius - mean) / sigma), highest = std::min(kTail, (radius - mean) / sigma);
  if (lowest >= highest) return 0;
  const double middle = (lowest + highest) / 2, span = (highest - lowest) / 2;
  const auto strip = [&](double turn) {
    const double u = middle + span * std::sin(turn);
    const double half = std::sqrt(std::max(0.0, ((radius - mean) - u * sigma) * ((radius + mean) + u * sigma)));
    const double density = std::exp(-u * u / 2) / std::sqrt(2 * std::numbers::pi);
    return density * probabilityOfBand(half, offset.wide_mean, offset.wide_sigma) * span * std::cos(turn);
  };
  double sum = 0;
  for (int piece = -2; piece < 2; ++piece)
    sum += integrate(strip, piece * std::numbers::pi / 4, (piece + 1) * std::numbers::pi / 4);
  return std::clamp(sum, 0.0, 1.0);
}

// Returns the probability that all sections of a tool with the tilt `lean` are within their tolerances, for a normally
// distributed offset of the tip, integrated over strips along the direction of the tilt. That direction is the first
// component of `mean` and `covariance`.
double probabilityWithinAll(std::span<const Section> sections, double lean, const Eigen::Vector2d& mean,
                            const Eigen::Matrix2d& covariance) {
  double across = std::numeric_limits<double>::infinity();
  for (const Section& section : sections) across = std::min(across, section.tolerance);
  const double thin = kNoWidth * across;
  const double sigma = std::max(std::sqrt(std::max(0.0, covariance(1, 1))), thin);
  const double slope = covariance(0, 1) / (sigma * sigma);
  const double conditional_sigma =
      std::max(std::sqrt(std::max(0.0, covariance(0, 0) - slope * covariance(0, 1))), thin);
  const double lowest = std::max(mean[1] - kTail * sigma, -across), highest = std::min(mean[1] + kTail * sigma, across);
  if (lowest >= highest) return 0;
  const double middle = (lowest + highest) / 2, span = (highest - lowest) / 2;
  const auto strip = [&](double turn) {
    const double v = middle + span * std::sin(turn), u = (v - mean[1]) / sigma;
    double from = -std::numeric_limits<double>::infinity(), to = -from;
    for (const Section& section : sections) {
      const double half = std::sqrt(std::max(0.0, (section.tolerance - v) * (section.tolerance + v)));
      from = std::max(from, section.below * lean - half);
      to = std::min(to, section.below * lean + half);
    }
    if (from >= to) return 0.0;
    const double half = (to - from) / 2, centre = mean[0] + slope * (v - mean[1]) - (from + to) / 2;
    const double density = std::exp(-u * u / 2) / (sigma * std::sqrt(2 * std::numbers::pi));
    return density * probabilityOfBand(half, centre, conditional_sigma) * span * std::cos(turn);
  };
  double sum = 0;
  for (int piece = -2; piece < 2; ++piece)
    sum += integrate(strip, piece * std::numbers::pi / 4, (piece + 1) * std::numbers::pi / 4, kDeepestLeaning);
  return std::clamp(sum, 0.0, 1.0);
}

}  // namespace

std::vector<std::string> stepWords(const SteppedTool& tool) {
  constexpr std::array kNumbers{"no", "one", "two", "three", "four", "five", "six", "seven", "eight"};
  std::vector<std::string> words;
  for (std::size_t entered = 0; entered <= tool.steps.size(); ++entered) {
    const std::string number = entered < kNumbers.size() ? kNumbers[entered] : std::to_string(entered);
    const bool is_all = entered > 1 && entered == tool.steps.size();
    words.push_back((is_all ? "all " : "") + number + (entered < 2 ? " step enters" : " steps enter"));
  }
  return words;
}

std::vector<Section> sectionsOf(const SteppedTool& tool) {
  const bool has_lengths = tool.lengths.size() == tool.steps.size();
  std::vector<Section> sections;
  double below = 0;
  for (std::size_t k = 0; k < tool.steps.size(); ++k) {
    sections.push_back({k, below, tool.steps[k].tolerance});
    if (!has_lengths) continue;
    below += tool.lengths[k];
    sections.push_back({k, below, tool.steps[k].tolerance});
  }
  return sections;
}

double middleOf(const SteppedTool& tool, std::size_t step) {
  const auto sections = sectionsOf(tool);
  const auto [first, last] = std::ranges::equal_range(sections, step, {}, &Section::step);
  return (first->below + std::prev(last)->below) / 2;
}

int stepsInserted(const SteppedTool& tool, const Eigen::Vector2d& offset, const Eigen::Vector2d& lean) {
  const auto sections = sectionsOf(tool);
  const auto stuck = std::ranges::find_if(
      sections, [&](const Section& section) { return !((offset - section.below * lean).norm() <= section.tolerance); });
  return static_cast<int>(stuck == sections.end() ? tool.steps.size() : stuck->step);
}

int stepsInserted(const SteppedTool& tool, double centring_error) {
  const auto stuck = std::find_if(tool.steps.begin(), tool.steps.end(),
                                  [&](const Step& step) { return !(centring_error <= step.tolerance); });
  return static_cast<int>(stuck - tool.steps.begin());
}

double probabilityWithin(double radius, const Eigen::Vector2d& mean_offset, const Eigen::Matrix2d& covariance) {
  const std::optional<PrincipalOffset> offset = findPrincipalOffset(mean_offset, covariance);
  if (!offset || std::isnan(radius)) return std::numeric_limits<double>::quiet_NaN();
  if (radius < 0) return 0;
  if (std::isinf(radius)) return 1;
  if (offset->wide_sigma <= kNoWidth * radius) return mean_offset.norm() <= radius ? 1 : 0;
  if (offset->thin_sigma > kNoWidth * radius) return radius == 0 ? 0 : integrateStrips(radius, *offset);
  if (std::abs(offset->thin_mean) > radius) return 0;
  const double half = std::sqrt((radius - offset->thin_mean) * (radius + offset->thin_mean));
  return probabilityOfBand(half, offset->wide_mean, offset->wide_sigma);
}

double toleratedTilt(const SteppedTool& tool) {
  const bool is_stated = !tool.steps.empty() && !tool.lengths.empty();
  return is_stated ? std::atan2(tool.steps.front().tolerance, tool.lengths.front())
                   : std::numeric_limits<double>::infinity();
}

double playInTube(const SteppedTool& tool, const Eigen::Vector2d& offset, const Eigen::Vector2d& lean, double depth) {
  // Tolerance [m] for a step that ends exactly at the face: it is not counted as entered.
  constexpr double kAtFace = 1e-6;
  double least = std::numeric_limits<double>::infinity(), from = 0;
  for (std::size_t k = 0; k < tool.steps.size() && from + kAtFace < depth; ++k) {
    const bool is_last = tool.lengths.empty() || k + 1 == tool.steps.size();
    const double to = is_last ? depth : std::min(depth, from + tool.lengths[k]);
    for (const double below : {from, to})  // check both ends of the section: one of them is farthest from the axis
      least = std::min(least, tool.steps[k].tolerance - (offset - below * lean).norm());
    from = to;
  }
  return least;
}

std::vector<double> probabilityBySteps(const SteppedTool& tool, const Eigen::Vector2d& mean_offset,
                                       const Eigen::Matrix2d& covariance, const Eigen::Vector2d& lean) {
  const double size = lean.norm();
  const bool leans = size > 0 && tool.lengths.size() == tool.steps.size();
  const Eigen::Vector2d along = leans ? Eigen::Vector2d(lean / size) : Eigen::Vector2d::UnitX();
  const Eigen::Matrix2d turn = (Eigen::Matrix2d() << along.x(), along.y(), -along.y(), along.x()).finished();
  const std::vector<Section> all = sectionsOf(tool);
  // at_least[k]: probability that the first k steps enter; without a tilt, the tightest of these steps decides.
  std::vector<double> at_least{findPrincipalOffset(mean_offset, covariance) ? 1
                                                                            : std::numeric_limits<double>::quiet_NaN()};
  double tightest = std::numeric_limits<double>::infinity();
  for (const Step& step : tool.steps) {
    tightest = std::min(tightest, step.tolerance);
    const bool is_known = !std::isnan(at_least.front());
    const std::span sections(all.data(), leans ? 2 * at_least.size() : 0);  // both ends of the steps so far
    at_least.push_back(leans && is_known ? probabilityWithinAll(sections, size, turn * mean_offset,
                                                                turn * covariance * turn.transpose())
                                         : probabilityWithin(tightest, mean_offset, covariance));
  }
  for (std::size_t k = 0; k + 1 < at_least.size(); ++k) at_least[k] -= std::min(at_least[k], at_least[k + 1]);
  return at_least;
}

}  // namespace tubeplan::tubesheets
