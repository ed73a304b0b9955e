// Measurements of the Cobra as a measurement file, in inches, degrees and pounds.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::app {

inline std::string measurementsCsv(const std::vector<calibration::Measurement>& measurements, bool with_sigma = true) {
  static constexpr const char* kKinds[] = {"position", "touch", "deflection", "distance"};
  std::string text =
      "id,kind,point,setup,load_lbf,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,distance_in";
  text += with_sigma ? ",sigma_in\n" : "\n";
  const auto number = [](bool is_there, double value) { return is_there ? fmt::format(",{:.9g}", value) : ","; };
  for (const auto& m : measurements) {
    text +=
        fmt::format("{},{},{},{},{:.9g}", m.id, kKinds[static_cast<int>(m.kind)], m.point, m.setup, m.load / kPound);
    for (const double q : m.q) text += fmt::format(",{:.9g}", q / kDegree);
    for (int k = 0; k < 3; ++k) text += number(m.p_W.has_value(), m.p_W ? (*m.p_W)[k] / kInch : 0);
    text += number(calibration::ownNumber(m, "distance") > 0, m.kind_values[0] / kInch);
    text += with_sigma ? fmt::format(",{:.9g}\n", m.sigma / kInch) : "\n";
  }
  return text;
}

}  // namespace tubeplan::app
