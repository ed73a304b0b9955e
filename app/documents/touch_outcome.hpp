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
  std::string cell, measurements;   ///< file names; `readings` is empty if there are none
  std::vector<std::string> assume;  ///< assumptions about the measurements, see MeasurementOptions
  std::vector<std::string> free;    ///< names of the parameters to free; empty: the cell's `identify`
  std::string goal;                 ///< base, parameters or both; empty: everything that the cell allows
  std::string tubes;                ///< selection or work list; empty: spread:60
  std::string kind;                 ///< touch or position; empty: touch for a cell with a sheet, else position
  /// Criterion for choosing measurements for the parameters.
  calibration::Optimality optimality = calibration::Optimality::kDeterminant;
  int count =
      0;  ///< number of measurements for each goal; 0: 3 touches for the base, 10 measurements for the parameters
  int candidates = 0;  ///< number of holes or postures to choose from; 0: 60 holes, 600 postures
  /// In the cell's force unit; empty: the loads of the measurements, or zero load without measurements.
  std::vector<double> loads;
  double sigma = 0;  ///< noise of a coordinate, in the cell's length unit; 0: derived from the measurements or the tool
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
