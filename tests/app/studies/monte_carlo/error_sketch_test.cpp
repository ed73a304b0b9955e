#include "app/studies/monte_carlo/error_sketch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tubeplan::app {
namespace {

std::vector<double> logNormalErrors(std::size_t count, std::uint64_t seed, double spread) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, spread);
  std::vector<double> errors;
  for (std::size_t k = 0; k < count; ++k) errors.push_back(1e-3 * std::exp(normal(random)));
  return errors;
}

ErrorSketch sketchOf(const std::vector<double>& errors) {
  ErrorSketch sketch;
  for (const double error : errors) sketch.add(ErrorSketch::unitsOf(error));
  return sketch;
}

TEST(ErrorSketch, QuantilesAreWithinAPartOfTheExactOnes) {
  for (const double spread : {0.1, 1., 3.}) {
    std::vector<double> errors = logNormalErrors(20011, 5, spread);
    const ErrorSketch sketch = sketchOf(errors);
    std::sort(errors.begin(), errors.end());
    for (const double share : {0., 0.01, 0.25, 0.5, 0.9, 0.95, 0.99, 0.999, 1.}) {
      const auto rank = static_cast<std::size_t>(std::max(1., std::ceil(share * 20011)));
      const double exact = errors[rank - 1];
      EXPECT_NEAR(sketch.quantile(share), exact, exact / ErrorSketch::kPartsOfOctave + ErrorSketch::kUnit)
          << share << " of spread " << spread;
    }
  }
}

TEST(ErrorSketch, MomentsAreThoseOfTheErrors) {
  const std::vector<double> errors = logNormalErrors(5000, 7, 0.7);
  const ErrorSketch sketch = sketchOf(errors);
  double sum = 0, squares = 0;
  for (const double error : errors) sum += error, squares += error * error;
  const double mean = sum / 5000;
  EXPECT_EQ(sketch.count(), 5000u);
  EXPECT_NEAR(sketch.mean(), mean, ErrorSketch::kUnit);
  EXPECT_NEAR(sketch.rms(), std::sqrt(squares / 5000), ErrorSketch::kUnit);
  EXPECT_NEAR(sketch.sigma(), std::sqrt((squares - 5000 * mean * mean) / 4999), 2 * ErrorSketch::kUnit);
  EXPECT_NEAR(sketch.max(), *std::max_element(errors.begin(), errors.end()), ErrorSketch::kUnit);
}

TEST(ErrorSketch, MergingIsAssociativeCommutativeAndAddsNothing) {
  const auto a = sketchOf(logNormalErrors(300, 1, 2)), b = sketchOf(logNormalErrors(1, 2, 2)),
             c = sketchOf(logNormalErrors(500, 3, 0.2)), none = ErrorSketch();
  const auto merged = [](ErrorSketch one, const ErrorSketch& other) {
    one.merge(other);
    return one;
  };
  EXPECT_EQ(merged(merged(a, b), c), merged(a, merged(b, c)));
  EXPECT_EQ(merged(a, c), merged(c, a));
  EXPECT_EQ(merged(a, none), a);
  EXPECT_EQ(merged(none, a), a);
  std::vector<double> all = logNormalErrors(300, 1, 2);
  for (const double error : logNormalErrors(500, 3, 0.2)) all.push_back(error);
  EXPECT_EQ(merged(a, c), sketchOf(all));
}

TEST(ErrorSketch, WordsBringItBack) {
  for (const auto& sketch : {sketchOf(logNormalErrors(400, 9, 3)), ErrorSketch(), sketchOf({0., 0., 1e9})}) {
    TallyWords words;
    sketch.put(words);
    WordReader reader(words);
    EXPECT_EQ(ErrorSketch::read(reader), sketch);
    EXPECT_TRUE(reader.isWhole());
    if (words.size() < 2) continue;
    words.pop_back();
    WordReader cut(words);
    (void)ErrorSketch::read(cut);
    EXPECT_FALSE(cut.isWhole());
  }
}

TEST(ErrorSketch, EverySizeHasOnePartThatHoldsIt) {
  // The errors are all powers of two up to half of the largest error, each with both its neighbours.
  for (int power = 0; power < 43; ++power)
    for (const int offset : {-1, 0, 1}) {
      const std::uint64_t units = (std::uint64_t{1} << power) + static_cast<std::uint64_t>(offset);
      ErrorSketch sketch;
      sketch.add(units);
      const auto points = sketch.distribution();
      ASSERT_EQ(points.size(), 1u);
      // The upper end of the bin is limited to the largest error added.
      EXPECT_EQ(points[0].error, static_cast<double>(units) * ErrorSketch::kUnit);
      EXPECT_EQ(sketch.quantile(0.5), points[0].error);
    }
  EXPECT_EQ(ErrorSketch::unitsOf(1e300), ErrorSketch::unitsOf(ErrorSketch::kLargest));
  EXPECT_TRUE(std::isnan(ErrorSketch().mean()));
  EXPECT_TRUE(std::isnan(ErrorSketch().quantile(0.5)));
}

}  // namespace
}  // namespace tubeplan::app
