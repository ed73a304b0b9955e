// Shapes under user-defined formulas must agree with closed forms, their derivatives with difference quotients, and
// invalid formulas must be refused.
#include "deflection/effects/formula.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "tests/deflection/central_difference.hpp"
#include "tests/deflection/effects/effect_arms.hpp"

namespace tubeplan::deflection {
namespace {

const FormulaUnits kCobraUnits{kInch, kDegree, kPound, {{{{5. / 9, 459.67}, {60, 0}}}}};  // in, deg, lbf, degF, min

Arm withFormula(Arm arm, const std::string& text, const FormulaUnits& units = {}) {
  const MadeFormula made = makeFormula(arm, text, units);
  EXPECT_EQ(made.status, FormulaStatus::kMade) << text << ": found " << made.found << ", expected " << made.expected;
  arm.effects.push_back(made.effect);
  return arm;
}

double distanceOf(const FlexibleKinematics& a, const FlexibleKinematics& b) {
  EXPECT_EQ(a.status, KinematicsStatus::kConverged) << a.reason;
  EXPECT_EQ(b.status, KinematicsStatus::kConverged) << b.reason;
  return (a.X_BD.p - b.X_BD.p).norm() + (a.X_BD.R - b.X_BD.R).norm();
}

TEST(Formula, OfAJointMovesItByTheExpression) {
  std::mt19937_64 random(41);
  const Arm arm = cobraArm();
  const Arm with = withFormula(arm, "theta3 += c*sin(3*theta1) + b; c=0.02, b=-0.01");
  for (int n = 0; n < 20; ++n) {
    const Posture posture = randomPosture(arm, random);
    Posture moved = posture;
    moved.q[2] += 0.02 * std::sin(3 * posture.q[0]) - 0.01;
    EXPECT_LE(distanceOf(solveFlexibleKinematics(with, posture, kTight), solveFlexibleKinematics(arm, moved, kTight)),
              1e-13);
  }
}

TEST(Formula, SaysTheSameAsTheCatalogue) {
  const Arm arm = cobraArm();
  const std::pair<const char*, Arm> pairs[] = {
      {"theta2 += a*sin(2*theta2) + b*cos(2*theta2); a=0.003, b=-0.002",
       withEffect(arm, "transmission-error", "theta2", {0.003, -0.002})},
      {"theta4 += h*theta4_dir; h=0.004", withEffect(arm, "hysteresis", "theta4", {0.004})},
      {"theta3 += s*theta2; s=0.01", withEffect(arm, "joint-coupling", "theta3<-theta2", {0.01})},
      {"tip.y += c; c=0.003", withEffect(arm, "tool-offset", "tool", {0, 0.003, 0})},
      {"base.z += r*time; r=0.000002", withEffect(arm, "base-drift", "base", {0, 0, 2e-6})},
      {"base.yaw += c*(time >= 90 ? 1 : 0); c=0.01", withEffect(arm, "base-slip", "base", {0, 0, 0, 0.01, 90})},
  };
  std::mt19937_64 random(42);
  for (const auto& [text, catalogue] : pairs) {
    const Arm formula = withFormula(arm, text);
    for (int n = 0; n < 10; ++n) {
      const Posture posture = randomPosture(arm, random);
      EXPECT_LE(distanceOf(solveFlexibleKinematics(formula, posture, kTight),
                           solveFlexibleKinematics(catalogue, posture, kTight)),
                1e-13)
          << text;
      const auto a = differentiateTip(formula, posture, jointVariables(arm), kTight);
      const auto b = differentiateTip(catalogue, posture, jointVariables(arm), kTight);
      EXPECT_LE((a.position_B - b.position_B).norm() + (a.rotation_B - b.rotation_B).norm(), 1e-9) << text;
    }
  }
}

TEST(Formula, HasTheUnitsOfItsFile) {
  const Arm arm = cobraArm();
  std::mt19937_64 random(43);
  const Posture posture = randomPosture(arm, random);
  const double load = posture.load / kPound, degF = posture.conditions[Condition::kTemperature] * 9 / 5 - 459.67,
               minutes = posture.conditions[Condition::kTime] / 60;
  const std::pair<const char*, double> turns[] = {
      {"theta1 += 0.5", 0.5 * kDegree},
      {"theta1 += c*theta2; c=0.5", 0.5 * kDegree * posture.q[1]},
      {"theta1 += c*load; c=0.01", 0.01 * kDegree * load},
      {"theta1 += c*(temperature - 68); c=0.01", 0.01 * kDegree * (degF - 68)},
      {"theta1 += c*time; c=0.001", 0.001 * kDegree * minutes},
  };
  for (const auto& [text, turn] : turns) {
    Posture moved = posture;
    moved.q[0] += turn;
    EXPECT_LE(distanceOf(solveFlexibleKinematics(withFormula(arm, text, kCobraUnits), posture, kTight),
                         solveFlexibleKinematics(arm, moved, kTight)),
              1e-12)
        << text;
  }
  const Arm tip = withFormula(arm, "tip.x += c; c=0.25", kCobraUnits);
  EXPECT_EQ(tip.effects[0].values[0], 0.25 * kInch);
  EXPECT_EQ(findParameter(tip, "formula@tip.x.c")->quantity, Quantity::kLength);
  const Arm turned = withFormula(arm, "theta1 += c*sin(k*theta2); c=0.5; k=3", kCobraUnits);
  EXPECT_EQ(findParameter(turned, "formula@theta1.c")->quantity, Quantity::kAngle);
  EXPECT_DOUBLE_EQ(findParameter(turned, "formula@theta1.c")->value, 0.5 * kDegree);
  EXPECT_EQ(findParameter(turned, "formula@theta1.k")->quantity, Quantity::kNone);
  EXPECT_EQ(findParameter(turned, "formula@theta1.k")->value, 3);
}

TEST(Formula, OfASlideIsALength) {
  const Arm arm = mastArm();
  const Arm with = withFormula(arm, "joint-of-mast += c*joint_of_slider; c=0.1", {.length = kInch, .angle = kDegree});
  EXPECT_EQ(findParameter(with, "formula@joint-of-mast.c")->quantity, Quantity::kLength);
  std::mt19937_64 random(44);
  const Posture posture = randomPosture(arm, random);
  Posture moved = posture;
  moved.q[1] += 0.1 * posture.q[3];
  EXPECT_LE(distanceOf(solveFlexibleKinematics(with, posture, kTight), solveFlexibleKinematics(arm, moved, kTight)),
            1e-13);
}

TEST(Formula, ReadsMomentsOfTheUndeflectedArm) {
  std::mt19937_64 random(45);
  for (const Arm& arm : effectArms()) {
    const auto symbols = formulaSymbols(arm, {});
    for (int n = 0; n < 5; ++n) {
      const Posture posture = randomPosture(arm, random);
      const auto rigid = solveFlexibleKinematics(rigidCopy(arm), posture, kTight);
      for (const std::string& joint : formulaTargets(arm)) {
        if (joint.find('.') != std::string::npos) break;
        for (const NamedSymbol& named : symbols) {
          if (named.symbol.of != FormulaSymbol::Of::kMoment) continue;
          Posture moved = posture;
          const Arm with = withFormula(arm, joint + " += 1e-5*" + named.name);
          const int index = jointIndexOf(arm, with.effects[0].place.row);
          moved.q[index] += 1e-5 * rigid.rows[named.symbol.row].moment_L[named.symbol.axis];
          ASSERT_LE(
              distanceOf(solveFlexibleKinematics(with, posture, kTight), solveFlexibleKinematics(arm, moved, kTight)),
              1e-11)
              << arm.name << " " << named.name;
        }
        break;
      }
    }
  }
}

TEST(Formula, AtZeroSizesDoesNothing) {
  std::mt19937_64 random(46);
  for (const Arm& arm : effectArms())
    for (const std::string& target : formulaTargets(arm)) {
      const std::string joint = formulaTargets(arm).back() == target ? "load" : "time";
      const Arm with = withFormula(arm, target + " += a*load + b*sin(k*" + joint + "); k=0.3");
      for (int n = 0; n < 3; ++n) {
        const Posture posture = randomPosture(arm, random);
        EXPECT_EQ(distanceOf(solveFlexibleKinematics(with, posture), solveFlexibleKinematics(arm, posture)), 0)
            << target;
      }
    }
}

/// Returns the text with JOINT replaced by the symbol of the arm's first joint, and MOMENT by the symbol of the first
/// row's moment without the suffix for the axis.
std::string spelt(std::string text, const Arm& arm) {
  std::string joint, moment;
  for (const NamedSymbol& named : formulaSymbols(arm, {})) {
    if (joint.empty()) joint = named.name;
    if (moment.empty() && named.symbol.of == FormulaSymbol::Of::kMoment)
      moment = named.name.substr(0, named.name.size() - 2);
  }
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"JOINT", joint}, {"MOMENT", moment}})
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from)) text.replace(at, from.size(), to);
  return text;
}

