// The verdict must follow from the probabilities of the causes; in each case these can be added up by hand.
#include "calibration/diagnosis/judgement/decision.hpp"

#include <gtest/gtest.h>

namespace tubeplan::calibration {
namespace {

using Causes = std::vector<int>;

const CompetingModel kSomeModel{};

/// Returns the class of a fitted model; its explanation names the causes.
ModelClass classOf(const Causes& causes, double probability, double remainder = 0, double scatter = 0) {
  ModelClass one;
  one.causes = causes;
  one.probability = probability;
  one.remainder_probability = remainder;
  one.scatter_probability = scatter;
  one.model = &kSomeModel;
  for (const int cause : causes) one.explanation.effects.emplace_back().effect = std::to_string(cause);
  return one;
}

ModelClass notFitted(const Causes& causes, double probability) {
  ModelClass one = classOf(causes, probability);
  one.model = nullptr;
  return one;
}

Posterior posteriorWith(double nothing, std::vector<ModelClass> classes) {
  Posterior posterior;
  posterior.nothing = nothing;
  posterior.classes = std::move(classes);
  return posterior;
}

/// Returns the diagnosis for a posterior with default options.
Diagnosis decided(const Posterior& posterior) {
  Diagnosis result;
  decide(DiagnosisOptions{}, posterior, result);
  return result;
}

std::string effectsOf(const Explanation& explanation) {
  std::string name;
  for (const auto& found : explanation.effects) name += (name.empty() ? "" : "+") + found.effect;
  return name;
}

std::vector<std::string> alternativesOf(const Diagnosis& diagnosis) {
  std::vector<std::string> names;
  for (const auto& one : diagnosis.alternatives) names.push_back(effectsOf(one));
  return names;
}

using Names = std::vector<std::string>;

TEST(Decide, PassesOnWhatIsProbable) {
  Posterior posterior = posteriorWith(0.6, {});
  posterior.unknown = 0.3;
  posterior.scatter = 0.1;
  const Diagnosis found = decided(posterior);
  EXPECT_EQ(found.nothing_probability, 0.6);
  EXPECT_EQ(found.unknown_probability, 0.3);
  EXPECT_EQ(found.scatter_probability, 0.1);
}

TEST(Decide, NamesNothingUnlessItIsAllButSureThatSomethingIsMissing) {
  EXPECT_EQ(decided(posteriorWith(0.5, {classOf({1}, 0.5)})).verdict, Verdict::kAdequate);
  EXPECT_EQ(decided(posteriorWith(0.49, {classOf({1}, 0.51)})).verdict, Verdict::kInconclusive);
  EXPECT_EQ(decided(posteriorWith(0.11, {classOf({1}, 0.89)})).verdict, Verdict::kInconclusive);
  EXPECT_TRUE(decided(posteriorWith(0.11, {classOf({1}, 0.89)})).alternatives.empty());
  EXPECT_EQ(decided(posteriorWith(0.09, {classOf({1}, 0.91)})).verdict, Verdict::kExplained);
}

TEST(Decide, NamesOneCauseThatIsSureOfAllThatIsMissing) {
  // The cause has 0.86 of the total probability of 0.95 that something is missing, a fraction of more than 0.9.
  const Diagnosis one = decided(posteriorWith(0.05, {classOf({1}, 0.86), classOf({2}, 0.09)}));
  EXPECT_EQ(one.verdict, Verdict::kExplained);
  EXPECT_EQ(alternativesOf(one), Names{"1"});
  const Diagnosis two = decided(posteriorWith(0.05, {classOf({1}, 0.85), classOf({2}, 0.1)}));
  EXPECT_EQ(two.verdict, Verdict::kAmbiguous);
  EXPECT_EQ(alternativesOf(two), (Names{"1", "2"}));
  const Diagnosis scattering = decided(posteriorWith(0.05, {classOf({1}, 0.95, 0, 0.6)}));
  EXPECT_EQ(scattering.verdict, Verdict::kPartlyExplained);
  EXPECT_EQ(alternativesOf(scattering), Names{"1"});
  EXPECT_EQ(decided(posteriorWith(0.05, {classOf({1}, 0.95, 0, 0.4)})).verdict, Verdict::kExplained);
}

TEST(Decide, CallsOneCauseOfSeveralDoubtfulWhereMuchIsUnnamed) {
  const Diagnosis some = decided(posteriorWith(0, {classOf({1}, 0.8)}));  // the remaining 0.2 belongs to no named cause
  EXPECT_EQ(some.verdict, Verdict::kAmbiguous);
  EXPECT_EQ(alternativesOf(some), Names{"1"});
  EXPECT_EQ(decided(posteriorWith(0, {classOf({1}, 0.69)})).verdict, Verdict::kUnexplained);
  EXPECT_EQ(decided(posteriorWith(0, {classOf({1}, 0.71)})).verdict, Verdict::kAmbiguous);
  EXPECT_EQ(decided(posteriorWith(0, {})).verdict, Verdict::kUnexplained);
}

TEST(Decide, ExplainsPartOfWhatLeavesARemainder) {
  Posterior posterior = posteriorWith(0, {classOf({1}, 0.95, 0.6)});
  EXPECT_EQ(decided(posterior).verdict, Verdict::kUnexplained);
  EXPECT_TRUE(decided(posterior).alternatives.empty());
  posterior.certain = classOf({1}, 0.95);
  EXPECT_EQ(decided(posterior).verdict, Verdict::kPartlyExplained);
  EXPECT_EQ(alternativesOf(decided(posterior)), Names{"1"});
  EXPECT_EQ(decided(posteriorWith(0, {classOf({1}, 0.95, 0.4)})).verdict, Verdict::kExplained);
}

TEST(Decide, CausesBeyondThoseOfAMoreProbableClassCountToIt) {
  const Diagnosis added = decided(posteriorWith(0.05, {classOf({1}, 0.5), classOf({1, 2}, 0.4)}));
  EXPECT_EQ(added.verdict, Verdict::kExplained);
  EXPECT_EQ(alternativesOf(added), Names{"1"});
  const Diagnosis both = decided(posteriorWith(0.05, {classOf({1, 2}, 0.5), classOf({1}, 0.4)}));
  EXPECT_EQ(both.verdict, Verdict::kAmbiguous);
  EXPECT_EQ(alternativesOf(both), (Names{"1+2", "1"}));
  // If the class {1} is chosen, the part that an added cause 2 or 3 would explain must be reported as unexplained.
  EXPECT_EQ(decided(posteriorWith(0, {classOf({1}, 0.4, 0), classOf({1, 2}, 0.39), classOf({1, 3}, 0.2)})).verdict,
            Verdict::kUnexplained);
  Posterior others = posteriorWith(0, {classOf({1}, 0.5), classOf({2}, 0.25)});
  EXPECT_EQ(decided(others).verdict, Verdict::kAmbiguous);
  others.others = {notFitted({1, 2}, 0.2), notFitted({3}, 0.05)};
  const Diagnosis with = decided(others);  // the named classes have 0.95 together; cause 3 alone has no fitted model
  EXPECT_EQ(with.verdict, Verdict::kAmbiguous);
  EXPECT_EQ(alternativesOf(with), (Names{"1", "2"}));
  // A class must become the first one if classes that extend it raise its probability above the others.
  Posterior overtaken = posteriorWith(0, {classOf({1}, 0.45), classOf({2}, 0.3), classOf({2, 3}, 0.25)});
  EXPECT_EQ(alternativesOf(decided(overtaken)), (Names{"2", "1"}));
}

TEST(Decide, ListsAlternativesUntilTheyAreCredibleTogether) {
  EXPECT_EQ(alternativesOf(decided(posteriorWith(0.05, {classOf({1}, 0.6), classOf({2}, 0.34), classOf({3}, 0.01)}))),
            (Names{"1", "2"}));
  EXPECT_EQ(alternativesOf(decided(posteriorWith(0.05, {classOf({1}, 0.6), classOf({2}, 0.25), classOf({3}, 0.1)}))),
            (Names{"1", "2", "3"}));
  // The first class has 0.7 of 0.752, less than the credible fraction. Classes with less than a fiftieth of 0.7 must
  // still be omitted, except the second, because a single class would not be ambiguous.
  const auto first_and_four = [](double each) {
    std::vector<ModelClass> classes{classOf({1}, 0.7)};
    for (int k = 2; k < 6; ++k) classes.push_back(classOf({k}, each));
    return alternativesOf(decided(posteriorWith(0, classes)));
  };
  EXPECT_EQ(first_and_four(0.013), (Names{"1", "2"}));
  EXPECT_EQ(first_and_four(0.015), (Names{"1", "2", "3"}));
  std::vector<ModelClass> many;
  for (int k = 0; k < 12; ++k) many.push_back(classOf({k}, 1. / 12));
  EXPECT_EQ(decided(posteriorWith(0, many)).alternatives.size(), 8U);
}

TEST(Decide, SaysWhatAlternativesAgreeOnWhereItIsLessThanTheFirstSays) {
  Posterior posterior = posteriorWith(0, {classOf({1, 2}, 0.5), classOf({1, 3}, 0.5)});
  EXPECT_FALSE(decided(posterior).agreed);
  posterior.certain = classOf({1}, 1);
  ASSERT_TRUE(decided(posterior).agreed);
  EXPECT_EQ(effectsOf(*decided(posterior).agreed), "1");
  posterior.certain = classOf({1, 2}, 1);
  EXPECT_FALSE(decided(posterior).agreed);
  posterior = posteriorWith(0, {classOf({1, 2}, 1)});
  posterior.certain = classOf({1}, 1);
  EXPECT_FALSE(decided(posterior).agreed) << "there is one answer";
}

}  // namespace
}  // namespace tubeplan::calibration
