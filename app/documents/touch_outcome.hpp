// Request for the next measurements and the proposed ones.
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
  std::string cell, readings;       ///< files; `readings` is empty without readings
  std::vector<std::string> assume;  ///< assumptions about the readings, see MeasurementOptions
  std::vector<std::string> free;    ///< names instead of the cell's `identify`
  std::string goal;                 ///< base, parameters, both; empty: all that the cell allows
  std::string tubes;                ///< work list; empty: spread:60
  std::string kind;                 ///< touch, position; empty: touch under a sheet, else position
  calibration::Optimality optimality = calibration::Optimality::kDeterminant;  ///< for the readings for parameters
  int count = 0;              ///< number of readings per goal; 0: 3 touches, 10 readings
  int candidates = 0;         ///< number of holes or postures to choose from; 0: 60 holes, 600 postures
  std::vector<double> loads;  ///< in the cell's unit of force; empty: the loads of the readings, else none
  double sigma = 0;           ///< sigma of a coordinate, in the cell's unit of length; 0: from the readings or the tool
  std::uint64_t seed = 1;
  std::vector<std::string> columns = {};  ///< meanings of the work list's columns
};

/// Expected noise of a future reading, with its source.
struct ReadingNoise {
  double sigma = std::numeric_limits<double>::quiet_NaN();  ///< sigma of a coordinate [m]
  std::string from;
};

struct TouchOutcome : TouchProposals {
  Cell cell;                       ///< cell with the estimate from the readings
  ReadingNoise noise, base_noise;  ///< noise of readings for the parameters, and of touches for the base
  std::vector<double> loads;       ///< loads [N]
  std::string setup;               ///< set-up of new readings; empty if there is only one
  std::vector<std::string> notes;
  calibration::MeasurementChecks checks = {};  ///< checks of the existing readings
};

}  // namespace tubeplan::app
