#include "calibration/statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <limits>

namespace tubeplan::calibration {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double median(std::vector<double> values) {
  if (values.empty()) return kNothing;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double chiSquareTail(double chi2, double degrees_of_freedom) {
  if (degrees_of_freedom <= 0 || std::isnan(chi2)) return kNothing;
  if (std::isinf(chi2)) return 0;
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(degrees_of_freedom), std::max(chi2, 0.)));
}

double chiSquareLowerTail(double chi2, double degrees_of_freedom) {
  if (degrees_of_freedom <= 0 || std::isnan(chi2)) return kNothing;
  if (std::isinf(chi2)) return 1;
  return boost::math::cdf(boost::math::chi_squared(degrees_of_freedom), std::max(chi2, 0.));
}

double chiSquareQuantile(double tail, double degrees_of_freedom) {
  return boost::math::quantile(boost::math::complement(boost::math::chi_squared(degrees_of_freedom), tail));
}

double medianOfMeanSquare(int count) { return chiSquareQuantile(0.5, count) / count; }

double fisherTail(double F, double freedom_above, double freedom_below) {
  return boost::math::cdf(boost::math::complement(boost::math::fisher_f(freedom_above, freedom_below), F));
}

}  // namespace tubeplan::calibration
