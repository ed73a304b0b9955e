// Directions in the sky over a site: conversion of hour angle and declination to azimuth and altitude, and atmospheric
// refraction.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tubeplan::app {

/// Direction in the sky: azimuth from north towards west, as in a world frame with x north and y west, and altitude
/// above the horizon [deg].
struct SkyDirection {
  double azimuth = 0, altitude = 0;
};

/// Returns the equivalent angle in the range above -180 and up to 180 [deg].
inline double nearestTurn(double angle) {
  const double turn = std::remainder(angle, 360.0);
  return turn == -180 ? 180 : turn;
}

/// Converts an hour angle (from the meridian towards west) and a declination to a direction in the sky over a site of
/// the given latitude; all angles in deg.
inline SkyDirection fromHourAngle(double hour_angle, double declination, double latitude) {
  constexpr double kDegreeOfSky = std::numbers::pi / 180;
  const double h = hour_angle * kDegreeOfSky, d = declination * kDegreeOfSky, phi = latitude * kDegreeOfSky;
  const double to_meridian = std::cos(d) * std::cos(h), to_pole = std::sin(d);
  const double north = std::cos(phi) * to_pole - std::sin(phi) * to_meridian;
  const double up = std::sin(phi) * to_pole + std::cos(phi) * to_meridian;
  const double west = std::cos(d) * std::sin(h);
  return {std::atan2(west, north) / kDegreeOfSky, std::atan2(up, std::hypot(north, west)) / kDegreeOfSky};
}

/// Returns the atmospheric refraction at a true altitude, both in deg; pressure in hPa, temperature in degC.
/// Saemundsson's formula (Sky and Telescope 72, 1986, p. 70), accurate to 0.1 minute of arc.
inline double refractionAt(double altitude, double pressure, double temperature) {
  const double h = std::max(altitude, -1.0);
  const double minutes = 1.02 / std::tan((h + 10.3 / (h + 5.11)) * std::numbers::pi / 180);
  return minutes / 60 * (pressure / 1010) * (283 / (273 + temperature));
}

}  // namespace tubeplan::app
