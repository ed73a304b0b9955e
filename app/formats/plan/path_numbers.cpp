#include "app/formats/plan/path_numbers.hpp"

#include "app/formats/checkpoint/plan_key.hpp"

namespace tubeplan::app {

void PathNumbers::add(double time, int segment, const Eigen::VectorXd& joints) {
  numbers_.push_back(time);
  numbers_.push_back(segment);
  numbers_.insert(numbers_.end(), joints.begin(), joints.end());
}

std::string PathNumbers::fingerprint() const {
  return numbersFingerprint(
      Eigen::Map<const Eigen::VectorXd>(numbers_.data(), static_cast<Eigen::Index>(numbers_.size())));
}

}  // namespace tubeplan::app
