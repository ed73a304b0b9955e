// A count of the steps that entered a hole, as the regions in which the tool's offset lies.
//
// A step enters if both of its ends are within its tolerance of the hole's axis (tubesheets/stepped_tool.hpp). The
// offset counted is that of the section amid the last step, whose tolerance is the smallest. Errors of the tool's tilt
// move this section sideways. They move the ends of the step by at most half its length times the error more.
#pragma once

#include <vector>

#include "calibration/watch/disc_probability.hpp"
#include "tubesheets/stepped_tool.hpp"

namespace tubeplan::calibration {

struct CountedSteps {
  int entered = 0;
  /// Offsets at which k steps or more enter, in standard deviations, for k from 0 to one more than the tool has.
  std::vector<CommonDiscs> at_least;

  [[nodiscard]] int outcomes() const { return static_cast<int>(at_least.size()) - 1; }
};

/// Returns how far the section amid the last step is below the tip [m]; 0 for a tool without lengths.
[[nodiscard]] double midDepthOfLastStep(const tubesheets::SteppedTool& tool);

/// Returns a count for a tool with the tilt `lean`, in units of `sigma` [m]. The offset is that of the section at
/// midDepthOfLastStep().
[[nodiscard]] CountedSteps countedSteps(const tubesheets::SteppedTool& tool, const Eigen::Vector2d& lean, double sigma,
                                        int entered);

/// Returns the probability that exactly `entered` steps enter, for an offset with this mean and covariance.
[[nodiscard]] RegionProbability probabilityOf(const CountedSteps& count, int entered, const Eigen::Vector2d& mean,
                                              const Eigen::Matrix2d& covariance);

}  // namespace tubeplan::calibration
