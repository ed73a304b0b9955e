// Search for a step, or for a gradual change (creep), in the errors of a fit. A step is tried at every measurement.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "calibration/measurement_checks/mistake.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

inline constexpr std::size_t kFewestOfStep = 4;  ///< smallest number of measurements before and after a step

/// Best step of one form, with the measurement at which it begins and the size of each of its parameters.
struct FoundStep {
  std::size_t form = 0, measurement = 0;  ///< indices of the form and of the first measurement after the step
  double merit = 0;                       ///< log odds gained, minus the penalty of the step
  Eigen::VectorXd size;
};

/// Returns the penalty, in log odds, of a step with `numbers` parameters that may begin at any of the measurements.
[[nodiscard]] double priceOfStep(int numbers, const std::vector<Measurement>& measurements);

class StepScan {
 public:
  /// Linearises the model at the state of a fit. `measurements` and `forms` must outlive the object. ok() is false if
  /// the model cannot be evaluated or there are too few measurements.
  StepScan(PlacedArm fitted, const FreeChoice& open, const std::vector<Measurement>& measurements,
           const std::vector<StepForm>& forms);

  [[nodiscard]] bool ok() const { return ok_; }
  /// Returns the best step of each form, most probable first.
  [[nodiscard]] std::vector<FoundStep> steps() const;
  /// Returns the least-squares size of a step of this form that begins at this measurement.
  [[nodiscard]] Eigen::VectorXd sizeAt(std::size_t form, std::size_t measurement) const;
  /// Returns the log odds gained by the best creep, minus its penalty; comparable with FoundStep::merit.
  [[nodiscard]] double bestDrift() const;

 private:
  struct Sums {
    Eigen::MatrixXd by_fit, by_step;
    Eigen::VectorXd residual;
  };
  struct Explained {
    double gain = 0;  ///< decrease of half of chi-square
    Eigen::VectorXd size;
  };

  bool linearize(PlacedArm fitted, const FreeChoice& open);
  [[nodiscard]] std::optional<Explained> explained(const Sums& sums) const;
  [[nodiscard]] Sums sumsOf(const Eigen::MatrixXd& columns) const;
  [[nodiscard]] Eigen::MatrixXd driftColumns(std::size_t form, const std::vector<Eigen::VectorXd>& along) const;
  [[nodiscard]] std::vector<std::vector<Eigen::VectorXd>> courses(const StepForm& form) const;
  [[nodiscard]] bool isOf(const StepForm& form, std::size_t measurement) const;
  [[nodiscard]] std::optional<FoundStep> bestStep(std::size_t form) const;
  /// Returns the log odds gained if half of chi-square decreases by `fall`. The scale of the errors is unknown, but at
  /// least as large as the noise.
  [[nodiscard]] double gainOf(double fall) const;

  const std::vector<Measurement>& measurements_;
  const std::vector<StepForm>& forms_;
  bool ok_ = false;
  std::vector<int> first_row_;
  Eigen::VectorXd residual_, residual_by_fit_;
  /// Transformed Jacobian of the fit (parameters x rows). The squared length of its product with a residual is the
  /// decrease of chi-square due to the fit.
  Eigen::MatrixXd by_fit_;
  std::vector<Eigen::MatrixXd> by_step_;  ///< derivatives with respect to each form's parameters (rows x parameters)
};

}  // namespace tubeplan::calibration