void expectDerivativesOfDifferences(const Arm& arm, const Posture& posture) {
  auto variables = jointVariables(arm);
  variables.push_back(Variable::load());
  for (int k = 0; k < 3; ++k) variables.push_back(Variable::gravityTurn(k));
  for (const auto& parameter : parametersOf(arm))
    if (parameter.path.effect >= 0 || parameter.name.ends_with("weight.distributed"))
      variables.push_back(Variable::number(parameter.path));
  const auto exact = differentiateTip(arm, posture, variables, kTight);
  ASSERT_EQ(exact.kinematics.status, KinematicsStatus::kConverged);
  const double reach = reachOf(arm);
  for (std::size_t k = 0; k < variables.size(); ++k) {
    const bool of_effect = variables[k].parameter.effect >= 0;
    const double h = variables[k].type == Variable::Type::kLoad ? 0.1 : of_effect ? 1e-5 : 1e-4;
    const Difference d = centralDifference(arm, posture, variables[k], h);
    const auto column = static_cast<Eigen::Index>(k);
    const double size = d.position.norm() + reach * d.rotation.norm();
    const double off =
        (d.position - exact.position_B.col(column)).norm() + reach * (d.rotation - exact.rotation_B.col(column)).norm();
    ASSERT_LE(off, 1e-6 * size + 1e-13 * reach / h) << arm.name << ": " << arm.effects[0].formula->text << " " << k;
  }
}

