// How much a step at each reading, or a creep, would explain of what a fit leaves.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "calibration/measurement_checks/mistake.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

inline constexpr std::size_t kFewestOfStep = 4;  ///< readings before and behind

/// A step of one form where it explains most.
struct FoundStep {
  std::size_t form = 0, reading = 0;  ///< the first behind it
  double merit = 0;                   ///< log of the odds that it gains, less its price
  Eigen::VectorXd size;
};

/// The price of a step of so many numbers at one of the readings, as the log of odds.
[[nodiscard]] double priceOfStep(int numbers, const std::vector<Measurement>& readings);

class StepScan {
 public:
  /// At the state that a fit has found; `readings` and `forms` must outlive it. Not ok where the model cannot be
  /// evaluated.
  StepScan(PlacedArm fitted, const FreeChoice& open, const std::vector<Measurement>& readings,
           const std::vector<StepForm>& forms);

  [[nodiscard]] bool ok() const { return ok_; }
  /// The best step of each form, the best first.
  [[nodiscard]] std::vector<FoundStep> steps() const;
  /// The size of a step that suits best at that reading.
  [[nodiscard]] Eigen::VectorXd sizeAt(std::size_t form, std::size_t reading) const;
  /// What the best creep gains less its price, as a step's merit.
  [[nodiscard]] double bestCreep() const;

 private:
  struct Sums {
    Eigen::MatrixXd by_fit, by_step;
    Eigen::VectorXd residual;
  };
  struct Explained {
    double gain = 0;  ///< fall of half of chi-square
    Eigen::VectorXd size;
  };

  bool linearize(PlacedArm fitted, const FreeChoice& open);
  [[nodiscard]] std::optional<Explained> explained(const Sums& sums) const;
  [[nodiscard]] Sums sumsOf(const Eigen::MatrixXd& columns) const;
  [[nodiscard]] Eigen::MatrixXd creeping(std::size_t form, const std::vector<Eigen::VectorXd>& along) const;
  [[nodiscard]] std::vector<std::vector<Eigen::VectorXd>> courses(const StepForm& form) const;
  [[nodiscard]] bool isOf(const StepForm& form, std::size_t reading) const;
  [[nodiscard]] std::optional<FoundStep> bestStep(std::size_t form) const;
  /// Log of the odds that a fall of half of chi-square gains about an unknown scale, at least that of the noise.
  [[nodiscard]] double gainOf(double fall) const;

  const std::vector<Measurement>& readings_;
  const std::vector<StepForm>& forms_;
  bool ok_ = false;
  std::vector<int> first_row_;
  Eigen::VectorXd residual_, residual_by_fit_;
  Eigen::MatrixXd by_fit_;                ///< fitted numbers x rows, so that their squares are what the fit takes
  std::vector<Eigen::MatrixXd> by_step_;  ///< of each form, rows x numbers
};

}  // namespace tubeplan::calibration
