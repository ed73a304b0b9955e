// The deflection of the complete Cobra arm must agree with the finite-element program CalculiX, also at large
// rotations.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <sstream>
#include <string>

#include "tests/deflection/calculix_model.hpp"
#include "tests/deflection/cobra.hpp"

namespace tubeplan::deflection {
namespace {

namespace fs = std::filesystem;

/// Temporary folder, removed at the end of the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::random_device random;
    do path_ = fs::temp_directory_path() / ("tubeplan-calculix-" + std::to_string(random()));
    while (!fs::create_directory(path_));
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

bool hasCalculix() { return std::system("command -v ccx >/dev/null 2>&1") == 0; }

/// Returns the tip displacement [m] that CalculiX printed at time 1, the end of the step; empty if the analysis stopped
/// earlier.
std::optional<Eigen::Vector3d> readTipDisplacement(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  double time = 0;
  Eigen::Vector3d u = Eigen::Vector3d::Zero();
  bool has_values = false;
  while (std::getline(file, line)) {
    const auto at = line.find("time");
    if (at != std::string::npos) {
      time = std::stod(line.substr(at + 4));
      has_values = false;
      continue;
    }
    std::istringstream values(line);
    int node = 0;
    if (values >> node >> u[0] >> u[1] >> u[2]) has_values = true;
  }
  if (!has_values || std::abs(time - 1) > 1e-6) return std::nullopt;
  return u;
}

std::optional<Eigen::Vector3d> tipDisplacementByCalculix(const Arm& arm, const Posture& posture) {
  const TemporaryFolder folder;
  CalculixModel(arm, posture).write(folder.path() / "arm.inp");
  const std::string command = "cd '" + folder.path().string() + "' && OMP_NUM_THREADS=1 ccx -i arm > arm.log 2>&1";
  if (std::system(command.c_str()) != 0) return std::nullopt;
  return readTipDisplacement(folder.path() / "arm.dat");
}

Eigen::Vector3d tipDisplacement(const Arm& arm, const Posture& posture) {
  const auto shape = solveFlexibleKinematics(arm, posture);
  EXPECT_EQ(shape.status, KinematicsStatus::kConverged);
  return shape.X_BD.p - shape.X_BT.p;
}

struct CalculixCase {
  const char* name;
  Eigen::Vector4d joints;  ///< joint angles [deg]
  double load;             ///< load at the tip [lbf]
};

void PrintTo(const CalculixCase& example, std::ostream* out) { *out << example.name; }

/// Joint angles [deg] of the two example postures of Calkins 1994, tables 5.8 and 5.9: stretched out and folded.
const Eigen::Vector4d kStretched(-36.688, 46.138, -35.856, -11.127), kFolded(73.312, 126.138, -95.856, -31.127);

class CalculixComparison : public ::testing::TestWithParam<CalculixCase> {};

TEST_P(CalculixComparison, TipDeflectsAlike) {
  if (!hasCalculix()) GTEST_SKIP() << "CalculiX (program ccx, Debian package calculix-ccx) is not installed";
  const Posture posture{GetParam().joints * kDegree, GetParam().load * kPound};
  const auto expected = tipDisplacementByCalculix(cobraArm(), posture);
  ASSERT_TRUE(expected) << "CalculiX did not finish the analysis";
  const auto difference = [&](int segments) -> double {
    const Eigen::Vector3d u = tipDisplacement(cobraArm(segments), posture);
    std::ostringstream text;
    text << u.transpose() / kInch << " in, CalculiX " << expected->transpose() / kInch << " in";
    ::testing::Test::RecordProperty("tip_deflection_" + std::to_string(segments) + "_segments", text.str());
    return (u - *expected).norm() / expected->norm();
  };
  EXPECT_LE(difference(1), 0.005);
  // With eight segments the difference must be at most 0.1 %; it is mostly due to the width of the strips in CalculiX.
  EXPECT_LE(difference(8), 0.001);
}

INSTANTIATE_TEST_SUITE_P(Cobra, CalculixComparison,
                         ::testing::Values(CalculixCase{"StretchedOwnWeight", kStretched, 0},
                                           CalculixCase{"StretchedThirtyPounds", kStretched, 30},
                                           CalculixCase{"FoldedOwnWeight", kFolded, 0},
                                           CalculixCase{"FoldedThirtyPounds", kFolded, 30}),
                         [](const auto& parameters) { return std::string(parameters.param.name); });

}  // namespace
}  // namespace tubeplan::deflection
