#include "app/formats/urdf/urdf_edit.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/formats/urdf/urdf_reader.hpp"
#include "app/formats/urdf/urdf_text.hpp"
#include "app/formats/urdf/urdf_writer.hpp"
#include "app/storage/input_error.hpp"
#include "deflection/chain.hpp"
#include "deflection/rotation.hpp"
#include "deflection/weights.hpp"

namespace tubeplan::app {

namespace {

using deflection::Arm, deflection::JointType;
using Eigen::Isometry3d, Eigen::Matrix3d, Eigen::Vector3d;

constexpr double kSamePlacement = 1e-9;  // tolerance of poses after the new text is read again [m, rad]

bool isSamePlace(const Vector3d& a, const Vector3d& b, double tolerance) {
  return (a - b).norm() <= tolerance * std::max(1., a.norm());
}
bool isSameTurn(const Matrix3d& a, const Matrix3d& b, double tolerance) { return (a - b).norm() <= tolerance; }

/// Returns the roll, pitch and yaw of R that are nearest to `written`, among both solutions and all whole turns.
Vector3d anglesNear(const Matrix3d& R, const Vector3d& written) {
  constexpr double kHalfTurn = std::numbers::pi;
  const auto near = [&](Vector3d rpy) {
    for (int k = 0; k < 3; ++k) rpy[k] += 2 * kHalfTurn * std::round((written[k] - rpy[k]) / (2 * kHalfTurn));
    return rpy;
  };
  const Vector3d rpy = deflection::fixedAnglesOf(R), nearest = near(rpy),
                 alternative = near({rpy.x() + kHalfTurn, kHalfTurn - rpy.y(), rpy.z() + kHalfTurn});
  return (nearest - written).norm() <= (alternative - written).norm() ? nearest : alternative;
}

/// Returns a joint's offset plus the offsets of the joints that it follows, each multiplied by the joint's ratio.
double offsetOf(const Arm& arm, const deflection::Joint<double>& joint) {
  double offset = joint.offset;
  for (const auto& followed : joint.follows)
    offset += followed.ratio * arm.rows[static_cast<std::size_t>(followed.row)].joint.offset;
  return offset;
}

/// Returns the pose of a row's frame relative to the previous row's frame, with the row's joint at `shift` [rad or m].
Isometry3d poseOfRow(const deflection::Row<double>& row, double shift) {
  Isometry3d X = Isometry3d::Identity();
  X.linear() = deflection::rotationFromPrevious(row);
  X.translation() = deflection::offsetInPreviousAxes(row);
  if (row.joint.type == JointType::kPrismatic) return X * Eigen::Translation3d(0, 0, shift);
  return X * Eigen::AngleAxisd(shift, Vector3d::UnitZ());
}

Isometry3d poseOfTool(const Arm& arm) {
  Isometry3d X = Isometry3d::Identity();
  X.linear() = urdfTipTurn(arm);
  X.translation() = arm.p_LT;
  return X;
}

std::string inWords(const deflection::Row<double>& row) {
  const auto name = nameInLine(row.name);
  return row.joint.name.empty() ? fmt::format("the link {}", name)
                                : fmt::format("the link {} behind joint {}", name, nameInLine(row.joint.name));
}

bool isSameRow(const deflection::Row<double>& a, const deflection::Row<double>& b) {
  const auto isSame = [](const auto& x, const auto& y) { return x.row == y.row && isAsWritten(x.ratio, y.ratio); };
  return a.name == b.name && a.joint.name == b.joint.name && a.joint.type == b.joint.type &&
         std::ranges::equal(a.joint.follows, b.joint.follows, isSame);
}

/// Throws InputError unless `arm` has the same rows as `in_file`, the arm that was read from the URDF file.
void requireSameRows(const Arm& in_file, const Arm& arm, const std::string& file) {
  const char* advice = "for --into, give the URDF file from which the arm was imported, with the same --tip";
  for (std::size_t k = 0; k < std::min(in_file.rows.size(), arm.rows.size()); ++k) {
    if (isSameRow(in_file.rows[k], arm.rows[k])) continue;
    const std::string where = fmt::format("{} (row {})", file, k + 1), found = inWords(in_file.rows[k]);
    if (found == inWords(arm.rows[k]))
      throw InputError::problem(where, found + " does not move as in the arm: its type or the joints it follows differ",
                                advice);
    throw InputError(where, found, inWords(arm.rows[k]), advice);
  }
  if (in_file.rows.size() != arm.rows.size())
    throw InputError(file, fmt::format("{} joints and links that carry the tool", in_file.rows.size()),
                     fmt::format("{}, as in the arm", arm.rows.size()), advice);
}

class UrdfEditor {
 public:
  UrdfEditor(const std::string& text, const std::string& file, const std::string& tip, const Arm& arm)
      : text_(text),
        file_(file),
        arm_(arm),
        read_(parseUrdf(text, file, tip)),
        tags_(urdfTagsOf(text)),
        changes_(text),
        tip_(read_.tip) {
    requireSameRows(read_.arm, arm, file);
  }

