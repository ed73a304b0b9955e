// Request for proposals of further measurements, and the resulting proposals.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/studies/measurements/touch_proposals.hpp"
#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::app {

struct TouchRequest {
  std::string cell, measurements;   ///< file names; `measurements` is empty if there are none
  std::vector<std::string> assume;  ///< assumptions about the measurements, see MeasurementOptions
  /// Names of the parameters to free; if empty, the parameters under the cell's `identify`.
  std::vector<std::string> free;
  std::string goal;   ///< base, parameters or both; if empty, everything that the cell allows
  std::string tubes;  ///< selection or work list; the default is spread:60
  std::string kind;   ///< touch or position; by default touch for a cell with a sheet, otherwise position
  /// Criterion for choosing measurements for the parameters.
  calibration::Optimality optimality = calibration::Optimality::kDeterminant;
  /// Number of measurements for each goal; by default 3 touches for the base, 10 measurements for the parameters.
  int count = 0;
  int candidates = 0;  ///< number of holes or postures to choose from; by default 60 holes or 600 postures
  /// Loads in the cell's force unit; by default the loads of the measurements, or no load without measurements.
  std::vector<double> loads;
  /// Noise of a coordinate, in the cell's length unit; if 0, it is derived from the measurements or the tool.
  double sigma = 0;
  std::uint64_t seed = 1;
  std::vector<std::string> columns = {};  ///< meanings of the work list's columns
};

/// Assumed noise of a future measurement, with its source.
struct MeasurementNoise {
  double sigma = std::numeric_limits<double>::quiet_NaN();  ///< standard deviation of a coordinate [m]
  std::string from;
};

struct TouchOutcome : TouchProposals {
  Cell cell;                           ///< cell with the arm and base estimated from the measurements
  MeasurementNoise noise, base_noise;  ///< noise of measurements for the parameters, and of touches for the base
  std::vector<double> loads;           ///< loads of the proposed measurements [N]
  std::string setup;                   ///< set-up of the proposed measurements; empty if there is only one set-up
  std::vector<std::string> notes;
  calibration::MeasurementChecks checks = {};  ///< checks of the existing measurements
};

}  // namespace tubeplan::app
