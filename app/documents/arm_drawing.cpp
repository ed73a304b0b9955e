#include "app/documents/arm_drawing.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "deflection/anchored_rows.hpp"
#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::app {

namespace {

using deflection::Arm, deflection::JointType;
using Eigen::Vector2d, Eigen::Vector3d, Eigen::VectorXd;

constexpr double kView = 420, kMargin = 40;  // size of a view and width of its margin [px]

VectorXd middleOf(const Arm& arm) {
  VectorXd q(arm.jointCount());
  for (Eigen::Index k = 0; k < arm.jointCount(); ++k) {
    const auto& joint = arm.joint(k);
    const double middle = (joint.lower + joint.upper) / 2;
    q[k] = std::isfinite(middle) ? middle : 0;
  }
  return q;
}

/// Positions of the base, of the origin of each row, and of the tip, in the base frame [m].
struct Outline {
  std::vector<Vector3d> rigid{Vector3d::Zero()}, deflected{Vector3d::Zero()};
};

Outline outlineOf(const Arm& arm) {
  const auto shape = deflection::solveFlexibleKinematics(arm, {middleOf(arm), 0, arm.gravity_W});
  Outline outline;
  for (const auto& row : shape.rows) {
    outline.rigid.push_back(row.X_BL_rigid.p);
    outline.deflected.push_back(row.X_BL.p);
  }
  outline.rigid.push_back(shape.X_BT.p);
  outline.deflected.push_back(shape.X_BD.p);
  return outline;
}

/// Projection along an axis of the base frame: coordinate `across` points to the right, coordinate `up` upwards.
class View {
 public:
  View(const Outline& outline, int across, int up, double left) : across_(across), up_(up), left_(left) {
    for (const auto& p : outline.rigid) box_.extend(flat(p));
    const double size = std::max({box_.sizes().x(), box_.sizes().y(), 1e-9});
    scale_ = (kView - 2 * kMargin) / size;
  }

  [[nodiscard]] Vector2d at(const Vector3d& p) const {
    const Vector2d off = (flat(p) - box_.center()) * scale_;
    return {left_ + kView / 2 + off.x(), kView / 2 - off.y()};
  }

  [[nodiscard]] std::string line(const std::vector<Vector3d>& points, const char* style) const {
    std::string text = "<polyline points=\"";
    for (const auto& p : points) text += fmt::format("{:.1f},{:.1f} ", at(p).x(), at(p).y());
    return text + fmt::format("\" {}/>\n", style);
  }

  [[nodiscard]] double pixelsPerMetre() const { return scale_; }
  [[nodiscard]] double left() const { return left_; }

 private:
  [[nodiscard]] Vector2d flat(const Vector3d& p) const { return {p[across_], p[up_]}; }
  int across_, up_;
  double left_, scale_ = 1;
  Eigen::AlignedBox2d box_;
};

std::string jointMark(const deflection::Joint<double>& joint, const Vector2d& at) {
  if (joint.type == JointType::kPrismatic)
    return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"10\" height=\"10\" class=\"joint\"/>\n", at.x() - 5,
                       at.y() - 5);
  if (!deflection::turns(joint)) return "";
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" class=\"joint\"/>\n", at.x(), at.y());
}

/// Returns the largest length that is one, two or five times a power of ten and does not exceed `longest`.
double roundLength(double longest) {
  const double power = std::pow(10, std::floor(std::log10(longest)));
  for (const double step : {5., 2.})
    if (step * power <= longest) return step * power;
  return power;
}

std::string scaleBar(const View& view, const Units& units) {
  const double unit = units.factor(dimension::kLength);
  const double length = roundLength(kView / 3 / view.pixelsPerMetre() / unit);
  const double width = length * unit * view.pixelsPerMetre(), x = view.left() + kMargin, y = kView - 12;
  return fmt::format(
      "<path d=\"M{0:.1f} {1:.1f} h{2:.1f} m0 -4 v8 M{0:.1f} {3:.1f} v8\" class=\"scale\"/>\n"
      "<text x=\"{4:.1f}\" y=\"{5:.1f}\">{6} {7}</text>\n",
      x, y, width, y - 4, x + width + 8, y + 4, formatNumber(length), units.length().name);
}

std::string draw(const Arm& arm, const Outline& outline, const View& view, const char* title, const Units& units) {
  std::string text = fmt::format("<text x=\"{:.1f}\" y=\"22\">{}</text>\n", view.left() + kMargin, title);
  text += view.line(outline.rigid, "class=\"rigid\"") + view.line(outline.deflected, "class=\"deflected\"");
  for (std::size_t k = 0; k < arm.rows.size(); ++k) text += jointMark(arm.rows[k].joint, view.at(outline.rigid[k + 1]));
  const Vector2d tip = view.at(outline.rigid.back());
  text += fmt::format("<path d=\"M{:.1f} {:.1f} l-5 -9 h10 z\" class=\"tip\"/>\n", tip.x(), tip.y());
  return text + scaleBar(view, units);
}

}  // namespace

std::string armDrawing(const Arm& arm, const Units& units) {
  const Outline outline = outlineOf(deflection::anchoredRows(arm).arm);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "font-family=\"sans-serif\" font-size=\"13\">\n"
      "<style>.rigid{{fill:none;stroke:#888;stroke-width:6;stroke-linejoin:round}}"
      ".deflected{{fill:none;stroke:#c2410c;stroke-width:2;stroke-dasharray:6 3}}"
      ".joint{{fill:#fff;stroke:#222;stroke-width:2}}.tip{{fill:#1d4ed8}}.scale{{fill:none;stroke:#222}}</style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      2 * kView, kView);
  text += draw(arm, outline, View(outline, 0, 2, 0), "from the side (x to the right, z up)", units);
  text += draw(arm, outline, View(outline, 0, 1, kView), "from above (x to the right, y up)", units);
  return text + "</svg>\n";
}

}  // namespace tubeplan::app