  UrdfEdit edit() {
    out_.left_out = beyondUrdf(arm_);
    Isometry3d X_CL = Isometry3d::Identity();  // rotation of z to the joint axis of the previous row
    for (std::size_t k = 0; k < arm_.rows.size(); ++k) {
      const Isometry3d X_LL = poseOfRow(arm_.rows[k], shiftOf(k)), X_CL_here = read_.joints[k].X_CL;
      changeOrigin(read_.joints[k], X_CL * X_LL * X_CL_here.inverse());
      if (arm_.rows[k].joint.type != JointType::kPassive) changeLimits(k);
      X_CL = X_CL_here;
    }
    changeTool(X_CL);
    leaveOutWeights();
    out_.text = changes_.changedText();
    if (!out_.changed.empty()) checkAgain();
    return std::move(out_);
  }

 private:
  /// Returns the change of a row's joint offset relative to the URDF file [rad or m].
  [[nodiscard]] double shiftOf(std::size_t k) const {
    return offsetOf(arm_, arm_.rows[k].joint) - offsetOf(read_.arm, read_.arm.rows[k].joint);
  }

  [[nodiscard]] std::string_view restBehind(std::string_view piece) const {
    return std::string_view(text_).substr(static_cast<std::size_t>(piece.data() + piece.size() - text_.data()));
  }

  void changeOrigin(const UrdfJoint& joint, const Isometry3d& X_PC) {
    const bool is_moved = !isSamePlace(joint.X_PC.translation(), X_PC.translation(), kAsWritten),
               is_turned = !isSameTurn(joint.X_PC.linear(), X_PC.linear(), kAsWritten);
    if (!is_moved && !is_turned) return;
    const UrdfJointTags& tags = tagsOf(joint.name);
    const Vector3d p = X_PC.translation(), rpy = anglesNear(X_PC.linear(), joint.rpy);
    if (!tags.origin) {
      const std::string_view behind = restBehind(tags.joint.text);
      changes_.insertBehind(tags.joint.text, fmt::format("{}<origin xyz=\"{}\" rpy=\"{}\"/>",
                                                         behind.substr(0, behind.find_first_not_of(" \t\r\n")),
                                                         decimalsOf(p), decimalsOf(rpy)));
    } else {
      if (is_moved) setNumbers(*tags.origin, "xyz", joint.X_PC.translation(), p);
      if (is_turned) setNumbers(*tags.origin, "rpy", joint.rpy, rpy);
    }
    const double turn = Eigen::AngleAxisd(joint.X_PC.linear().transpose() * X_PC.linear()).angle();
    out_.changed.push_back(fmt::format("the origin of joint {}: moved {:.3g} mm, turned {:.3g} mrad",
                                       nameInLine(joint.name),
                                       (X_PC.translation() - joint.X_PC.translation()).norm() * 1e3, turn * 1e3));
  }

  void setNumbers(const XmlTag& origin, const char* attribute, const Vector3d& was, const Vector3d& is) {
    const auto* written = origin.find(attribute);
    changes_.setAttribute(origin, attribute, withNumbers(written ? written->value : "", was, is));
  }

  void changeLimits(std::size_t k) {
    const auto &was = read_.arm.rows[k].joint, &is = arm_.rows[k].joint;
    const struct {
      const char* attribute;
      double was, is;
    } numbers[] = {
        {"lower", was.lower, is.lower}, {"upper", was.upper, is.upper}, {"velocity", was.max_speed, is.max_speed}};
    const UrdfJointTags& tags = tagsOf(was.name);
    const auto* type = tags.joint.find("type");
    const bool is_continuous = type && type->value == "continuous";
    for (const auto& number : numbers) {
      if (isAsWritten(number.was, number.is)) continue;
      const bool is_limit = number.attribute != std::string_view("velocity");
      if (!tags.limit || !std::isfinite(number.is) || (is_limit && is_continuous)) {
        out_.left_out.push_back(fmt::format("{} of joint {}: its limits in {} are unchanged", number.attribute,
                                            nameInLine(was.name), file_));
        continue;
      }
      changes_.setAttribute(*tags.limit, number.attribute, decimalOf(number.is));
      out_.changed.push_back(fmt::format("{} of joint {}: {}, was {}", number.attribute, nameInLine(was.name),
                                         decimalOf(number.is), decimalOf(number.was)));
    }
  }

