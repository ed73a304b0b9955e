// Laws that every effect of the catalogue must obey, at every place where an arm can have the effect.
#include <gtest/gtest.h>

#include <set>

#include "tests/deflection/central_difference.hpp"
#include "tests/deflection/effects/effect_arms.hpp"

namespace tubeplan::deflection {
namespace {

double differenceOf(const FlexibleKinematics& a, const FlexibleKinematics& b) {
  EXPECT_EQ(a.status, KinematicsStatus::kConverged);
  EXPECT_EQ(b.status, KinematicsStatus::kConverged);
  double off =
      (a.X_BD.p - b.X_BD.p).norm() + (a.X_BD.R * a.R_LT - b.X_BD.R * b.R_LT).norm() + (a.X_BT.p - b.X_BT.p).norm();
  for (std::size_t i = 0; i < a.rows.size(); ++i)
    off += (a.rows[i].X_BL.p - b.rows[i].X_BL.p).norm() + 1e-3 * (a.rows[i].moment_L - b.rows[i].moment_L).norm() +
           1e-3 * (a.rows[i].force_B - b.rows[i].force_B).norm();
  return off;
}

TEST(EffectsTable, HoldsTheNamesOfTheCatalogue) {
  const std::set<std::string> promised{"joint-offset",   "joint-scale",    "encoder-eccentricity", "transmission-error",
                                       "hysteresis",     "joint-coupling", "link-length",          "link-twist",
                                       "tool-offset",    "link-weight",    "tool-weight",          "payload-offset",
                                       "gravity-tilt",   "hose-pull",      "contact-force",        "joint-compliance",
                                       "link-bending",   "link-torsion",   "stiffening",           "backlash",
                                       "thermal-growth", "base-slip",      "base-drift",           "scale-error",
                                       "formula",        "gear-wave",      "tool-remount",         "gravity-sag",
                                       "cable-stretch",  "slide-bending",  "screw-coupling",       "link-lean",
                                       "tool-turn",      "lost-motion"};
  std::set<std::string> names;
  for (const EffectKind& kind : effectKinds()) names.insert(kind.name);
  EXPECT_EQ(names, promised);
  EXPECT_EQ(effectKinds().size(), promised.size());
}

TEST(EffectsTable, EveryRowIsWhole) {
  std::set<std::string> words;
  for (const EffectKind& kind : effectKinds()) {
    for (const char* text : {kind.words, kind.law, kind.validity, kind.source})
      EXPECT_GT(std::string(text).size(), 3U) << kind.name;
    EXPECT_TRUE(words.insert(kind.words).second) << kind.name;
    EXPECT_EQ(kind.varies_with.empty(), std::string(kind.name) == "formula") << kind.name;
    for (const EffectVariable variable : kind.varies_with) EXPECT_NE(std::string(nameOf(variable)), "") << kind.name;
    EXPECT_EQ(kind.at == PlaceRule::kWord, *kind.word != 0) << kind.name;
    if (std::string(kind.name) == "formula") {
      EXPECT_TRUE(kind.parameters.empty());
      continue;
    }
    ASSERT_FALSE(kind.parameters.empty()) << kind.name;
    EXPECT_FALSE(kind.parameters.front().is_shape) << kind.name;
    std::set<std::string> names;
    for (const EffectParameter& p : kind.parameters) {
      EXPECT_TRUE(names.insert(p.name).second) << kind.name;
      EXPECT_LE(p.lower, p.neutral) << kind.name;
      EXPECT_LE(p.neutral, p.upper) << kind.name;
      EXPECT_LE(p.lower < 0 ? p.lower : -p.plausible, -p.plausible) << kind.name;
      EXPECT_GT(p.plausible, 0) << kind.name;
      EXPECT_LE(p.plausible, p.upper) << kind.name;
    }
  }
}

TEST(EffectsTable, ThePlacesOfTheCobra) {
  const Arm arm = cobraArm();
  const auto placesOf = [&](const std::string& name) { return placeTexts(arm, effectKinds()[*findEffectKind(name)]); };
  using Texts = std::vector<std::string>;
  EXPECT_EQ(placesOf("joint-offset"), (Texts{"theta1", "theta2", "theta3", "theta4"}));
  EXPECT_EQ(placesOf("joint-coupling").size(), 12U);
  EXPECT_EQ(placesOf("joint-coupling").front(), "theta1<-theta2");
  EXPECT_EQ(placesOf("link-length"),
            (Texts{"mezzanine-beam", "mezzanine-platform", "base-link", "latch-link", "forearm"}));
  EXPECT_EQ(placesOf("link-weight").back(), "tool");
  EXPECT_EQ(placesOf("joint-compliance").size(), 14U);
  EXPECT_EQ(placesOf("stiffening"), (Texts{"mezzanine-beam.z", "mezzanine-platform.x", "forearm.z", "tool.z"}));
  EXPECT_EQ(placesOf("lost-motion"), (Texts{"base-link.z", "latch-link.z"}));
  EXPECT_EQ(placesOf("backlash"), (Texts{"mezzanine-beam.z", "mezzanine-platform.x", "base-link.x", "base-link.y",
                                         "base-link.z", "latch-link.x", "latch-link.y", "latch-link.z", "forearm.x",
                                         "forearm.y", "forearm.z", "tool.x", "tool.y", "tool.z"}));
  EXPECT_EQ(placesOf("link-bending"),
            (Texts{"mezzanine-beam.y", "mezzanine-platform.x", "mezzanine-platform.y", "base-link.y", "base-link.z",
                   "latch-link.y", "forearm.y", "forearm.z", "tool.y", "tool.z"}));
  EXPECT_EQ(placesOf("link-torsion").size(), 6U);
  EXPECT_EQ(placesOf("payload-offset"), Texts{"payload"});
  EXPECT_EQ(placesOf("thermal-growth"), Texts{"arm"});
  EXPECT_EQ(placesOf("scale-error"), Texts{"measurement"});
}

TEST(EffectsTable, ASlideHasNoPlaceForWhatTurns) {
  const Arm arm = mastArm();
  const auto has = [&](const std::string& name, const std::string& at) {
    return findPlace(arm, effectKinds()[*findEffectKind(name)], at).has_value();
  };
  for (const char* name : {"joint-offset", "joint-scale", "hysteresis"})
    EXPECT_TRUE(has(name, "joint-of-mast")) << name;
  for (const char* name : {"encoder-eccentricity", "transmission-error"}) {
    EXPECT_TRUE(has(name, "joint-of-wrist")) << name;
    EXPECT_FALSE(has(name, "joint-of-mast")) << name;
  }
  EXPECT_TRUE(has("joint-coupling", "joint-of-mast<-joint-of-slider"));
  EXPECT_FALSE(has("joint-coupling", "joint-of-mast<-joint-of-wrist"));
  EXPECT_TRUE(has("screw-coupling", "joint-of-mast<-joint-of-wrist"));
  EXPECT_FALSE(has("screw-coupling", "joint-of-wrist<-joint-of-mast"));
  EXPECT_FALSE(has("screw-coupling", "joint-of-mast<-joint-of-slider"));
  EXPECT_FALSE(has("backlash", "mast.z"));
  EXPECT_TRUE(has("backlash", "wrist.z"));
  const Arm offset = withEffect(arm, "joint-offset", "joint-of-mast");
  EXPECT_EQ(findParameter(offset, "joint-offset@joint-of-mast.offset")->quantity, Quantity::kLength);
}

TEST(EffectsTable, WhatAnArmLacksForAPlaceIsSaid) {
  const auto made = makeEffect(cobraArm(), "gear-wave", "theta2");
  EXPECT_EQ(made.status, EffectStatus::kUnknownPlace);
  EXPECT_NE(made.reason.find("gear_ratio"), std::string::npos) << made.reason;
}

TEST(EffectsTable, NamesThatAreNotKnownAreRefusedWithTheOnesThatAre) {
  const Arm arm = cobraArm();
  const auto effect = makeEffect(arm, "backlsh", "tool.z");
  EXPECT_EQ(effect.status, EffectStatus::kUnknownEffect);
  EXPECT_EQ(effect.known.size(), effectKinds().size());
  const auto place = makeEffect(arm, "backlash", "mezzanine-beam.x");
  EXPECT_EQ(place.status, EffectStatus::kUnknownPlace);
  EXPECT_FALSE(place.reason.empty());
  EXPECT_EQ(place.known.back(), "tool.z");
}

TEST(Effects, AtNeutralValuesNoneDoesAnything) {
  std::mt19937_64 random(21);
  for (const Arm& arm : effectArms()) {
    Arm full = arm;
    full.effects = allEffects(arm);
    for (int n = 0; n < 10; ++n) {
      const Posture posture = randomPosture(arm, random);
      const auto plain = solveFlexibleKinematics(arm, posture, kTight);
      for (const Effect& effect : full.effects) {
        Arm one = arm;
        one.effects = {effect};
        EXPECT_LE(differenceOf(solveFlexibleKinematics(one, posture, kTight), plain), 1e-12) << textOf(arm, effect);
      }
      EXPECT_LE(differenceOf(solveFlexibleKinematics(full, posture, kTight), plain), 1e-12);
    }
    EXPECT_EQ(measurementScale(full), 1);
  }
}

TEST(Effects, AwayFromNeutralEachDoesSomething) {
  std::mt19937_64 random(22);
  for (const Arm& arm : effectArms()) {
    for (const Effect& neutral : allEffects(arm)) {
      // The loads on a straight tool act along its axis and do not twist it, so its torsional compliance has no effect.
      const std::string name = effectKinds()[neutral.kind].name;
      if (name == "link-torsion" && neutral.place.row + 1 == static_cast<int>(arm.rows.size())) continue;
      Arm one = arm;
      one.effects = {sized(arm, neutral, 0.3)};
      double most = std::abs(measurementScale(one) - 1);
      for (int n = 0; n < 10; ++n) {
        const Posture posture = randomPosture(arm, random);
        const auto with = solveFlexibleKinematics(one, posture, kTight),
                   without = solveFlexibleKinematics(arm, posture, kTight);
        most = std::max({most, (with.X_BD.p - without.X_BD.p).norm(), (with.R_LT - without.R_LT).norm()});
      }
      EXPECT_GT(most, 1e-6) << arm.name << " " << textOf(arm, neutral);
    }
  }
}

TEST(Effects, TheirOrderDoesNotMatter) {
  std::mt19937_64 random(23);
  for (const Arm& arm : effectArms()) {
    const auto effects = allEffects(arm);
    for (int n = 0; n < 400; ++n) {
      const Effect& a = effects[random() % effects.size()];
      const Effect& b = effects[random() % effects.size()];
      Arm one = arm, other = arm;
      one.effects = {sized(arm, a, 0.2), sized(arm, b, 0.2)};
      other.effects = {one.effects[1], one.effects[0]};
      const Posture posture = randomPosture(arm, random);
      EXPECT_LE(
          differenceOf(solveFlexibleKinematics(one, posture, kTight), solveFlexibleKinematics(other, posture, kTight)),
          1e-11)
          << textOf(arm, a) << " and " << textOf(arm, b);
    }
  }
}

/// Returns the effect expressed in a base frame whose axes are rotated by the inverse of R; std::nullopt if the effect
/// refers to the base's z axis.
std::optional<Effect> turned(Effect effect, const Eigen::Matrix3d& R) {
  const std::string name = effectKinds()[effect.kind].name;
  if (name == "base-slip" || name == "gravity-tilt") return std::nullopt;
  if (name == "hose-pull" || name == "base-drift")
    Eigen::Map<Eigen::Vector3d>(effect.values.data()) = R * Eigen::Map<Eigen::Vector3d>(effect.values.data());
  return effect;
}

TEST(Effects, TurningTheArmAndGravityTogetherTurnsTheShape) {
  std::mt19937_64 random(24);
  const Arm arm = cobraArm();
  const double angle = 0.7;
  const Eigen::Matrix3d R = rotationX<double>(angle);
  Arm leaning = arm;
  std::get<DenavitHartenberg<double>>(leaning.rows[0].placement).alpha += angle;
  for (const Effect& neutral : allEffects(arm)) {
    Arm one = arm, other = leaning;
    one.effects = {sized(arm, neutral, 0.2)};
    const auto effect = turned(one.effects[0], R);
    if (!effect) continue;
    other.effects = {*effect};
    Posture posture = randomPosture(arm, random);
    const auto a = solveFlexibleKinematics(one, posture, kTight);
    posture.gravity_B = R * posture.gravity_B;
    const auto b = solveFlexibleKinematics(other, posture, kTight);
    EXPECT_LE((R * a.X_BD.p - b.X_BD.p).norm() + (R * a.X_BD.R - b.X_BD.R).norm(), 1e-11) << textOf(arm, neutral);
  }
}

TEST(Effects, TheirNumbersAreParametersOfTheArm) {
  for (const Arm& bare : effectArms()) {
    Arm arm = bare;
    arm.effects = allEffects(bare);
    std::size_t count = parametersOf(bare).size();
    for (std::size_t e = 0; e < arm.effects.size(); ++e) {
      const auto& numbers = effectKinds()[arm.effects[e].kind].parameters;
      count += numbers.size();
      for (std::size_t k = 0; k < numbers.size(); ++k) {
        const std::string name = textOf(arm, arm.effects[e]) + "." + numbers[k].name;
        const auto parameter = findParameter(arm, name);
        ASSERT_TRUE(parameter) << name;
        EXPECT_EQ(parameter->value, numbers[k].neutral);
        locate(arm, parameter->path) = 0.125;
        EXPECT_EQ(arm.effects[e].values[k], 0.125);
        ArmOf<Dual> dual = castArm<Dual>(arm);
        EXPECT_EQ(locate(dual, parameter->path).value(), 0.125);
        EXPECT_EQ(castArm<double>(dual).effects[e].values[k], 0.125);
        locate(arm, parameter->path) = numbers[k].neutral;
      }
    }
    EXPECT_EQ(parametersOf(arm).size(), count);
  }
}

TEST(Effects, TheRigidCopyKeepsAllButWhatGives) {
  Arm arm = cobraArm();
  arm.effects = allEffects(arm);
  const Arm rigid = rigidCopy(arm);
  EXPECT_LT(rigid.effects.size(), arm.effects.size());
  for (const Effect& effect : rigid.effects)
    EXPECT_NE(effectKinds()[effect.kind].stage, EffectStage::kFlexibility) << textOf(arm, effect);
  std::mt19937_64 random(25);
  const auto shape = solveFlexibleKinematics(rigid, randomPosture(arm, random));
  EXPECT_TRUE(shape.components.empty());
}

TEST(Effects, ProblemsAreFoundByName) {
  for (const Arm& bare : effectArms()) {
    Arm all = bare;
    all.effects = allEffects(bare);
    EXPECT_TRUE(findProblems(all).empty()) << findProblems(all).front().path;
    for (const Effect& neutral : all.effects) {
      for (std::size_t k = 0; k < neutral.values.size(); ++k) {
        const EffectNumber number = numberOf(bare, neutral, static_cast<int>(k));
        for (double value : {number.lower - 1, number.upper + 1, std::numeric_limits<double>::quiet_NaN()}) {
          Arm arm = bare;
          arm.effects = {neutral};
          arm.effects[0].values[k] = value;
          const auto problems = findProblems(arm);
          ASSERT_EQ(problems.size(), 1U) << textOf(arm, neutral) << " = " << value;
          EXPECT_EQ(problems[0].path, textOf(arm, neutral) + "." + effectKinds()[neutral.kind].parameters[k].name);
        }
      }
    }
  }
}

TEST(Effects, EffectsWhereTheyCannotBeAreProblems) {
  const Arm arm = withEffect(cobraArm(), "backlash", "tool.z");
  const auto problemOf = [&](auto applyFault) {
    Arm faulty = arm;
    applyFault(faulty.effects);
    const auto problems = findProblems(faulty);
    EXPECT_EQ(problems.size(), 1U);
    return problems.empty() ? std::string() : problems[0].path;
  };
  EXPECT_EQ(problemOf([](auto& effects) { effects.push_back(effects[0]); }), "backlash@tool.z");
  EXPECT_EQ(problemOf([](auto& effects) { effects[0].values.clear(); }), "backlash@tool.z");
  EXPECT_EQ(problemOf([](auto& effects) { effects[0].place = {.row = 0, .axis = 0}; }), "effects.1");
  EXPECT_EQ(problemOf([](auto& effects) { effects[0].place.row = 17; }), "effects.1");
  EXPECT_EQ(problemOf([](auto& effects) { effects[0].kind = 99; }), "effects.1");
}

}  // namespace
}  // namespace tubeplan::deflection
