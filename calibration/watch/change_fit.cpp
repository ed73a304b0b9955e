#include "calibration/watch/change_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector2d, Eigen::VectorXd;

namespace {

constexpr int kFitSteps = 25;         // maximum number of steps of a fit
constexpr double kFitSettled = 0.02;  // decrease of the deviance below which a fit ends

/// Negative log probability of a count at an offset, with its derivatives: the second one is the square of the first
/// along it and, as far as it is positive, the true one across it.
struct CountCost {
  double cost = 0;
  Vector2d slope = Vector2d::Zero();
  Eigen::Matrix2d curvature = Eigen::Matrix2d::Zero();
};
CountCost countCost(const CountedSteps& count, int entered, const Vector2d& offset) {
  const RegionProbability counted = probabilityOf(count, entered, offset, Eigen::Matrix2d::Identity());
  const double p = (1 - kBlunder) * counted.p + kBlunder;
  const Vector2d slope = -(1 - kBlunder) / p * counted.slope;
  const Vector2d across = Vector2d(-slope.y(), slope.x()).normalized();
  const double bend = std::max(0., -(1 - kBlunder) / p * across.dot(counted.curvature * across));
  return {-std::log(p), slope, slope * slope.transpose() + bend * across * across.transpose()};
}

/// Returns the radius of the smallest of the discs; infinite if there are none.
double smallestRadius(const CommonDiscs& discs) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Disc& disc : discs) smallest = std::min(smallest, disc.radius);
  return smallest;
}

/// Returns the distance from the axis that a count suggests.
double middleOf(const CountedSteps& count) {
  const auto k = static_cast<std::size_t>(count.entered);
  const double lower = smallestRadius(count.at_least[k + 1]), upper = smallestRadius(count.at_least[k]);
  return lower > 0 ? std::min((lower + upper) / 2, 2 * lower) : upper / 2;
}

}  // namespace

/// Normal equations of the measured values and priors, and the rows of the counts.
struct ChangeFitter::Problem {
  struct Count {
    const CountedSteps* steps;
    Vector2d u;  // offset at y = 0
    Eigen::Matrix<double, 2, Eigen::Dynamic> A;
  };
  Index errors = 0, numbers = 0;
  MatrixXd N;  // half the second derivatives of the deviance without counts
  VectorXd b;  // half the first derivatives at y = 0
  double c = 0;
  std::vector<Count> counts;

  [[nodiscard]] double measuredAt(const VectorXd& y) const { return y.dot(N * y) + 2 * b.dot(y) + c; }
  [[nodiscard]] double at(const VectorXd& y) const {
    double sum = measuredAt(y);
    for (const Count& count : counts)
      sum += 2 * countCost(*count.steps, count.steps->entered, count.u + count.A * y).cost;
    return sum;
  }

  /// Adds the counts' parts to half the derivatives of the deviance.
  void addCounts(const VectorXd& y, MatrixXd& curvature, VectorXd& slope) const {
    for (const Count& count : counts) {
      const CountCost cost = countCost(*count.steps, count.steps->entered, count.u + count.A * y);
      slope += count.A.transpose() * cost.slope;
      curvature += count.A.transpose() * cost.curvature * count.A;
    }
  }

  [[nodiscard]] VectorXd settle(VectorXd y) const {
    if (counts.empty()) return -N.ldlt().solve(b);
    double value = at(y), damping = 1e-3;
    for (int step = 0; step < kFitSteps; ++step) {
      MatrixXd curvature = N;
      VectorXd slope = N * y + b;
      addCounts(y, curvature, slope);
      bool is_lower = false;
      for (; damping < 1e6 && !is_lower; damping *= is_lower ? 0.2 : 5) {
        MatrixXd damped = curvature;
        damped.diagonal() *= 1 + damping;
        const VectorXd next = y - damped.ldlt().solve(slope);
        const double lower = at(next);
        is_lower = lower < value;
        if (!is_lower) continue;
        const double fall = value - lower;
        y = next;
        value = lower;
        if (fall < kFitSettled) return y;
      }
      if (!is_lower) break;
    }
    return y;
  }
};

