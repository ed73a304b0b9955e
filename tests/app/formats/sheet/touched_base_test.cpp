// Tests that a base's touches and the uncertainty of an arm's parameters, written to a cell file, are read back.
#include "app/formats/sheet/touched_base.hpp"

#include <cmath>

#include "app/formats/cell/uncertainty_reader.hpp"
#include "app/formats/yaml/yaml_edit.hpp"
#include "deflection/parameters.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

/// Two texts of a cell: one with each key on a separate line, and one with the keys in braces.
class TouchedBases : public FolderTest {
 protected:
  TouchedBases() {
    write("cobra-arm.yaml", contentOf(shippedCells() / "cobra-arm.yaml"));
    texts = {contentOf(shippedCells() / "mockup.yaml"),
             "{arm: cobra-arm.yaml, base: {position: [0, 43, -44], rpy: [0, 0, -90], known: true}}\n"};
  }

  [[nodiscard]] Cell cellOf(const std::string& text) const { return parseCell(text, (folder / "cell.yaml").string()); }

  /// Returns touches, one of which has an id that must be escaped in a table and in a quoted string.
  static std::vector<calibration::Measurement> someTouches(const Cell& cell) {
    std::vector<calibration::Measurement> touches;
    for (int k = 0; k < 3; ++k) {
      calibration::Measurement touch;
      touch.id = k == 1 ? "by \"hand\", twice" : "T" + std::to_string(k);
      touch.kind = calibration::MeasurementKind::kTouch;
      touch.point = "R1" + std::to_string(k) + "C20";
      touch.p_W = Eigen::Vector3d(0.1 * k, 0.3, -0.01 / 3);
      touch.q = Eigen::VectorXd::LinSpaced(cell.arm.jointCount(), 0.1, 1.0 / 3 + k);
      touch.sigma = 1e-4;
      touches.push_back(touch);
    }
    return touches;
  }

  /// Returns the arm with two parameters changed, as a calibration by touches may change them.
  static deflection::Arm movedArm(const Cell& cell) {
    deflection::Arm arm = cell.filedArm();
    for (const char* name : {"tool.joint_stiffness.z", "forearm.a"})
      if (const auto number = deflection::findParameter(arm, name))
        deflection::locate(arm, number->path) = number->value * 1.0123456789;
    return arm;
  }

  std::vector<std::string> texts;
};

TEST_F(TouchedBases, AreReadAsTheyAreWritten) {
  for (const auto& text : texts) {
    const Cell cell = cellOf(text);
    const auto touches = someTouches(cell);
    const deflection::Arm arm = movedArm(cell);
    const std::string written = withTouched(text, cell, touches, arm);
    const Cell again = cellOf(written);
    ASSERT_TRUE(again.placed_by) << written;
    ASSERT_EQ(again.placed_by->touches.size(), touches.size()) << written;
    for (std::size_t k = 0; k < touches.size(); ++k) {
      const auto& touch = again.placed_by->touches[k];
      EXPECT_EQ(touch.id, touches[k].id);
      EXPECT_EQ(touch.point, touches[k].point);
      EXPECT_TRUE(touch.p_W->isApprox(*touches[k].p_W, 1e-11));
      EXPECT_TRUE(touch.q.isApprox(touches[k].q, 1e-11));
      EXPECT_NEAR(touch.sigma, touches[k].sigma, 1e-15);
    }
    int moved = 0;
    for (const auto& number : deflection::parametersOf(arm)) {
      EXPECT_DOUBLE_EQ(deflection::findParameter(again.arm, number.name)->value, number.value) << number.name;
      const double filed = deflection::findParameter(cell.arm, number.name)->value;
      EXPECT_DOUBLE_EQ(deflection::findParameter(again.filedArm(), number.name)->value, filed) << number.name;
      moved += number.value != filed;
    }
    EXPECT_GE(moved, 1);
  }
}

TEST_F(TouchedBases, AreTakenAwayWithoutATrace) {
  for (const auto& text : texts) {
    const Cell cell = cellOf(text);
    const std::string written = withTouched(text, cell, someTouches(cell), movedArm(cell));
    EXPECT_NE(written, text);
    EXPECT_EQ(withoutTouched(written), text);
    EXPECT_EQ(withoutTouched(text), text);
  }
}

TEST_F(TouchedBases, AreForgottenWithTheNumbersThatTheyGave) {
  for (const auto& text : texts) {
    const Cell cell = cellOf(text);
    Cell touched = cellOf(withTouched(text, cell, someTouches(cell), movedArm(cell)));
    const Eigen::Isometry3d X_WB = touched.X_WB;
    for (int times = 0; times < 2; ++times) {
      forgetTouches(touched);
      EXPECT_FALSE(touched.placed_by);
      EXPECT_TRUE(touched.X_WB.isApprox(X_WB, 0)) << "the base stays where it is";
      for (const auto& number : deflection::parametersOf(cell.arm))
        EXPECT_EQ(deflection::findParameter(touched.arm, number.name)->value, number.value) << number.name;
    }
  }
}

TEST_F(TouchedBases, OfAnotherKindAreRefusedByTheirKey) {
  const Cell cell = cellOf(texts.front());
  const std::string good = withTouched(texts.front(), cell, someTouches(cell), movedArm(cell));
  const std::pair<const char*, const char*> changes[] = {
      {"readings: |", "reading: |"}, {",touch,", ",position,"}, {"numbers: [", "numbers: [\"no.such\", "}};
  for (const auto& [from, to] : changes)
    expectSays(messageOf([&, &from = from, &to = to] { (void)cellOf(changed(good, from, to)); }), "touched");
}

TEST_F(TouchedBases, UncertaintiesAreReadAsTheyAreWritten) {
  const Cell cell = cellOf(texts.front());
  calibration::ArmUncertainty some;
  some.stiffness = 0.25;
  some.zero = 1.25e-3;
  some.tip = 0;
  some.determined = {"tool.joint_stiffness.z", "base.shift.x", "base.turn.z"};
  some.covariance.resize(3, 3);
  some.covariance << 4, 1e-3, 1e-4, 1e-3, 1e-6, -5e-8, 1e-4, -5e-8, 2.5e-7;
  for (const auto& uncertainty : {calibration::ArmUncertainty{}, calibration::ArmUncertainty::none(), some}) {
    const std::string value = uncertaintyText(uncertainty, cell.arm, cell.units);
    const Cell again = cellOf(withYamlValue(texts.front(), "uncertainty", value));
    using Kind = double calibration::ArmUncertainty::*;
    for (const Kind kind : {&calibration::ArmUncertainty::stiffness, &calibration::ArmUncertainty::weight,
                            &calibration::ArmUncertainty::zero, &calibration::ArmUncertainty::axis,
                            &calibration::ArmUncertainty::length, &calibration::ArmUncertainty::tip})
      EXPECT_NEAR(again.uncertainty.*kind, uncertainty.*kind, 1e-9 * uncertainty.*kind) << value;
    EXPECT_EQ(again.uncertainty.determined, uncertainty.determined);
    ASSERT_EQ(again.uncertainty.covariance.size(), uncertainty.covariance.size());
    for (Eigen::Index i = 0; i < uncertainty.covariance.rows(); ++i)
      for (Eigen::Index j = 0; j < uncertainty.covariance.cols(); ++j)
        EXPECT_NEAR(again.uncertainty.covariance(i, j), uncertainty.covariance(i, j),
                    4e-6 * std::sqrt(uncertainty.covariance(i, i) * uncertainty.covariance(j, j)))
            << value;
  }
}

}  // namespace
}  // namespace tubeplan::app