  /// Changes the tool through the last fixed joint after the rows; adds a fixed joint if there is none.
  void changeTool(const Isometry3d& X_CL) {
    const Isometry3d was = poseOfTool(read_.arm), is = poseOfTool(arm_);
    if (isSamePlace(was.translation(), is.translation(), kAsWritten) &&
        isSameTurn(was.linear(), is.linear(), kAsWritten))
      return;
    Isometry3d X_LP = X_CL.inverse();
    const std::size_t rows = arm_.rows.size(), joints = read_.joints.size();
    for (std::size_t k = rows; k + 1 < joints; ++k) X_LP = X_LP * read_.joints[k].X_PC;
    if (joints > rows)
      changeOrigin(read_.joints.back(), X_LP.inverse() * is);
    else
      addTip(X_LP.inverse() * is);
  }

  void addTip(const Isometry3d& X_PC) {
    const auto isTaken = [&](const std::string& name) {
      return tags_.links.contains(name) || tags_.joints.contains(name);
    };
    tip_ = "tip";
    while (isTaken(tip_)) tip_ += '_';
    std::string more = fmt::format(
        "  <link name=\"{0}\"/>\n  <joint name=\"{0}\" type=\"fixed\">\n    <origin xyz=\"{1}\" rpy=\"{2}\"/>\n"
        "    <parent link=\"{3}\"/>\n    <child link=\"{0}\"/>\n  </joint>\n",
        tip_, decimalsOf(X_PC.translation()), decimalsOf(deflection::fixedAnglesOf(X_PC.linear())),
        xmlEscaped(read_.tip));
    if (tags_.robot_end.data() != text_.data() && tags_.robot_end.data()[-1] != '\n') more.insert(0, "\n");
    if (text_.find("\r\n") != std::string::npos)
      for (std::size_t at = 0; (at = more.find('\n', at)) != std::string::npos; at += 2) more.insert(at, 1, '\r');
    changes_.replace(tags_.robot_end.substr(0, 0), std::move(more));
    out_.changed.push_back(fmt::format("a fixed joint and a link {} are added: the tool's tip", tip_));
  }

  void leaveOutWeights() {
    for (std::size_t k = 0; k < arm_.rows.size(); ++k) {
      const auto was = deflection::rowWeightOf(read_.arm, k), is = deflection::rowWeightOf(arm_, k);
      if (std::abs(was.weight - is.weight) > 1e-9 * (1 + was.weight) ||
          (was.moment_R - is.moment_R).norm() > 1e-9 * (1 + was.moment_R.norm()))
        out_.left_out.push_back(
            fmt::format("the weights of row {}: the masses in {} are unchanged", nameInLine(arm_.rows[k].name), file_));
    }
  }

  [[nodiscard]] const UrdfJointTags& tagsOf(const std::string& joint) const {
    const auto found = tags_.joints.find(joint);
    if (found == tags_.joints.end()) refuse(joint);
    return found->second;
  }

  [[noreturn]] void refuse(const std::string& joint) const {
    throw InputError::problem(fmt::format("{} (joint {})", file_, nameInLine(joint)),
                              "the XML of this joint cannot be changed in place",
                              "write it as plain elements and attributes, or export without --into");
  }

  /// Reads the new text and throws InputError unless every frame has the pose of the arm's frame.
  void checkAgain() const {
    const UrdfArm again = parseUrdf(out_.text, file_, tip_);
    requireSameRows(again.arm, arm_, file_);
    const auto isSame = [](const Isometry3d& a, const Isometry3d& b) {
      return isSamePlace(a.translation(), b.translation(), kSamePlacement) &&
             isSameTurn(a.linear(), b.linear(), kSamePlacement);
    };
    for (std::size_t k = 0; k < arm_.rows.size(); ++k)
      if (!isSame(poseOfRow(again.arm.rows[k], 0), poseOfRow(arm_.rows[k], shiftOf(k)))) refuse(read_.joints[k].name);
    if (!isSame(poseOfTool(again.arm), poseOfTool(arm_))) refuse(again.joints.back().name);
  }

  const std::string &text_, &file_;
  const Arm& arm_;
  UrdfArm read_;
  UrdfTags tags_;
  XmlChanges changes_;
  std::string tip_;  ///< name of the tip link in the edited text
  UrdfEdit out_;
};

}  // namespace

UrdfEdit withArmInUrdf(const std::string& text, const std::string& file, const std::string& tip, const Arm& arm) {
  return UrdfEditor(text, file, tip, arm).edit();
}

}  // namespace tubeplan::app
