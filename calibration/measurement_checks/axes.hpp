// Mistake: coordinates with exchanged or reversed axes. All signed permutations of x, y and z are tried, except the
// file's own order and those that only reverse one sign (see mirror.hpp). For the value "-yxz", the three coordinates
// in the file are -y, x and z of the world.
#pragma once

#include <algorithm>
#include <array>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::axes {

/// Returns the rotation or reflection from the file's three coordinates to world coordinates; nullopt if `value` is not
/// a signed permutation such as "-yxz".
inline std::optional<Eigen::Matrix3d> matrixOf(const std::string& value) {
  Eigen::Matrix3d to_world = Eigen::Matrix3d::Zero();
  int column = 0;
  double sign = 1;
  for (const char letter : value) {
    if (letter == '-' && sign > 0) {
      sign = -1;
      continue;
    }
    if (letter < 'x' || letter > 'z' || column == 3) return std::nullopt;
    to_world(letter - 'x', column++) = sign;
    sign = 1;
  }
  if (column != 3 || std::abs(std::abs(to_world.determinant()) - 1) > 0.5) return std::nullopt;
  return to_world;
}

/// Returns true if at least one measurement has coordinates written in the file. Positions looked up by hole name are
/// ignored here; sheet_mirrored.hpp handles them.
inline bool areWritten(const CheckedMeasurements& checked) {
  return std::ranges::any_of(checked.measurements, [&](const Measurement& measurement) {
    return measurement.p_W && !isPlacedBySheet(checked, measurement);
  });
}

/// Applies `to_world` to all measured positions, whether written in the file or looked up in the tube sheet, and to
/// their sigmas and correlations.
inline void turn(const Eigen::Matrix3d& to_world, std::vector<Measurement>& measurements) {
  for (auto& measurement : measurements) {
    if (measurement.p_W) *measurement.p_W = to_world * *measurement.p_W;
    if (measurement.sigma_W) *measurement.sigma_W = (to_world * *measurement.sigma_W).cwiseAbs();
    if (measurement.correlation_W)
      measurement.correlation_W =
          correlationNumbers(to_world * correlationMatrix(*measurement.correlation_W) * to_world.transpose());
  }
}

/// Returns the names of all signed permutations of x, y and z, such as "-yxz".
inline std::vector<std::string> signedOrders() {
  std::vector<std::string> texts;
  std::string order = "xyz";
  do {
    for (int signs = 0; signs < 8; ++signs) {
      std::string text;
      for (int k = 0; k < 3; ++k)
        text += (signs >> k & 1 ? "-" : "") + std::string(1, order[static_cast<std::size_t>(k)]);
      texts.push_back(text);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return texts;
}

inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  if (!areWritten(checked)) return {};
  std::vector<std::string> texts = signedOrders();
  std::erase_if(texts, [](const std::string& text) {
    // Excludes the file's own order and its three mirror images, which are tried in mirror.hpp.
    return text == "xyz" || text == "-xyz" || text == "x-yz" || text == "xy-z";
  });
  return texts;
}

inline std::optional<Correction> correction(const CheckedMeasurements&, const std::string& value) {
  const auto to_world = matrixOf(value);
  if (!to_world) return std::nullopt;
  Correction correction{"axes", value, "the columns x, y and z contain " + value + " of the cell's world"};
  correction.change = [to_world = *to_world](std::vector<Measurement>& measurements) { turn(to_world, measurements); };
  return correction;
}

inline MistakeKind kind() {
  return {"axes", "ORDER", "the world axes in the columns x, y, z, such as yxz or -yxz", values, correction};
}

}  // namespace tubeplan::calibration::mistakes::axes