ChangeFitter::ChangeFitter(const WatchedRows& rows, const ErrorState& before, int start, int last, ChangeCourse course)
    : rows_(rows), start_(start), last_(last), course_(course), mean_(before.mean) {
  const Index n = mean_.size();
  const Eigen::LLT<MatrixXd> covariance(before.covariance);
  prior_ = covariance.solve(MatrixXd::Identity(n, n));
  before_ = before.deviance + logDeterminant(covariance);
  measured_xx_ = MatrixXd::Zero(n, n);
  int counts = 0;
  for (int k = start; k <= last; ++k) {
    const auto H = rows.H.middleRows(rows.first(k), rows.rowsOf(k));
    if (!rows.isCounted(k)) {
      measured_xx_ += H.transpose() * H;
      continue;
    }
    reach_ += middleOf(*rows.counted[static_cast<std::size_t>(k)]);
    ++counts;
  }
  if (counts > 0) reach_ /= counts;
}

double courseAt(ChangeCourse course, int k, int start, int last) {
  return course == ChangeCourse::kStep ? 1 : static_cast<double>(k - start + 1) / (last - start + 1);
}

double ChangeFitter::devianceOf(int k, const VectorXd& u) const {
  if (!rows_.isCounted(k)) return u.squaredNorm();
  const CountedSteps& count = *rows_.counted[static_cast<std::size_t>(k)];
  return 2 * countCost(count, count.entered, u).cost;
}

int ChangeFitter::bestStart(const std::vector<int>& columns, const ChangeFit& fit, int first, int last) const {
  std::vector<VectorXd> unchanged, change;
  std::vector<double> deviance;
  for (int k = first; k <= last_; ++k) {
    const auto own = Eigen::seqN(rows_.first(k), rows_.rowsOf(k));
    unchanged.emplace_back(rows_.r(own) + rows_.H(own, Eigen::all) * fit.errors);
    change.emplace_back(rows_.changes(own, columns) * fit.numbers);
    deviance.push_back(devianceOf(k, unchanged.back()));
  }
  int best = start_;
  double most = -std::numeric_limits<double>::infinity();
  for (int start = first; start <= last; ++start) {
    double gain = 0;
    for (int k = start; k <= last_; ++k) {
      const auto at = static_cast<std::size_t>(k - first);
      gain += deviance[at] - devianceOf(k, unchanged[at] + courseAt(course_, k, start, last_) * change[at]);
    }
    if (gain <= most) continue;
    most = gain;
    best = start;
  }
  return best;
}

ChangeFitter::Problem ChangeFitter::problemOf(const std::vector<int>& columns) const {
  Problem problem;
  problem.errors = mean_.size();
  problem.numbers = static_cast<Index>(columns.size());
  const Index n = problem.errors, d = problem.numbers;
  problem.N = MatrixXd::Zero(n + d, n + d);
  problem.N.topLeftCorner(n, n) = prior_ + measured_xx_;
  problem.N.bottomRightCorner(d, d).setIdentity();
  problem.b = VectorXd::Zero(n + d);
  for (int k = start_; k <= last_; ++k) {
    const Index first = rows_.first(k), count = rows_.rowsOf(k);
    const auto H = rows_.H.middleRows(first, count);
    const VectorXd u = rows_.r.segment(first, count) + H * mean_;
    MatrixXd C(count, d);
    for (Index c = 0; c < d; ++c)
      C.col(c) = courseAt(course_, k, start_, last_) *
                 rows_.changes.col(columns[static_cast<std::size_t>(c)]).segment(first, count);
    if (rows_.isCounted(k)) {
      Problem::Count counted{&*rows_.counted[static_cast<std::size_t>(k)], u, {}};
      counted.A.resize(2, n + d);
      counted.A << H, C;
      problem.counts.push_back(std::move(counted));
      continue;
    }
    problem.N.topRightCorner(n, d) += H.transpose() * C;
    problem.N.bottomRightCorner(d, d) += C.transpose() * C;
    problem.b.head(n) += H.transpose() * u;
    problem.b.tail(d) += C.transpose() * u;
    problem.c += u.squaredNorm();
  }
  problem.N.bottomLeftCorner(d, n) = problem.N.topRightCorner(n, d).transpose();
  return problem;
}

