#include "app/formats/foreign/written_forms.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "deflection/turn_forms.hpp"

namespace tubeplan::app {

namespace {

using std::numbers::pi;

constexpr double kRounded = 1e-3;            // rounding error of angles with few decimals [rad]
constexpr double kQuaternionRounded = 2e-3;  // rounding error of a quaternion's norm with three decimals

template <const deflection::TurnForm& form>
Eigen::Vector3d rollPitchYaw(const FormNumbers& n) {
  return deflection::fixedAnglesOf(form.turn({n[0], n[1], n[2]}));
}
Eigen::Vector3d rollPitchYawOfQuaternion(const FormNumbers& n) {
  return deflection::fixedAnglesOf(Eigen::Quaterniond(n[0], n[1], n[2], n[3]).normalized().toRotationMatrix());
}

Eigen::Vector3d placeFromX(const FormNumbers& n) {
  return n[2] * Eigen::Vector3d(std::sin(n[1]) * std::cos(n[0]), std::sin(n[1]) * std::sin(n[0]), std::cos(n[1]));
}
Eigen::Vector3d placeFromNorth(const FormNumbers& n) {
  return n[2] * Eigen::Vector3d(std::sin(n[1]) * std::sin(n[0]), std::sin(n[1]) * std::cos(n[0]), std::cos(n[1]));
}

FormFit fitOfMiddle(const FormNumbers& n) {
  return std::abs(n[1]) <= pi / 2 + kRounded ? FormFit::kUsual : FormFit::kUnusual;
}
FormFit fitOfAny(const FormNumbers&) { return FormFit::kUsual; }
FormFit fitOfVector(const FormNumbers& n) {
  const double angle = Eigen::Vector3d(n[0], n[1], n[2]).norm();
  if (angle <= pi + kRounded) return FormFit::kUsual;
  return angle <= 2 * pi + kRounded ? FormFit::kUnusual : FormFit::kImpossible;
}
FormFit fitOfQuaternion(const FormNumbers& n) {
  const double length = Eigen::Vector4d(n[0], n[1], n[2], n[3]).norm();
  return std::abs(length - 1) <= kQuaternionRounded ? FormFit::kUsual : FormFit::kImpossible;
}
FormFit fitOfDistance(const FormNumbers& n) { return n[2] > 0 ? FormFit::kUsual : FormFit::kImpossible; }

std::vector<FormNumber> angles(const char* first, const char* second, const char* third) {
  return {{first, UnitKind::kAngle}, {second, UnitKind::kAngle}, {third, UnitKind::kAngle}};
}

/// Returns all combinations of one name from each list.
std::vector<FormHeadings> combinations(const std::array<std::vector<std::string>, 3>& lists) {
  std::vector<FormHeadings> all;
  for (const auto& first : lists[0])
    for (const auto& second : lists[1])
      for (const auto& third : lists[2]) all.push_back({{first, second, third}});
  return all;
}

std::vector<FormHeadings> polarHeadings() {
  return combinations({{{"hz", "horizontal", "horizontalangle", "ha", "azimuth"},
                        {"v", "vz", "zenith", "zenithangle"},
                        {"sd", "d", "dist", "distance", "slopedistance", "slopedist", "range"}}});
}

WrittenForm polarForm(const char* name, const char* words, Eigen::Vector3d (*read)(const FormNumbers&)) {
  return {name,
          words,
          Stated::kPlace,
          {{"horizontal", UnitKind::kAngle}, {"zenith", UnitKind::kAngle}, {"distance", UnitKind::kLength}},
          polarHeadings(),
          read,
          fitOfDistance,
          "whose distance is above zero"};
}

std::vector<FormHeadings> quaternionHeadings() {
  std::vector<FormHeadings> all{{{"q1", "q2", "q3", "q4"}, "", "w first"}, {{"w", "x", "y", "z"}}};
  for (const std::string before : {"q", "quat", "quaternion", "orientation", "poseorientation", "rotation", "rot"})
    all.push_back({{before + "w", before + "x", before + "y", before + "z"}});
  return all;
}

constexpr const char* kMiddle = "whose middle angle stays within 90 deg";

}  // namespace

const StatedColumns& columnsOf(Stated stated) {
  static constexpr StatedColumns kTurn{"an orientation", "--orientation", {"roll", "pitch", "yaw"}, UnitKind::kAngle};
  static constexpr StatedColumns kPlace{"a place", "--points", {"x", "y", "z"}, UnitKind::kLength};
  return stated == Stated::kTurn ? kTurn : kPlace;
}

std::span<const WrittenForm> writtenForms() {
  static const std::vector<WrittenForm> kForms{
      {deflection::kFixedAngles.name,
       deflection::kFixedAngles.words,
       Stated::kTurn,
       angles("x", "y", "z"),
       {{{"w", "p", "r"}}, {{"rx", "ry", "rz"}, "l"}, {{"rotx", "roty", "rotz"}}, {{"a", "b", "c"}}},
       rollPitchYaw<deflection::kFixedAngles>,
       fitOfMiddle,
       kMiddle},
      {deflection::kEulerZyx.name,
       deflection::kEulerZyx.words,
       Stated::kTurn,
       angles("z", "y", "x"),
       {{{"a", "b", "c"}, "a1"}, {{"u", "v", "w"}}},
       rollPitchYaw<deflection::kEulerZyx>,
       fitOfMiddle,
       kMiddle},
      {deflection::kEulerXyz.name,
       deflection::kEulerXyz.words,
       Stated::kTurn,
       angles("x", "y", "z"),
       {{{"rx", "ry", "rz"}}, {{"rotx", "roty", "rotz"}}},
       rollPitchYaw<deflection::kEulerXyz>,
       fitOfMiddle,
       kMiddle},
      {deflection::kEulerZyz.name,
       deflection::kEulerZyz.words,
       Stated::kTurn,
       angles("o", "a", "t"),
       {{{"o", "a", "t"}}, {{"a", "e", "r"}}},
       rollPitchYaw<deflection::kEulerZyz>,
       fitOfAny,
       ""},
      {deflection::kRotationVector.name,
       deflection::kRotationVector.words,
       Stated::kTurn,
       angles("x", "y", "z"),
       {{{"rx", "ry", "rz"}, "wrist1"},
        {{"rotx", "roty", "rotz"}},
        {{"rvx", "rvy", "rvz"}},
        {{"rotvecx", "rotvecy", "rotvecz"}},
        {{"actualtcppose3", "actualtcppose4", "actualtcppose5"}}},
       rollPitchYaw<deflection::kRotationVector>,
       fitOfVector,
       "which is no longer than half a turn"},
      {"quaternion",
       "its real part w and x, y, z: q1 to q4 of ABB, qx, qy, qz, qw of ROS",
       Stated::kTurn,
       {{"w", std::nullopt}, {"x", std::nullopt}, {"y", std::nullopt}, {"z", std::nullopt}},
       quaternionHeadings(),
       rollPitchYawOfQuaternion,
       fitOfQuaternion,
       "whose length is 1"},
      polarForm("polar", "the horizontal angle from x to y, the angle from z, the slope distance: trackers",
                placeFromX),
      polarForm("polar-clockwise",
                "the horizontal angle from north (y) to east (x), the angle from the zenith (z), the slope distance: "
                "total stations",
                placeFromNorth),
  };
  return kForms;
}

std::vector<std::string> formNames(Stated stated) {
  std::vector<std::string> names;
  for (const auto& form : writtenForms())
    if (form.stated == stated) names.emplace_back(form.name);
  return names;
}

}  // namespace tubeplan::app
