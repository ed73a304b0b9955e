// Turns of another frame than the arm file's tool frame: another convention of the flange, whose axes are the tool's in
// another order. "yzx": the x, y and z of the frame that was measured are the tool's y, z and x.
#pragma once

#include <fmt/format.h>

#include "calibration/measurement_checks/axes.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::calibration::mistakes::tool_frame {

inline bool statesFrame(const Measurement& reading) { return std::isfinite(ownNumber(reading, "roll")); }

/// The measured frame's axes in the tool's; nothing where the text is no right-handed order of them.
inline std::optional<Eigen::Matrix3d> turnOf(const std::string& value) {
  const auto R_TM = axes::matrixOf(value);
  return R_TM && R_TM->determinant() > 0 ? R_TM : std::nullopt;
}

inline std::vector<std::string> values(const CheckedReadings& checked) {
  std::vector<std::string> texts;
  if (std::ranges::none_of(checked.readings, statesFrame)) return texts;
  for (const std::string& text : axes::signedOrders())
    if (text != "xyz" && turnOf(text)) texts.push_back(text);
  return texts;
}

/// The tool's `rpy` by which the arm file would have that frame.
inline std::string rpyText(const CheckedReadings& checked, const Eigen::Matrix3d& R_TM) {
  const NamedUnit& unit = checked.units.angles;
  const Eigen::Vector3d rpy = deflection::fixedAnglesOf(checked.start.arm.R_LT * R_TM) / unit.factor;
  return fmt::format("[{:.6g}, {:.6g}, {:.6g}] {}", rpy.x() + 0., rpy.y() + 0., rpy.z() + 0., unit.name);
}

inline std::optional<Mend> mend(const CheckedReadings& checked, const std::string& value) {
  const auto R_TM = turnOf(value);
  if (!R_TM) return std::nullopt;
  Mend mend{"tool-frame", value,
            "the turns are of a frame whose x, y and z are " + value + " of the tool's: `rpy` of the tool is " +
                rpyText(checked, *R_TM)};
  mend.change = [R_MT = Eigen::Matrix3d(R_TM->transpose())](std::vector<Measurement>& readings) {
    for (auto& reading : readings)
      if (statesFrame(reading))
        reading.own = deflection::fixedAnglesOf(deflection::rotationFromFixedAngles<double>(reading.own) * R_MT);
  };
  return mend;
}

/// Beside other mistakes none is tried: what finds pairs looks at places alone.
inline std::vector<std::string> noValues(const CheckedReadings&) { return {}; }

inline MistakeKind kind() {
  return {.name = "tool-frame",
          .value = "ORDER",
          .expected = "the tool frame's axes that x, y, z of the measured frame are, right-handed, such as yzx or -yxz",
          .values = values,
          .mend = mend,
          .values_beside = noValues};
}

}  // namespace tubeplan::calibration::mistakes::tool_frame
