// CalculiX model of an arm: rigid bodies joined by strips of solid elements that are compliant about one axis only.
//
// Each strip is one 20-node brick between two bodies, thin across its bending axis and far wider along that axis than
// long. Its modulus E follows from E h^3 w / 12 = EI, so it bends as a beam of stiffness EI. Its end faces cannot warp,
// so about the other two axes it is stiffer by (width / length)^2 and (width / thickness)^2: practically rigid. A joint
// stiffness K is a short strip with EI = K l centred on the row's origin; a beam is a row of strips. The model uses
// only the unloaded frames of the deflection library, not its deflection laws or load sweep. Weights are forces of
// constant direction. Units: metre, newton.
#pragma once

#include <cassert>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::deflection {

/// Dimensions of the strips; the tip's deflection is converged to 0.03 %. The width matters most: a width of 240 with a
/// thickness of 0.25 leaves an error of 0.003 %, at several times the run time.
struct CalculixMesh {
  double hinge_length = 0.010;  ///< length of the strip of a joint stiffness [m]
  int strips_per_beam = 16;
  double width = 60;       ///< width of a strip, relative to its length
  double thickness = 0.5;  ///< thickness of a strip, relative to its length
};

/// Model of an arm with revolute and fixed rows, whose beams bend about one axis perpendicular to the member; lumped
/// weights are not supported.
class CalculixModel {
 public:
  CalculixModel(const Arm& arm, const Posture& posture, const CalculixMesh& mesh = {})
      : mesh_(mesh), gravity_B_(posture.gravity_B) {
    for (auto* text : {&nodes_, &elements_, &loads_}) *text << std::scientific << std::setprecision(12);
    const auto unloaded = solveFlexibleKinematics(rigidCopy(arm), posture);
    for (std::size_t i = 0; i < arm.rows.size(); ++i) {
      const bool is_last = i + 1 == arm.rows.size();
      addRow(arm.rows[i], unloaded.rows[i].X_BL_rigid, is_last ? unloaded.X_BT.p : unloaded.rows[i + 1].X_BL_rigid.p);
    }
    tip_ = addWeight(unloaded.X_BT.p, posture.load);
  }

