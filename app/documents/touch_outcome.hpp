// What to measure next: what was asked, and what is proposed.
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
  std::string cell, readings;       ///< files; no readings: empty
  std::vector<std::string> assume;  ///< of the readings, as MeasurementOptions has it
  std::vector<std::string> free;    ///< instead of the cell's `identify`
  std::string goal;                 ///< base, parameters, both; empty: what the cell allows
  std::string tubes;                ///< the work list; empty: spread:60
  std::string kind;                 ///< touch, position; empty: touch under a sheet, else position
  calibration::Optimality optimality = calibration::Optimality::kDeterminant;  ///< of the readings for parameters
  int count = 0;              ///< of each goal; 0: 3 touches, 10 readings
  int candidates = 0;         ///< holes or postures to choose from; 0: 60 holes, 600 postures
  std::vector<double> loads;  ///< in the cell's unit of force; empty: those of the readings, else none
  double sigma = 0;           ///< of a coordinate, in the cell's unit of length; 0: as the readings or the tool
  std::uint64_t seed = 1;
  std::vector<std::string> columns = {};  ///< what those of the work list are
};

/// What a reading to come is taken to be off by, and what says so.
struct ReadingNoise {
  double sigma = std::numeric_limits<double>::quiet_NaN();  ///< m, of a coordinate
  std::string from;
};

struct TouchOutcome : TouchProposals {
  Cell cell;                       ///< as known: with what the readings determine
  ReadingNoise noise, base_noise;  ///< of readings for the parameters, and of touches for the base
  std::vector<double> loads;       ///< N
  std::string setup;               ///< that new readings belong to; empty where there is one for all
  std::vector<std::string> notes;
  calibration::MeasurementChecks checks = {};  ///< of the readings made
};

}  // namespace tubeplan::app
