#include "calibration/estimation/evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "calibration/estimation/held_out.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

namespace {

constexpr int kLeastPostures = 4;
constexpr int kLeastFreedom = 6;
constexpr double kTooGood = 1e-6;  // lower-tail probability of chi-square below which a fit is too good
// A fit is reported as too good only if residuals are below this fraction of the stated noise. A ratio closer to 1 may
// be due to a rounded sigma.
constexpr double kFarTooGood = 0.5;

std::string plural(int count, const char* noun) { return std::to_string(count) + " " + noun + (count == 1 ? "" : "s"); }

}  // namespace

std::optional<EvidenceProblem> findLackOfFreedom(const std::vector<Measurement>& measurements, int degrees_of_freedom,
                                                 int numbers_determined) {
  const auto groups = groupByPose(measurements);
  const int postures = groups.empty() ? 0 : *std::ranges::max_element(groups) + 1;
  const int needed = std::max(kLeastPostures, numbers_determined / 2 + 1);
  if (postures >= needed && degrees_of_freedom >= kLeastFreedom) return std::nullopt;
  return EvidenceProblem{plural(static_cast<int>(measurements.size()), "reading") + " at " +
                             plural(postures, "posture") + " determine " + plural(numbers_determined, "number") +
                             " and leave " + plural(std::max(0, degrees_of_freedom), "degree") +
                             " of freedom to test the model",
                         "readings at " + std::to_string(std::max(needed, postures + 1)) + " postures or more"};
}

std::optional<EvidenceProblem> findOverstatedNoise(double chi2, int degrees_of_freedom) {
  if (degrees_of_freedom <= 0 || !std::isfinite(chi2)) return std::nullopt;
  const double ratio = std::sqrt(std::max(0., chi2) / degrees_of_freedom);
  if (ratio > kFarTooGood) return std::nullopt;
  if (chiSquareLowerTail(chi2, degrees_of_freedom) > kTooGood) return std::nullopt;
  return EvidenceProblem{
      fmt::format("the readings agree with the model {:.3g} times better than their stated noise allows",
                  1 / std::max(ratio, 1e-9)),
      "the actual noise of the readings: are sigma and its unit right?"};
}

}  // namespace tubeplan::calibration
