// With what probability how many steps of the calibration tool go in, under all that is uncertain: the joints'
// readings, where the base stands, and what the arm does beyond its model.
#pragma once

#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/forecast/tip_error.hpp"
#include "planner/reach/scoring.hpp"

namespace tubeplan::app {

/// ModelError::from of an error estimated from the touches of a calibration.
inline constexpr const char* kByTouches = "touches";

struct StepChances {
  std::string reason;                           ///< why there are none; empty where there are some
  calibration::TipError error;                  ///< `at` is emptied once used
  int touches = 0;                              ///< by which the model's error was judged
  bool base_is_exact = false;                   ///< somebody says that the base is known, and not how well
  std::vector<std::vector<double>> by_posture;  ///< of 0, 1, ... steps; each adds up to 1
};

/// Where the arm goes by its model, and how the tool stands there by it.
struct StepQuestion {
  const CellModel& cell;                                 ///< as read: what it says of base and model error
  const planner::Workcell& model;                        ///< placed
  const std::vector<calibration::Measurement>& touches;  ///< that placed it; none: it stands as the cell has it
  const std::vector<Eigen::VectorXd>& postures;
  const std::vector<planner::Centring>& predicted;  ///< by the model itself, one for each posture
};

/// None for a base that nobody placed.
[[nodiscard]] StepChances stepChances(const StepQuestion& question);

/// The likeliest number of steps; of two as likely, the lower.
[[nodiscard]] int likeliestSteps(const std::vector<double>& chances);

/// How many holes take 0, 1, ... steps on the average.
[[nodiscard]] std::vector<double> expectedCounts(const StepChances& chances);

/// Whether the model's error is known by more than the touches of a calibration.
[[nodiscard]] bool isFoundElsewhere(const std::optional<ModelError>& error);

/// The model's error by the touches, for the cell's file: as Student's t of their degrees of freedom would have it;
/// nothing where the touches were not asked.
[[nodiscard]] std::optional<ModelError> modelErrorByTouches(const calibration::TipError& error, std::size_t touches);

}  // namespace tubeplan::app