TEST(Formula, DerivativesAreThoseOfDifferences) {
  const char* expressions[] = {
      "c*sin(3*JOINT)",
      "a*JOINT + b*JOINT^2 + d",
      "c*exp(-k*JOINT^2); k=2",
      "c*sqrt(load + 1)",
      "c*load/(1 + k*load); k=0.02",
      "c*MOMENT_z/100",
      "c*tanh(MOMENT_x/m); m=50",
      "c*sin(40*JOINT)*cos(load/30)",
      "c*(JOINT > 0 ? 1 : -1)*JOINT",
      "c*JOINT*JOINT_dir + d*(temperature - 290)/10",
  };
  std::mt19937_64 random(47);
  for (const Arm& bare : effectArms())
    for (const char* text : expressions)
      for (const std::string& target :
           {formulaTargets(bare).front(), std::string("tip.y"), std::string("base.x"), std::string("base.yaw")}) {
        Arm arm = withFormula(bare, target + " += " + spelt(text, bare));
        for (std::size_t v = 0; v < arm.effects[0].values.size(); ++v)
          if (!numbersOf(arm.effects[0])[v].is_shape) arm.effects[0].values[v] = 1e-3 * static_cast<double>(v + 1);
        Posture posture = randomPosture(arm, random);
        if (std::abs(posture.q[0]) < 0.05) posture.q[0] += 0.1;  // away from the kink of the conditional
        expectDerivativesOfDifferences(arm, posture);
      }
}