/// Returns the start values of a fit: no change and, because counts state only distances, changes of both signs of each
/// number and of each two numbers that cause offsets of the counted magnitude.
std::vector<VectorXd> ChangeFitter::startsOf(const Problem& problem) const {
  std::vector<VectorXd> starts{VectorXd::Zero(problem.errors + problem.numbers)};
  if (problem.counts.empty()) return starts;
  std::vector<VectorXd> alone;  // change of one number that causes offsets of the counted magnitude
  for (Index c = 0; c < problem.numbers; ++c) {
    double square = 0;
    for (const auto& count : problem.counts) square += count.A.col(problem.errors + c).squaredNorm();
    const double size = std::sqrt(square / static_cast<double>(problem.counts.size()));
    if (size > 0) alone.push_back(reach_ / size * VectorXd::Unit(problem.errors + problem.numbers, problem.errors + c));
  }
  for (std::size_t c = 0; c < alone.size(); ++c)
    for (const double side : {-1., 1.}) {
      starts.push_back(side * alone[c]);
      for (std::size_t other = 0; other < c; ++other)
        for (const double way : {-1., 1.})
          starts.push_back((side * alone[c] + way * alone[other]) * std::numbers::sqrt2 / 2);
    }
  return starts;
}

std::optional<ChangeFit> ChangeFitter::fit(const std::vector<int>& columns, const NumberBounds& bounds,
                                           const VectorXd& near) const {
  const Problem problem = problemOf(columns);
  std::vector<VectorXd> starts;
  if (near.size() == 0 || problem.counts.empty()) {
    starts = startsOf(problem);
  } else {
    starts.push_back(VectorXd::Zero(problem.errors + problem.numbers));
    starts.back().tail(problem.numbers) = near;
  }
  VectorXd best;
  double least = std::numeric_limits<double>::infinity();
  for (const VectorXd& start : starts) {
    const VectorXd y = problem.settle(start);
    if (problem.numbers > 0 && !bounds.contain(y.tail(problem.numbers))) continue;
    const double value = problem.at(y);
    if (value >= least) continue;
    least = value;
    best = y;
  }
  if (best.size() == 0) return std::nullopt;
  return resultOf(problem, best);
}

ChangeFit ChangeFitter::resultOf(const Problem& problem, const VectorXd& y) const {
  ChangeFit fit;
  const Index n = problem.errors, d = problem.numbers;
  fit.measured_chi2 = problem.measuredAt(y);
  for (int k = start_; k <= last_; ++k)
    if (!rows_.isCounted(k)) fit.measured_rows += static_cast<int>(rows_.rowsOf(k));
  fit.errors = y.head(n);
  fit.numbers = y.tail(d);
  MatrixXd curvature = problem.N;
  VectorXd slope = VectorXd::Zero(n + d);
  problem.addCounts(y, curvature, slope);
  const Eigen::LLT<MatrixXd> of_errors(curvature.topLeftCorner(n, n));
  fit.deviance = before_ + problem.at(y) + logDeterminant(of_errors);
  if (d > 0)
    fit.information = curvature.bottomRightCorner(d, d) -
                      curvature.bottomLeftCorner(d, n) * of_errors.solve(curvature.topRightCorner(n, d));
  double excess = 0, variance = 0;
  for (const auto& count : problem.counts) {
    const Vector2d offset = count.u + count.A * y;
    double mean = 0, square = 0;
    for (int entered = 0; entered < count.steps->outcomes(); ++entered) {
      const double cost = 2 * countCost(*count.steps, entered, offset).cost, p = std::exp(-cost / 2);
      mean += p * cost;
      square += p * cost * cost;
    }
    excess += 2 * countCost(*count.steps, count.steps->entered, offset).cost - mean;
    variance += std::max(square - mean * mean, 0.);
  }
  fit.counts_excess = variance > 0 ? excess / std::sqrt(variance) : 0;
  return fit;
}

}  // namespace tubeplan::calibration
