// Table of the notations for a rotation as three numbers. To add a notation, add a row.
#pragma once

#include <array>

#include "deflection/rotation.hpp"

namespace tubeplan::deflection {

struct TurnForm {
  const char* name;
  const char* words;  ///< description, with the manufacturers that use the notation
  /// Returns the rotation for three numbers [rad], in the order of the notation.
  Eigen::Matrix3d (*turn)(const Eigen::Vector3d& numbers);
};

inline constexpr TurnForm kFixedAngles{
    "fixed-angles",
    "about the fixed axes x, y, z: W, P, R of FANUC, Rx, Ry, Rz of Yaskawa and Denso, A, B, C of Mitsubishi",
    [](const Eigen::Vector3d& n) { return rotationFromFixedAngles<double>(n); }};
inline constexpr TurnForm kEulerZyx{
    "euler-zyx", "about z, the turned y, the turned x: A, B, C of KUKA, U, V, W of Epson",
    [](const Eigen::Vector3d& n) -> Eigen::Matrix3d { return rotationZ(n[0]) * rotationY(n[1]) * rotationX(n[2]); }};
inline constexpr TurnForm kEulerXyz{
    "euler-xyz", "about x, the turned y, the turned z: rx, ry, rz of Staubli",
    [](const Eigen::Vector3d& n) -> Eigen::Matrix3d { return rotationX(n[0]) * rotationY(n[1]) * rotationZ(n[2]); }};
inline constexpr TurnForm kEulerZyz{
    "euler-zyz", "about z, the turned y, the turned z: O, A, T of Kawasaki and Adept, A, E, R of Comau",
    [](const Eigen::Vector3d& n) -> Eigen::Matrix3d { return rotationZ(n[0]) * rotationY(n[1]) * rotationZ(n[2]); }};
inline constexpr TurnForm kRotationVector{"rotation-vector", "the axis times the angle: rx, ry, rz of Universal Robots",
                                          [](const Eigen::Vector3d& n) { return rotationFromVector<double>(n); }};

/// All notations; the first is roll, pitch, yaw.
inline constexpr std::array kTurnForms{kFixedAngles, kEulerZyx, kEulerXyz, kEulerZyz, kRotationVector};

}  // namespace tubeplan::deflection