TEST(Formula, ExpressionsHaveSlopesToElevenDigits) {
  ExpressionProblem problem;
  const auto slopeOf = [&](const std::string& text, double x) {
    const auto expression = Expression::parse(text, problem);
    EXPECT_TRUE(expression) << text;
    return expression->slope({x}, 0);
  };
  for (double x : {-2.7, -0.4, 0., 1e-6, 0.3, 1.9}) {
    EXPECT_NEAR(slopeOf("sin(3*x)", x), 3 * std::cos(3 * x), 1e-11);
    EXPECT_NEAR(slopeOf("sin(50*x)", x), 50 * std::cos(50 * x), 1e-8);
    EXPECT_NEAR(slopeOf("x^3", x), 3 * x * x, 1e-10);
    EXPECT_NEAR(slopeOf("exp(x)", x), std::exp(x), 1e-10);
  }
  EXPECT_NEAR(slopeOf("abs(x)", 0.001), 1, 1e-9);
  EXPECT_NEAR(slopeOf("1/x", 0.05), -400, 1e-4);
  EXPECT_NEAR(slopeOf("log(x)", 300), 1 / 300., 1e-12);
  EXPECT_NEAR(slopeOf("7 + 0*x", 2), 0, 1e-12);
}

TEST(Formula, SizesAreThoseItIsProportionalTo) {
  const Arm arm = cobraArm();
  const auto sizesOf = [&](const std::string& expression) {
    std::string sizes;
    const MadeFormula made = makeFormula(arm, "theta3 += " + expression, {});
    EXPECT_EQ(made.status, FormulaStatus::kMade) << expression << ": " << made.found;
    if (made.status != FormulaStatus::kMade) return sizes;
    for (const auto& parameter : numbersOf(made.effect))
      if (!parameter.is_shape) sizes += parameter.name;
    return sizes;
  };
  EXPECT_EQ(sizesOf("c*sin(3*theta1)"), "c");
  EXPECT_EQ(sizesOf("a*theta1 + b"), "ab");
  EXPECT_EQ(sizesOf("c*sin(k*theta1); k=3"), "c");
  EXPECT_EQ(sizesOf("(1 + k*load)*c; k=0.1"), "c");
  EXPECT_EQ(sizesOf("(1 + k*load)*c + b; k=0.1"), "cb");
  EXPECT_EQ(sizesOf("c*log(load)"), "c");
  EXPECT_EQ(sizesOf("c*sqrt(temperature - 290)"), "c");
  EXPECT_EQ(sizesOf("c^2; c=0.1"), "");
  EXPECT_EQ(sizesOf("0.01*sin(theta1)"), "");
  EXPECT_EQ(sizesOf("a1*theta1 + a2*theta1^2 + a3*theta2 + a4*theta1*theta2 + a5"), "a1a2a3a4a5");
}

struct Wrong {
  std::string text;
  FormulaStatus status;
  std::string says;
};