  /// Writes the input file. CalculiX prints the tip's displacement at the end of each increment; the last increment
  /// ends at time 1.
  void write(const std::filesystem::path& path) const {
    std::ofstream file(path);
    file << "*NODE, NSET=ALL\n" << nodes_.str() << elements_.str();
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      file << "*NSET, NSET=BODY" << b << "\n";
      for (const int node : bodies_[b].nodes) file << node << ",\n";
      if (b == 0) continue;  // body 0 is the ground
      const int pilot = bodies_[b].pilot;
      file << "*RIGID BODY, NSET=BODY" << b << ", REF NODE=" << pilot << ", ROT NODE=" << pilot + 1 << "\n";
    }
    // Many iterations are allowed, because the stiff axes make the residual grow at the start of an increment. The
    // tolerance of the residual is far below CalculiX's default of 0.5 %.
    file << "*NSET, NSET=TIP\n"
         << tip_ << "\n*BOUNDARY\nBODY0, 1, 3\n*STEP, NLGEOM, INC=200\n"
         << "*CONTROLS, PARAMETERS=TIME INCREMENTATION\n50, 60, 9, 100, 50\n*CONTROLS, PARAMETERS=FIELD\n1.e-5, 1.e-5\n"
         << "*STATIC\n0.125, 1.\n*CLOAD\n"
         << loads_.str() << "*NODE PRINT, NSET=TIP\nU\n*END STEP\n";
  }

 private:
  struct Body {
    std::vector<int> nodes;
    int pilot = 0;  ///< pilot node for the translation; the next node number is for the rotation
  };

  void addRow(const Row<double>& row, const PoseOf<double>& X_BL, const Eigen::Vector3d& p_end) {
    assert(row.joint.type != JointType::kPrismatic && row.weight.lumps.empty());
    for (int k = 0; k < 3; ++k)
      if (std::isfinite(row.joint_stiffness[k])) addHinge(row.joint_stiffness[k], X_BL, k);
    const Eigen::Vector3d member = p_end - X_BL.p;
    const double weight = row.weight.distributed * member.norm();
    if (row.beam)
      addBeam(*row.beam, X_BL, member, weight);
    else
      addWeight(X_BL.p + member / 2, weight);
    addWeight(p_end, row.weight.end);
  }

  /// Adds a strip for a joint stiffness [N m/rad]; the strip may point in any direction perpendicular to the axis.
  void addHinge(double stiffness, const PoseOf<double>& X_BL, int axis) {
    const Eigen::Vector3d half = X_BL.R.col((axis + 1) % 3) * mesh_.hinge_length / 2;
    addStrip(X_BL.p - half, X_BL.p + half, X_BL.R.col(axis), stiffness * mesh_.hinge_length);
  }

  void addBeam(const Beam<double>& beam, const PoseOf<double>& X_BL, const Eigen::Vector3d& member, double weight) {
    assert(beam.I.array().isFinite().count() == 1 && !(std::isfinite(beam.G) && std::isfinite(beam.J)));
    int axis = 0;
    while (!std::isfinite(beam.I[axis])) ++axis;
    assert(std::abs(X_BL.R.col(axis).dot(member)) < 1e-9);
    const int n = mesh_.strips_per_beam;
    for (int s = 0; s < n; ++s) {
      const Eigen::Vector3d p_near = X_BL.p + member * s / n, p_far = X_BL.p + member * (s + 1) / n;
      addWeight(p_near, weight / n / 2);
      addStrip(p_near, p_far, X_BL.R.col(axis), beam.E * beam.I[axis]);
      addWeight(p_far, weight / n / 2);
    }
  }

  /// Adds a strip from the last body to a new one.
  void addStrip(const Eigen::Vector3d& p_near, const Eigen::Vector3d& p_far, const Eigen::Vector3d& axis, double EI) {
    const double length = (p_far - p_near).norm(), h = mesh_.thickness * length, w = mesh_.width * length;
    const Eigen::Vector3d thick = axis.cross(p_far - p_near).normalized() * h / 2, wide = axis * w / 2;
    const auto add = [&](const Eigen::Vector3d& p, std::initializer_list<std::pair<int, int>> places) {
      std::vector<int> added;
      for (const auto& [a, b] : places) added.push_back(addNode(p + a * thick + b * wide));
      return added;
    };
    const auto addFace = [&](const Eigen::Vector3d& p) {
      const auto face = add(p, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}});
      bodies_.back().nodes.insert(bodies_.back().nodes.end(), face.begin(), face.end());
      return face;
    };
    const auto near = addFace(p_near);
    startBody(p_far);
    const auto far = addFace(p_far), middle = add((p_near + p_far) / 2, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    addElement(near, far, middle, 12 * EI / (w * h * h * h));
  }

  /// Adds an element from its faces: four corners each, then the four middle edge nodes, all numbered in the same sense
  /// about the direction from `near` to `far`.
  void addElement(const std::vector<int>& near, const std::vector<int>& far, const std::vector<int>& middle, double E) {
    const auto number = bodies_.size() - 1;
    elements_ << "*ELEMENT, TYPE=C3D20R, ELSET=STRIP" << number << "\n" << number;
    for (int k = 0; k < 4; ++k) elements_ << ", " << near[k];
    for (int k = 0; k < 4; ++k) elements_ << ", " << far[k];
    elements_ << ",\n";
    for (int k = 4; k < 8; ++k) elements_ << near[k] << ", ";
    for (int k = 4; k < 8; ++k) elements_ << far[k] << ", ";
    for (int k = 0; k < 4; ++k) elements_ << middle[k] << (k < 3 ? ", " : "\n");
    elements_ << "*MATERIAL, NAME=STRIP" << number << "\n*ELASTIC\n"
              << E << ", 0.\n"
              << "*SOLID SECTION, ELSET=STRIP" << number << ", MATERIAL=STRIP" << number << "\n";
  }

  void startBody(const Eigen::Vector3d& p) {
    bodies_.push_back({{}, addNode(p)});
    addNode(p);
  }

  /// Adds a weight [N] to the last body and returns the number of its node.
  int addWeight(const Eigen::Vector3d& p, double weight) {
    const int node = addNode(p);
    bodies_.back().nodes.push_back(node);
    for (int k = 0; k < 3; ++k) loads_ << node << ", " << k + 1 << ", " << weight * gravity_B_[k] << "\n";
    return node;
  }

  int addNode(const Eigen::Vector3d& p) {
    nodes_ << ++node_count_ << ", " << p.x() << ", " << p.y() << ", " << p.z() << "\n";
    return node_count_;
  }

  CalculixMesh mesh_;
  Eigen::Vector3d gravity_B_;
  std::ostringstream nodes_, elements_, loads_;
  std::vector<Body> bodies_{1};  ///< the first body is the ground
  int node_count_ = 0, tip_ = 0;
};

}  // namespace tubeplan::deflection
