// Every effect of the catalogue must agree with a closed form, or with an equivalent arm without effects. An effect
// without a case here fails the test.
#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "tests/deflection/central_difference.hpp"
#include "tests/deflection/effects/effect_arms.hpp"

namespace tubeplan::deflection {
namespace {

using Eigen::Vector3d;

constexpr double kLength = 0.8, kStiffness = 3e4, kLoad = 60;

/// Returns a boom along x on a revolute joint with a spring about z; rows can be added to the arm.
Arm boom(double stiffness = kStiffness) {
  Arm arm;
  arm.name = "boom";
  Row<double> row;
  row.name = "boom";
  row.placement = DenavitHartenberg<double>{};
  row.joint.name = "turn";
  row.joint.type = JointType::kRevolute;
  row.joint_stiffness[2] = stiffness;
  arm.rows = {row};
  arm.p_LT = {kLength, 0, 0};
  return arm;
}

/// Returns a boom and a forearm, both along x at zero; the second joint's axis is rotated from the first's by `twist`.
Arm elbow(double twist = 0, double stiffness = kRigid) {
  Arm arm = boom(stiffness);
  Row<double> row;
  row.name = "forearm";
  row.placement = DenavitHartenberg<double>{twist, kLength, 0, 0};
  row.joint.name = "bend";
  row.joint.type = JointType::kRevolute;
  arm.rows.push_back(row);
  return arm;
}

Posture at(std::initializer_list<double> q, double load = kLoad, const Vector3d& gravity = -Vector3d::UnitY()) {
  Posture posture;
  posture.q = Eigen::Map<const Eigen::VectorXd>(q.begin(), static_cast<Eigen::Index>(q.size()));
  posture.load = load;
  posture.gravity_B = gravity;
  return posture;
}

FlexibleKinematics solve(const Arm& arm, const Posture& posture) {
  auto shape = solveFlexibleKinematics(arm, posture, kTight);
  EXPECT_EQ(shape.status, KinematicsStatus::kConverged) << shape.reason;
  return shape;
}

/// Returns the rotation of the tool about the base's z axis [rad].
double angleOf(const FlexibleKinematics& shape) { return std::atan2(shape.X_BD.R(1, 0), shape.X_BD.R(0, 0)); }

/// Returns the equilibrium rotation [rad] of a boom on a joint of the given stiffness, under a moment that depends on
/// the rotation.
double turnUnder(const std::function<double(double)>& moment, double stiffness = kStiffness) {
  double angle = 0;
  for (int k = 0; k < 200; ++k) angle = moment(angle) / stiffness;
  return angle;
}

void expectSame(const Arm& arm, const Posture& posture, const Arm& other, const Posture& other_posture) {
  const auto a = solve(arm, posture), b = solve(other, other_posture);
  EXPECT_LE((a.X_BD.p - b.X_BD.p).norm() + (a.X_BD.R - b.X_BD.R).norm(), 1e-12);
  EXPECT_LE((a.X_BT.p - b.X_BT.p).norm(), 1e-12);
}

/// Expects that an effect on the reading of the Cobra's theta3 is equivalent to a reading changed by `change`.
void expectReadingChange(const std::string& name, const std::vector<double>& values, double reading, double change) {
  const Arm arm = cobraArm();
  const Posture posture = at({0.2, 1.1, reading, -0.3}, kLoad, -Vector3d::UnitZ());
  Posture changed = posture;
  changed.q[2] += change;
  expectSame(withEffect(arm, name, "theta3", values), posture, arm, changed);
}

void jointOffset() { expectReadingChange("joint-offset", {0.013}, -0.7, 0.013); }
void jointScale() { expectReadingChange("joint-scale", {0.004}, -0.7, -0.7 * 0.004); }
void encoderEccentricity() {
  expectReadingChange("encoder-eccentricity", {2e-3, -1e-3}, -0.7, 2e-3 * std::sin(-0.7) - 1e-3 * std::cos(-0.7));
}
void transmissionError() {
  expectReadingChange("transmission-error", {2e-3, -1e-3}, -0.7, 2e-3 * std::sin(-1.4) - 1e-3 * std::cos(-1.4));
}

void hysteresis() {
  const Arm arm = cobraArm(), loose = withEffect(arm, "hysteresis", "theta3", {0.002});
  const Posture unknown = at({0.2, 1.1, -0.7, -0.3});
  expectSame(loose, unknown, arm, unknown);
  for (int approach_direction : {-1, 0, 1}) {
    Posture posture = unknown, changed = unknown;
    posture.approach_directions = {1, -1, approach_direction, 1};
    changed.q[2] += 0.002 * approach_direction;
    expectSame(loose, posture, arm, changed);
  }
}

void jointCoupling() {
  const Arm arm = cobraArm();
  const Posture posture = at({0.2, 1.1, -0.7, -0.3});
  Posture changed = posture;
  changed.q[2] += 0.02 * 1.1;
  expectSame(withEffect(arm, "joint-coupling", "theta3<-theta2", {0.02}), posture, arm, changed);
}

void screwCoupling() {
  const Arm arm = mastArm();
  const Posture posture = at({0.2, 0.3, -0.4, 0.25}, kLoad, -Vector3d::UnitZ());
  Posture changed = posture;
  changed.q[1] += 1.5e-3 * -0.4;
  expectSame(withEffect(arm, "screw-coupling", "joint-of-mast<-joint-of-wrist", {1.5e-3}), posture, arm, changed);
}

void linkLength() {
  EXPECT_NEAR(solve(withEffect(elbow(), "link-length", "boom", {0.01}), at({0, 0})).X_BD.p.x(), 2 * kLength + 0.01,
              1e-15);
  Arm placed = elbow();
  placed.rows[1].placement = Origin<double>{{0.3, 0.4, 0}, {0, 0, 0}};
  const Vector3d tip = solve(withEffect(placed, "link-length", "boom", {0.05}), at({0, 0})).X_BD.p;
  EXPECT_LE((tip - Vector3d(0.33 + kLength, 0.44, 0)).norm(), 1e-14);
}

void linkTwist() {
  const double twist = 0.03;
  const Posture posture = at({0.1, 0.4}, 0);
  expectSame(withEffect(elbow(), "link-twist", "boom", {twist}), posture, elbow(twist), posture);
  Arm placed = elbow();
  placed.rows[1].placement = Origin<double>{{kLength, 0, 0}, {0, 0, 0}};
  expectSame(withEffect(placed, "link-twist", "boom", {twist}), posture, elbow(twist), posture);
}

void linkLean() {
  const double lean = 0.03;
  const Posture posture = at({0.1, 0.4}, 0);
  Arm placed = elbow();
  placed.rows[1].placement = Origin<double>{{kLength, 0, 0}, {0, lean, 0}};
  expectSame(withEffect(elbow(), "link-lean", "boom", {lean}), posture, placed, posture);
  placed.rows[1].placement = Origin<double>{{kLength, 0, 0}, {0, 0, 0}};
  Arm leaning = elbow();
  std::get<DenavitHartenberg<double>>(leaning.rows[1].placement).beta = lean;
  expectSame(withEffect(placed, "link-lean", "boom", {lean}), posture, leaning, posture);
}

void toolOffset() {
  const Vector3d tip = solve(withEffect(boom(), "tool-offset", "tool", {0.01, -0.02, 0.03}), at({0}, 0)).X_BD.p;
  EXPECT_LE((tip - Vector3d(kLength + 0.01, -0.02, 0.03)).norm(), 1e-15);
}

/// The effect must rotate the tool frame about the last row's x axis, before the drawn rotation, and must not move the
/// last row's frame or the tip.
void toolTurn() {
  Arm arm = boom();
  arm.R_LT = rotationZ<double>(0.7);
  const auto turned = solve(withEffect(arm, "tool-turn", "tool", {0.02, 0, 0}), at({0.4}, 0)),
             drawn = solve(arm, at({0.4}, 0));
  EXPECT_LE((turned.R_LT - rotationX<double>(0.02) * rotationZ<double>(0.7)).norm(), 1e-15);
  EXPECT_LE((turned.X_BD.R - drawn.X_BD.R).norm() + (turned.X_BD.p - drawn.X_BD.p).norm(), 1e-15);
  Arm by_number = arm;
  by_number.tool_turn_L.x() = 0.02;
  EXPECT_LE((toolFrame(by_number) - turned.R_LT).norm(), 1e-15);
}

void thermalGrowth() {
  Arm arm = elbow();
  arm.rows[0].placement = DenavitHartenberg<double>{0, 0.5, 0, 0};
  arm.reference[Condition::kTemperature] = 290;
  const Arm warm = withEffect(arm, "thermal-growth", "arm", {2e-5});
  Posture posture = at({0, 0}, 0);
  EXPECT_NEAR(solve(warm, posture).X_BD.p.x(), 0.5 + 2 * kLength, 1e-15);
  posture.conditions[Condition::kTemperature] = 320;
  // The offset from the base to the first joint belongs to the base and must not grow.
  EXPECT_NEAR(solve(warm, posture).X_BD.p.x(), 0.5 + 2 * kLength * (1 + 2e-5 * 30), 1e-15);
}

void linkWeight() {
  const double weight = 25;
  const auto shape = solve(withEffect(boom(), "link-weight", "boom", {weight}), at({0}, 0));
  EXPECT_NEAR(angleOf(shape), turnUnder([&](double a) { return -weight * kLength * std::cos(a); }), 1e-14);
}

void toolWeight() {
  Arm arm = boom();
  arm.rows[0].weight.distributed = 100;
  arm.rows[0].weight.end = 30;
  arm.rows[0].weight.lumps = {{20, {0.4, 0, 0}}};
  const auto shape = solve(withEffect(arm, "tool-weight", "tool", {0.3}), at({0}));
  const double own = 100 * kLength * kLength / 2 + 30 * kLength + 20 * 0.4;
  EXPECT_NEAR(angleOf(shape), turnUnder([&](double a) { return -(1.3 * own + kLoad * kLength) * std::cos(a); }), 1e-14);
}

void payloadOffset() {
  Arm arm = boom();
  arm.rows[0].weight.end = 30;
  const auto shape = solve(withEffect(arm, "payload-offset", "payload", {0.1, 0.2, 0}), at({0}));
  // Only the hung load must be displaced from the tip, by an offset that rotates with the boom.
  const auto moment = [&](double a) {
    return -30 * kLength * std::cos(a) - kLoad * ((kLength + 0.1) * std::cos(a) - 0.2 * std::sin(a));
  };
  EXPECT_NEAR(angleOf(shape), turnUnder(moment), 1e-14);
  EXPECT_NEAR(shape.rows[0].force_B.y(), -30 - kLoad, 1e-12);
}

void gravityTilt() {
  const double tilt = 0.02;
  const auto shape = solve(withEffect(boom(), "gravity-tilt", "base", {tilt, 0}), at({0}, kLoad, -Vector3d::UnitZ()));
  // Gravity along the joint's axis has no moment about it. Tilted about x, gravity has a component along y, which must
  // rotate the joint.
  EXPECT_NEAR(angleOf(shape), turnUnder([&](double a) { return kLoad * std::sin(tilt) * kLength * std::cos(a); }),
              1e-14);
}

void hosePull() {
  Arm arm = elbow();
  arm.rows[0].beam = Beam<double>{};
  arm.rows[0].beam->E = 2e11;
  arm.rows[0].beam->I[2] = 2.5e-7;
  const double EI = 5e4, pull = 0.5;
  const auto shape = solve(withEffect(arm, "hose-pull", "boom", {0, pull, 0}), at({0, 0}, 0));
  EXPECT_NEAR(shape.rows[1].X_BL.p.y(), pull * std::pow(kLength, 3) / (3 * EI), 1e-6 * pull / EI);
  EXPECT_NEAR(angleOf(shape), pull * kLength * kLength / (2 * EI), 1e-6 * pull / EI);
  EXPECT_NEAR(shape.rows[0].force_B.y(), pull, 1e-15);
  EXPECT_LE(shape.rows[1].force_B.norm(), 0);
}

void contactForce() {
  const Arm arm = boom();
  expectSame(withEffect(arm, "contact-force", "tip", {20}), at({0.3}), arm, at({0.3}, kLoad - 20));
}

void jointCompliance() {
  Arm soft = boom();
  const Posture posture = at({0.2});
  expectSame(withEffect(boom(kRigid), "joint-compliance", "boom.z", {1 / kStiffness}), posture, soft, posture);
  soft.rows[0].joint_stiffness[0] = 5e3;
  const Posture aside = at({0.2}, kLoad, Vector3d(0.3, -0.4, -0.5).normalized());
  expectSame(withEffect(boom(), "joint-compliance", "boom.x", {1 / 5e3}), aside, soft, aside);
}

void linkBending() {
  const double b = 2e-5;
  const auto shape = solve(withEffect(boom(kRigid), "link-bending", "boom.z", {b}), at({0}, 0.5));
  EXPECT_NEAR(shape.X_BD.p.y(), -0.5 * std::pow(kLength, 3) * b / 3, 1e-6 * b);
  Arm bent = boom();
  bent.rows[0].beam = Beam<double>{};
  bent.rows[0].beam->E = 1e11;
  bent.rows[0].beam->I = {kRigid, 4e-7, 5e-7};
  Arm other = bent;
  other.rows[0].beam->I[1] = kRigid;
  const Posture posture = at({0.2}, kLoad, Vector3d(0.3, -0.4, -0.5).normalized());
  expectSame(withEffect(other, "link-bending", "boom.y", {1 / (1e11 * 4e-7)}), posture, bent, posture);
}

void linkTorsion() {
  const double t = 5e-5, aside = 0.25;
  Arm arm = elbow();
  arm.rows[1].weight.lumps = {{4, {0, 0, aside}}};
  const auto shape = solve(withEffect(arm, "link-torsion", "boom", {t}), at({0, 0}, 0));
  EXPECT_NEAR(std::atan2(shape.X_BD.R(2, 1), shape.X_BD.R(2, 2)), 4 * aside * kLength * t, 1e-6 * t);
  Arm bent = arm, other = arm;
  bent.rows[0].beam = Beam<double>{1e11, {kRigid, 4e-7, 5e-7}, 4e10, 1 / (4e10 * t), 3};
  other.rows[0].beam = Beam<double>{1e11, {kRigid, 4e-7, 5e-7}, kRigid, kRigid, 3};
  expectSame(withEffect(other, "link-torsion", "boom", {t}), at({0.2, 0.1}), bent, at({0.2, 0.1}));
}

void stiffening() {
  const double softness = 0.6, knee = 20;
  const Arm arm = withEffect(boom(), "stiffening", "boom.z", {softness, knee});
  const auto moment = [](double load) { return [load](double a) { return -load * kLength * std::cos(a); }; };
  const double below = 15, beyond = 200;
  EXPECT_NEAR(angleOf(solve(arm, at({0}, below))), turnUnder(moment(below), kStiffness / (1 + softness)), 1e-15);
  // The spring must be piecewise linear: soft up to the knee moment, with the stated stiffness beyond it.
  const auto past_knee = [&](double a) { return moment(beyond)(a) - softness * knee; };
  EXPECT_NEAR(angleOf(solve(arm, at({0}, beyond))), turnUnder(past_knee), 1e-15);
  EXPECT_NEAR(angleOf(solve(arm, at({0}, beyond, Vector3d::UnitY()))), -turnUnder(past_knee), 1e-15);
}

void lostMotion() {
  // Beside a joint-compliance of the same stiffness, the soft zone must equal that of an axis with joint_stiffness.
  const double softness = 0.6, knee = 20;
  const Arm flexible = withEffect(boom(), "stiffening", "boom.z", {softness, knee});
  const Arm compliant = withEffect(boom(kRigid), "joint-compliance", "boom.z", {1 / kStiffness});
  const Arm arm = withEffect(compliant, "lost-motion", "boom.z", {softness / kStiffness, knee});
  for (const double load : {15., 200.})
    for (const double aside : {-1., 1.}) {
      const Posture posture = at({0.2}, load, aside * Vector3d::UnitY());
      expectSame(arm, posture, flexible, posture);
    }
}

void backlash() {
  const double gap = 0.01;
  const Arm arm = withEffect(boom(), "backlash", "boom.z", {gap});
  for (double up : {-1., 1.}) {
    // The joint must rotate by half the gap in the direction of the moment, in addition to the deflection of the
    // spring.
    double angle = 0;
    for (int k = 0; k < 200; ++k) angle = up * (kLoad * kLength * std::cos(angle) / kStiffness + gap / 2);
    EXPECT_NEAR(angleOf(solve(arm, at({0}, kLoad, up * Vector3d::UnitY()))), angle, 1e-14);
  }
  // A hanging boom must hang straight down inside the gap; beyond the gap it must rest on the gap's end and load the
  // spring.
  for (double off : {-0.02, -0.0049, 0., 0.003, 0.0049, 0.02}) {
    const auto shape = solve(arm, at({-std::numbers::pi / 2 + off}));
    const double free = std::clamp(off, -gap / 2, gap / 2);
    double angle = off - free;
    for (int k = 0; k < 200; ++k) angle = off - free - kLoad * kLength * std::sin(angle) / kStiffness;
    EXPECT_NEAR(angleOf(shape) + std::numbers::pi / 2, angle, 1e-12) << off;
    EXPECT_NEAR(shape.rows[0].moment_L.z(), -kLoad * kLength * std::sin(angle), 1e-10) << off;
  }
  // An upright boom must fall to the side to which it is tilted.
  for (double off : {-0.001, 0.001}) {
    const auto shape = solve(arm, at({std::numbers::pi / 2 + off}));
    EXPECT_NEAR(shape.components[0].gap.z(), off > 0 ? gap / 2 : -gap / 2, 1e-15);
  }
}

void baseSlip() {
  const Arm arm = boom(), slipped = withEffect(arm, "base-slip", "base", {0.01, -0.02, 0.03, 0.1, 500});
  Posture posture = at({0.3});
  const auto now = solve(slipped, posture);
  posture.conditions[Condition::kTime] = 499;
  expectSame(slipped, posture, arm, posture);
  posture.conditions[Condition::kTime] = 500;
  expectSame(slipped, posture, slipped, at({0.3}));
  // A rotation of the base by the yaw must be equivalent to a joint reading changed by the yaw, under the same gravity.
  const auto as_read = solve(arm, at({0.3 + 0.1}));
  EXPECT_LE((now.X_BD.p - as_read.X_BD.p - Vector3d(0.01, -0.02, 0.03)).norm(), 1e-14);
  EXPECT_LE((now.rows[0].X_BL.R - as_read.rows[0].X_BL.R).norm(), 1e-14);
  EXPECT_LE((now.rows[0].moment_B - as_read.rows[0].moment_B).norm(), 1e-11);
  EXPECT_LE((now.rows[0].force_B - Vector3d(0, -kLoad, 0)).norm(), 1e-12);
}

void baseDrift() {
  const Arm arm = boom(), drifting = withEffect(arm, "base-drift", "base", {1e-6, 2e-6, -3e-6});
  Posture posture = at({0.3});
  expectSame(drifting, posture, arm, posture);
  posture.conditions[Condition::kTime] = 2000;
  const Vector3d moved = solve(drifting, posture).X_BD.p - solve(arm, posture).X_BD.p;
  EXPECT_LE((moved - Vector3d(2e-3, 4e-3, -6e-3)).norm(), 1e-15);
}

void scaleError() {
  const Arm arm = boom(), scaled = withEffect(arm, "scale-error", "measurement", {1e-3});
  EXPECT_DOUBLE_EQ(measurementScale(scaled), 1.001);
  EXPECT_EQ(measurementScale(arm), 1);
  expectSame(scaled, at({0.3}), arm, at({0.3}));
}

void gearWave() {
  Arm arm = elbow();
  arm.rows[1].joint.gear_ratio = 50;
  const Posture posture = at({0.2, 0.37});
  Posture changed = posture;
  changed.q[1] += 2e-3 * std::sin(50 * 0.37) - 1e-3 * std::cos(50 * 0.37);
  expectSame(withEffect(arm, "gear-wave", "bend", {2e-3, -1e-3}), posture, arm, changed);
}

void toolRemount() {
  const Arm arm = withEffect(boom(), "tool-remount", "second floor", {0.01, -0.02, 0.03});
  Posture posture = at({0}, 0);
  EXPECT_LE((solve(arm, posture).X_BD.p - Vector3d(kLength, 0, 0)).norm(), 1e-15);
  posture.setup = "second floor";
  EXPECT_LE((solve(arm, posture).X_BD.p - Vector3d(kLength + 0.01, -0.02, 0.03)).norm(), 1e-15);
}

void gravitySag() {
  // Gravity along -y must rotate the boom in proportion to the horizontal lever arms of its parts and of its tip.
  const double x = 4e-3, y = 1e-3, tip = 2e-3, reading = 0.3;
  const double level = (x + kLength * tip) * std::cos(reading) - y * std::sin(reading);
  const Arm arm = boom(kRigid);
  expectSame(withEffect(arm, "gravity-sag", "turn", {x, y, tip}), at({reading}), arm, at({reading - level}));
}

void cableStretch() {
  const double stretch = 2e-5, friction = 5e-6, reading = 0.3;
  const Arm arm = boom(kRigid), cabled = withEffect(arm, "cable-stretch", "turn", {stretch, friction});
  const double moment = -kLoad * kLength * std::cos(reading);
  for (const int approach_direction : {-1, 0, 1}) {
    Posture posture = at({reading});
    posture.approach_directions = {approach_direction};
    expectSame(cabled, posture, arm,
               at({reading + stretch * moment + friction * std::abs(moment) * approach_direction}));
  }
}

void slideBendsBy(const Arm& arm, double reading, double out) {
  const double linear = 2e-6, square = 1e-6, cube = 3e-6;
  Arm soft = arm;
  soft.rows[3].joint_stiffness[0] = 1 / (linear * out + square * out * out + cube * out * out * out);
  const Posture posture = at({0.2, 0.3, -0.4, reading}, kLoad, -Vector3d::UnitZ());
  expectSame(withEffect(arm, "slide-bending", "slider.x", {linear, square, cube}), posture, soft, posture);
}

void slideBending() {
  Arm arm = mastArm();
  Joint<double>& slide = arm.rows[3].joint;
  const double out = 0.4;
  slideBendsBy(arm, slide.lower + out * (slide.upper - slide.lower), out);
  slide.lower = -std::numeric_limits<double>::infinity();
  slideBendsBy(arm, 0.7, 0.7);  // without limits, the extension is the reading itself [m]
  const Posture in = at({0.2, 0.3, -0.4, -0.1}, kLoad, -Vector3d::UnitZ());
  expectSame(withEffect(arm, "slide-bending", "slider.x", {2e-6, 1e-6, 3e-6}), in, arm, in);
}

const std::map<std::string, void (*)()>& closedForms() {
  static const std::map<std::string, void (*)()> kCases{{"joint-offset", jointOffset},
                                                        {"joint-scale", jointScale},
                                                        {"encoder-eccentricity", encoderEccentricity},
                                                        {"transmission-error", transmissionError},
                                                        {"hysteresis", hysteresis},
                                                        {"joint-coupling", jointCoupling},
                                                        {"screw-coupling", screwCoupling},
                                                        {"link-length", linkLength},
                                                        {"link-twist", linkTwist},
                                                        {"link-lean", linkLean},
                                                        {"tool-offset", toolOffset},
                                                        {"tool-turn", toolTurn},
                                                        {"thermal-growth", thermalGrowth},
                                                        {"link-weight", linkWeight},
                                                        {"tool-weight", toolWeight},
                                                        {"payload-offset", payloadOffset},
                                                        {"gravity-tilt", gravityTilt},
                                                        {"hose-pull", hosePull},
                                                        {"contact-force", contactForce},
                                                        {"joint-compliance", jointCompliance},
                                                        {"link-bending", linkBending},
                                                        {"link-torsion", linkTorsion},
                                                        {"stiffening", stiffening},
                                                        {"lost-motion", lostMotion},
                                                        {"backlash", backlash},
                                                        {"base-slip", baseSlip},
                                                        {"base-drift", baseDrift},
                                                        {"scale-error", scaleError},
                                                        {"gear-wave", gearWave},
                                                        {"tool-remount", toolRemount},
                                                        {"gravity-sag", gravitySag},
                                                        {"cable-stretch", cableStretch},
                                                        {"slide-bending", slideBending}};
  return kCases;
}

class EffectClosedForm : public ::testing::TestWithParam<std::string> {};

TEST_P(EffectClosedForm, Holds) {
  const auto found = closedForms().find(GetParam());
  ASSERT_NE(found, closedForms().end()) << "no closed form for " << GetParam();
  found->second();
}

std::vector<std::string> kindNames() {
  std::vector<std::string> names;
  for (const EffectKind& kind : effectKinds())
    if (std::string(kind.name) != "formula")
      names.emplace_back(kind.name);  // the kind "formula" is tested by formula_test.cpp
  return names;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EffectClosedForm, ::testing::ValuesIn(kindNames()), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(Backlash, TwoClearancesInAChainHangStraightDown) {
  Arm arm = withEffect(elbow(), "backlash", "boom.z", {0.02});
  arm = withEffect(arm, "backlash", "forearm.z", {0.02});
  arm.rows[0].weight.distributed = 50;
  const auto shape = solve(arm, at({-std::numbers::pi / 2 + 0.004, -0.007}));
  EXPECT_NEAR(shape.rows[0].moment_L.z(), 0, 1e-9);
  EXPECT_NEAR(shape.rows[1].moment_L.z(), 0, 1e-9);
  EXPECT_NEAR(shape.X_BD.p.x(), 0, 1e-11);
}

TEST(Backlash, IsComplementaryOverPosturesOfTheCobra) {
  std::mt19937_64 random(41);
  const double gap = 0.02;
  const Arm arm = withEffect(withEffect(cobraArm(), "backlash", "tool.z", {gap}), "backlash", "forearm.z", {gap});
  int hanging = 0;
  for (int n = 0; n < 3000; ++n) {
    Posture posture = randomPosture(arm, random);
    posture.gravity_B = -Vector3d::UnitZ();
    const auto shape = solve(arm, posture);
    for (const auto& component : shape.components) {
      if (component.row < 4) continue;
      const double free = component.gap.z(), moment = shape.rows[component.row].moment_L.z();
      ASSERT_LE(std::abs(free), gap / 2);
      if (std::abs(free) < gap / 2) {
        ++hanging;
        EXPECT_NEAR(moment, 0, 1e-7);
      } else {
        EXPECT_GE(moment * free, 0);
      }
    }
  }
  EXPECT_GT(hanging, 5);
}

TEST(Backlash, AnAxisAlongGravityStaysWhereItIs) {
  Arm arm = withEffect(boom(), "backlash", "boom.z", {0.02});
  const auto tip = differentiateTip(arm, at({0.3}, kLoad, -Vector3d::UnitZ()), jointVariables(arm), kTight);
  EXPECT_EQ(tip.kinematics.components[0].gap.z(), 0);
  EXPECT_NEAR(tip.position_B.norm(), kLength, 1e-12);
}

}  // namespace
}  // namespace tubeplan::deflection