TEST(Formula, WhatIsNoneIsRefusedWithItsPlace) {
  const Arm arm = cobraArm();
  using Status = FormulaStatus;
  const Wrong wrongs[] = {
      {"", Status::kBadTarget, "nothing"},
      {"theta3 = c*theta1", Status::kBadTarget, "no '+='"},
      {"theta9 += c*theta1", Status::kBadTarget, "theta9"},
      {"tip.w += c", Status::kBadTarget, "tip.w"},
      {"moment_tool_z += c", Status::kBadTarget, "moment_tool_z"},
      {"theta3 += ", Status::kBadExpression, "the formula ends at character"},
      {"theta3 += c*sin(3*theta1", Status::kBadExpression, "the formula ends at character 25"},
      {"theta3 += c*)", Status::kBadExpression, "')' stands at character 13"},
      {"theta3 += c*sine(theta1)", Status::kBadExpression, "the unknown function 'sine' is called at character 13"},
      {"theta3 += c sin(theta1)", Status::kBadExpression, "at character 13"},
      {"theta3 += c = 5", Status::kBadExpression, "'=' stands at character 13"},
      {"theta3 += c, d", Status::kBadExpression, "a second expression"},
      {"theta3 += c*\"x\"", Status::kBadExpression, "at character 13"},
      {"theta3 += c*\x01", Status::kBadExpression, "byte"},
      {"theta3 += c*\xc3\xa9", Status::kBadExpression, "byte"},
      {"theta3 += at*theta1", Status::kBadExpression, "'at'"},
      {"theta3 += c*theta1; d=3", Status::kBadStart, "'d'"},
      {"theta3 += c*theta1; c=x", Status::kBadStart, "c=x"},
      {"theta3 += c*theta1; c=1e999", Status::kBadStart, "c=1e999"},
      {"theta3 += c*theta1; c=1, c=2", Status::kBadStart, "c=2"},
      {"theta3 += c*sin(k*theta1)", Status::kNeedsStart, "'k'"},
      {"theta3 += 0.1 + c*theta1", Status::kNeedsStart, "'c'"},
      {"theta3 += c*" + std::string(10000, '1'), Status::kBadExpression, "characters"},
      {"theta3 += " + std::string(900, '('), Status::kBadExpression, "at character"},
      {"theta3 += a+b+d+f+g+h+i+j+k+l+m+n+o", Status::kBadExpression, "13 parameters"},
  };
  for (const Wrong& wrong : wrongs) {
    const MadeFormula made = makeFormula(arm, wrong.text, {});
    EXPECT_EQ(made.status, wrong.status) << wrong.text;
    EXPECT_NE(made.found.find(wrong.says), std::string::npos) << wrong.text << ": " << made.found;
    EXPECT_FALSE(made.effect.formula) << wrong.text;
  }
}

TEST(Formula, AnyBytesAreRefusedOrUnderstood) {
  const Arm arm = cobraArm();
  std::mt19937_64 random(48);
  const std::string pieces[] = {"theta1", "c", "k", "sin(", ")",  "(", "+", "-", "*", "/", "^",    "3",    ".5", "1e",
                                "?",      ":", ",", "==",   "&&", "!", " ", ";", "=", "_", "min(", "load", "\n", "0x"};
  int made = 0;
  for (int n = 0; n < 3000; ++n) {
    std::string text = "theta3 += ";
    for (std::size_t k = random() % 12; k > 0; --k) text += pieces[random() % std::size(pieces)];
    const MadeFormula formula = makeFormula(arm, text, {});
    ASSERT_NE(formula.status, FormulaStatus::kNotRun);
    if (formula.status != FormulaStatus::kMade) {
      EXPECT_FALSE(formula.found.empty()) << text;
      continue;
    }
    ++made;
    Arm with = arm;
    with.effects = {formula.effect};
    EXPECT_TRUE(findProblems(with).empty()) << text;
    const auto shape = solveFlexibleKinematics(with, randomPosture(arm, random));
    EXPECT_NE(shape.status, KinematicsStatus::kNotRun);
  }
  EXPECT_GT(made, 20);
}

TEST(Formula, WithoutAFiniteValueAtAPostureSaysWhere) {
  const Arm arm = withFormula(cobraArm(), "theta3 += c/theta1");
  Posture posture{Eigen::Vector4d(0, 0.5, -0.4, 0.2), 10};
  const auto shape = solveFlexibleKinematics(arm, posture);
  EXPECT_EQ(shape.status, KinematicsStatus::kUndefined);
  EXPECT_NE(shape.reason.find("theta1 = 0"), std::string::npos) << shape.reason;
  EXPECT_EQ(differentiateTip(arm, posture, jointVariables(arm)).kinematics.status, KinematicsStatus::kUndefined);
  EXPECT_EQ(findUndefinedFormula(arm, posture), shape.reason);
  posture.q[0] = 0.3;
  EXPECT_EQ(findUndefinedFormula(arm, posture), "");
  EXPECT_EQ(solveFlexibleKinematics(arm, posture).status, KinematicsStatus::kConverged);
  posture.q[0] = -0.3;
  EXPECT_NE(findUndefinedFormula(withFormula(cobraArm(), "theta3 += c*log(theta1)"), posture), "");
  posture.q[0] = 0;
  const auto slope = findUndefinedFormula(withFormula(cobraArm(), "theta3 += c*sqrt(theta1)"), posture);
  EXPECT_NE(slope.find("derivative with respect to theta1"), std::string::npos) << slope;
}

