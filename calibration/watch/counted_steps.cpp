#include "calibration/watch/counted_steps.hpp"

#include <algorithm>

namespace tubeplan::calibration {

using Eigen::Vector2d;

double midDepthOfLastStep(const tubesheets::SteppedTool& tool) {
  return tubesheets::middleOf(tool, tool.steps.size() - 1);
}

CountedSteps countedSteps(const tubesheets::SteppedTool& tool, const Vector2d& lean, double sigma, int entered) {
  CountedSteps count{entered, {{}}};
  const double depth = midDepthOfLastStep(tool);
  CommonDiscs discs;
  for (const tubesheets::Section& section : tubesheets::sectionsOf(tool)) {
    discs.push_back({(section.below - depth) * lean / sigma, section.tolerance / sigma});
    count.at_least.resize(section.step + 2);
    count.at_least.back() = withoutRedundant(discs);
  }
  count.at_least.push_back({{Vector2d::Zero(), -1}});
  return count;
}

RegionProbability probabilityOf(const CountedSteps& count, int entered, const Vector2d& mean,
                                const Eigen::Matrix2d& covariance) {
  const auto k = static_cast<std::size_t>(entered);
  const RegionProbability at_least = probabilityWithin(count.at_least[k], mean, covariance);
  const RegionProbability at_least_next = probabilityWithin(count.at_least[k + 1], mean, covariance);
  return {std::max(at_least.p - at_least_next.p, 0.), at_least.slope - at_least_next.slope,
          at_least.curvature - at_least_next.curvature};
}

}  // namespace tubeplan::calibration
