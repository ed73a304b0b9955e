#include "calibration/statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <limits>

namespace tubeplan::calibration {

namespace {

namespace policies = boost::math::policies;

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// Policy to compute in double precision, several times faster than long double, which is Boost's default.
using Policy = policies::policy<policies::promote_double<false>>;
using ChiSquare = boost::math::chi_squared_distribution<double, Policy>;
using FisherF = boost::math::fisher_f_distribution<double, Policy>;

}  // namespace

double median(std::vector<double> values) {
  if (values.empty()) return kNothing;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<double> probabilitiesOf(const std::vector<double>& log_weights) {
  if (log_weights.empty()) return {};
  const double most = *std::ranges::max_element(log_weights);
  std::vector<double> probabilities;
  double total = 0;
  for (const double log : log_weights) total += probabilities.emplace_back(std::exp(log - most));
  for (double& probability : probabilities) probability /= total;
  return probabilities;
}

double chiSquareTail(double chi2, double degrees_of_freedom) {
  if (degrees_of_freedom <= 0 || std::isnan(chi2)) return kNothing;
  if (std::isinf(chi2)) return 0;
  return boost::math::cdf(boost::math::complement(ChiSquare(degrees_of_freedom), std::max(chi2, 0.)));
}

double chiSquareLowerTail(double chi2, double degrees_of_freedom) {
  if (degrees_of_freedom <= 0 || std::isnan(chi2)) return kNothing;
  if (std::isinf(chi2)) return 1;
  return boost::math::cdf(ChiSquare(degrees_of_freedom), std::max(chi2, 0.));
}

double chiSquareQuantile(double tail, double degrees_of_freedom) {
  return boost::math::quantile(boost::math::complement(ChiSquare(degrees_of_freedom), tail));
}

double ChiSquareLimit::operator()(int degrees_of_freedom) {
  const auto [known, is_new] = known_.try_emplace(degrees_of_freedom, 0);
  if (is_new) known->second = chiSquareQuantile(tail_, degrees_of_freedom);
  return known->second;
}

double medianOfMeanSquare(int count) {
  thread_local ChiSquareLimit median(0.5);
  return median(count) / count;
}

double fisherTail(double F, double freedom_above, double freedom_below) {
  return boost::math::cdf(boost::math::complement(FisherF(freedom_above, freedom_below), F));
}

}  // namespace tubeplan::calibration