TEST(Formula, ManyThreadsSayTheSameAsOne) {
  const Arm arm = withFormula(withFormula(cobraArm(), "theta3 += c*sin(3*theta1)*exp(-theta2^2); c=0.01"),
                              "tip.x += 1e-6*moment_tool_z");
  std::mt19937_64 random(49);
  std::vector<Posture> postures;
  for (int n = 0; n < 60; ++n) postures.push_back(randomPosture(arm, random));
  const auto all = [&] {
    Eigen::MatrixXd columns(3, 0);
    for (const Posture& posture : postures) {
      const auto tip = differentiateTip(arm, posture, jointVariables(arm));
      columns.conservativeResize(Eigen::NoChange, columns.cols() + 5);
      columns.rightCols<5>() << tip.position_B, tip.kinematics.X_BD.p;
    }
    return columns;
  };
  const Eigen::MatrixXd alone = all();
  std::vector<Eigen::MatrixXd> found(8);
  std::vector<std::thread> threads;
  for (auto& columns : found) threads.emplace_back([&] { columns = all(); });
  for (auto& thread : threads) thread.join();
  for (const auto& columns : found) EXPECT_EQ(columns, alone);
}

TEST(Formula, TwoOfOneTargetHaveNamesOfTheirOwn) {
  const Arm bare = cobraArm();
  Arm arm = withFormula(withFormula(bare, "theta3 += c*sin(3*theta1)"), "theta3 += c*load");
  EXPECT_EQ(textOf(arm, arm.effects[0]), "formula@theta3");
  EXPECT_EQ(textOf(arm, arm.effects[1]), "formula@theta3#2");
  EXPECT_TRUE(findParameter(arm, "formula@theta3.c"));
  EXPECT_TRUE(findParameter(arm, "formula@theta3#2.c"));
  EXPECT_TRUE(findProblems(arm).empty());
  EXPECT_EQ(makeFormula(bare, "theta3 += c", {}, "theta3#4").effect.formula->at, "theta3#4");
  EXPECT_EQ(makeFormula(bare, "theta3 += c", {}, "theta2").status, FormulaStatus::kBadTarget);
  arm.effects[1] = arm.effects[0];
  ASSERT_EQ(findProblems(arm).size(), 1U);
  EXPECT_EQ(findProblems(arm)[0].path, "formula@theta3");
  arm.effects.pop_back();
  arm.effects[0].values[0] = std::numeric_limits<double>::quiet_NaN();
  ASSERT_EQ(findProblems(arm).size(), 1U);
  EXPECT_EQ(findProblems(arm)[0].path, "formula@theta3.c");
}

TEST(Formula, StaysOnTheRigidCopyAndOnArmsThatHaveItsRows) {
  const Arm arm = withFormula(cobraArm(), "theta3 += c*sin(3*theta4); c=0.1");
  EXPECT_EQ(rigidCopy(arm).effects.size(), 1U);
  EXPECT_EQ(castArm<double>(castArm<Dual>(arm)).effects[0].formula, arm.effects[0].formula);
  Arm other = mastArm();
  other.effects = arm.effects;
  ASSERT_EQ(findProblems(other).size(), 1U);
  EXPECT_EQ(findProblems(other)[0].path, "effects.1");
  EXPECT_EQ(makeEffect(arm, "formula", "theta3").status, EffectStatus::kUnknownPlace);
}

}  // namespace
}  // namespace tubeplan::deflection
