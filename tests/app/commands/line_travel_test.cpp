// With `tubeplan plan --travel line`, the written path moves the tip along straight lines; requests that cannot be met
// are refused.
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/formats/cell/workcell.hpp"
#include "deflection/flexible_kinematics.hpp"
#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using Eigen::Vector3d, Eigen::VectorXd;

struct Row {
  int segment;
  std::string kind;
  VectorXd q;
};

std::vector<Row> pathOf(const std::string& text) {
  std::istringstream lines(text);
  std::string line, cell;
  std::getline(lines, line);
  std::vector<Row> rows;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    Row row;
    std::getline(cells, cell, ',');
    std::getline(cells, cell, ',');
    row.segment = std::stoi(cell);
    std::getline(cells, row.kind, ',');
    row.q.resize(4);
    for (double& q : row.q) {
      std::getline(cells, cell, ',');
      q = std::stod(cell) * 0.017453292519943295;
    }
    rows.push_back(row);
  }
  return rows;
}

class LineTravelCommand : public ProgramTest {
 protected:
  LineTravelCommand() {
    for (const char* name : {"mockup.yaml", "cobra-arm.yaml"}) write(name, contentOf(shippedCells() / name));
  }
};

TEST_F(LineTravelCommand, MovesTheTipAlongARowOnLines) {
  const Outcome outcome = run("plan mockup.yaml --tubes R20C30-44 --travel line --out out");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto plan = nlohmann::json::parse(contentOf(folder / "out/plan.json"));
  ASSERT_EQ(plan["travel"]["kind"], "line");
  const int visits = static_cast<int>(plan["tubes"].size());
  ASSERT_GE(visits, 5);
  EXPECT_GE(plan["travel"]["on_line"].get<int>(), visits / 2);
  EXPECT_LE(plan["travel"]["line_deviation"].get<double>(), 0.002);
  EXPECT_EQ(run("verify out/cell.yaml out").exit_code, 0);

  const auto cell = workcellOf(readCell((folder / "out/cell.yaml").string()), "look at its tip");
  const auto tipAt = [&](const VectorXd& q) -> Vector3d {
    const auto shape =
        deflection::solveFlexibleKinematics(cell.arm, {q, 0, deflection::gravityInBase(cell.arm, cell.X_WB)});
    return cell.X_WB * shape.X_BD.p;
  };
  const auto rows = pathOf(contentOf(folder / "out/path.csv"));
  int points = 0, on_line = 0;
  for (std::size_t first = 0; first < rows.size();) {
    std::size_t last = first;
    while (last + 1 < rows.size() && rows[last + 1].segment == rows[first].segment) ++last;
    if (rows[first].kind == "travel") {
      const Vector3d a = tipAt(rows[first].q), b = tipAt(rows[last].q), along = (b - a).normalized();
      double worst = 0;
      for (std::size_t k = first; k <= last; ++k, ++points) {
        const Vector3d off = tipAt(rows[k].q) - a;
        worst = std::max(worst, (off - along * along.dot(off)).norm());
      }
      on_line += worst <= 0.0021 * 0.0254;
    }
    first = last + 1;
  }
  EXPECT_GE(on_line, plan["travel"]["on_line"].get<int>());
  EXPECT_GT(points, visits);
}

TEST_F(LineTravelCommand, RefusesWhatCannotKeepToALine) {
  Outcome outcome = run("plan mockup.yaml --tubes R20C30-33 --travel straight --out out");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("joints or line"), std::string::npos) << outcome.err;
  outcome = run("plan mockup.yaml --tubes R20C30-33 --travel line --compensation none --out out");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("via-point"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace tubeplan::app
