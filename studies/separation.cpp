// Study of the measurements that the diagnosis proposes if several explanations fit the data. At most twelve proposed
// measurements are simulated with the true arm, round by round. The study counts how often a single cause remains, and
// how often this cause is the true one. The same number of random candidate measurements serves as a comparison.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include "app/jobs/diagnosis.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "tests/calibration/measurement_checks/seeded_sets.hpp"

namespace {

using namespace tubeplan;
using calibration::Measurement, calibration::MeasurementCandidate, calibration::Verdict;
using Random = boost::random::mt19937_64;

constexpr std::array kHidden{"backlash@tool.z:0.03deg",       "stiffening@tool.z:softness=1.2,knee=150",
                             "joint-offset@theta4:0.01deg",   "tool-weight@tool:0.03",
                             "joint-scale@theta4:0.0002",     "link-twist@latch-link:0.012deg",
                             "backlash@base-link.z:0.012deg", "link-weight@forearm:0.8",
                             "contact-force@tip:0.8",         "joint-coupling@theta4<-theta3:0.00015"};

/// Returns simulated measurements of the true arm at the proposed postures, with measurement and encoder noise.
std::vector<Measurement> filledIn(const calibration::CampaignTruth& truth,
                                  const std::vector<calibration::ProposedMeasurement>& proposed,
                                  const std::string& name, Random& random) {
  boost::random::normal_distribution<double> normal;
  std::vector<Measurement> measurements;
  for (std::size_t k = 0; k < proposed.size(); ++k) {
    Measurement measurement = calibration::conditionsOf(proposed[k]);
    measurement.id = fmt::format("{}.{}", name, k + 1);
    Eigen::Vector3d tip = calibration::predictMeasurement(truth.arm, truth.bases.front().X_WB, measurement).value;
    for (double& coordinate : tip) coordinate += measurement.sigma * normal(random);
    measurement.p_W = tip;
    for (Eigen::Index j = 0; j < measurement.q.size(); ++j)
      measurement.q[j] += truth.arm.joint(j).encoder_sigma * normal(random);
    measurements.push_back(std::move(measurement));
  }
  return measurements;
}

bool isTrue(const calibration::Diagnosis& diagnosis, const std::string& hidden) {
  if (diagnosis.verdict != Verdict::kExplained || diagnosis.alternatives.front().effects.size() != 1) return false;
  const auto& found = diagnosis.alternatives.front().effects.front();
  const auto matches = [&](const std::string& effect, const std::string& at) {
    return hidden.starts_with(effect + "@" + at + ":");
  };
  return matches(found.effect, found.at) ||
         std::any_of(found.indistinguishable.begin(), found.indistinguishable.end(),
                     [&](const auto& other) { return matches(other.first, other.second); });
}

void describe(const calibration::Diagnosis& diagnosis) {
  fmt::print(" {}:", calibration::nameOf(diagnosis.verdict));
  for (const auto& one : diagnosis.alternatives) fmt::print(" {} ({:.2f})", calibration::nameOf(one), one.probability);
}

struct Count {
  int one = 0, right = 0;
  void add(const calibration::Diagnosis& diagnosis, const std::string& hidden) {
    one += diagnosis.verdict == Verdict::kExplained;
    right += isTrue(diagnosis, hidden);
  }
};

/// Session that adds measurements round by round until the diagnosis is unambiguous or all rounds are used.
class Session {
 public:
  Session(const calibration::CampaignTruth& truth, app::CellMeasurements input, std::uint64_t seed)
      : truth_(truth), input_(std::move(input)), random_(seed) {}

  template <class Choose>
  calibration::Diagnosis run(app::DiagnosisOutcome outcome, int rounds, int count, Choose choose) {
    app::DiagnosisRequest request;
    request.next = count;
    for (int round = 0; round < rounds && outcome.diagnosis.verdict == Verdict::kAmbiguous; ++round) {
      for (int n = 0; n < count; ++n)
        if (const int candidate = choose(outcome, n, random_); candidate >= 0)
          take(outcome.candidates[static_cast<std::size_t>(candidate)].measurements);
      outcome = app::diagnoseModel(input_, request);
    }
    return outcome.diagnosis;
  }

 private:
  void take(const std::vector<calibration::ProposedMeasurement>& proposed) {
    const auto measurements = filledIn(truth_, proposed, fmt::format("N{}", ++taken_), random_);
    input_.measurements.insert(input_.measurements.end(), measurements.begin(), measurements.end());
  }

  const calibration::CampaignTruth& truth_;
  app::CellMeasurements input_;
  Random random_;
  int taken_ = 0;
};

int asProposed(const app::DiagnosisOutcome& outcome, int n, Random&) {
  const auto& next = outcome.next.measurements;
  return n < static_cast<int>(next.size()) ? next[static_cast<std::size_t>(n)].candidate : -1;
}

int atRandom(const app::DiagnosisOutcome& outcome, int, Random& random) {
  const int last = static_cast<int>(outcome.candidates.size()) - 1;
  return last < 0 ? -1 : boost::random::uniform_int_distribution<int>(0, last)(random);
}

int run(int sets, int count, int rounds, std::uint64_t first_seed) {
  int ambiguous = 0, separable = 0;
  Count proposed, random_ones;
  for (int k = 0; k < sets; ++k) {
    const std::string hidden = kHidden[static_cast<std::size_t>(k) % kHidden.size()];
    const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(k);
    calibration::CampaignTruth truth;
    const auto set = calibration::simulatedSet("bench.yaml", "bench", 48, {hidden}, seed,
                                               [&](app::SimulationTask& task) { truth = task.truth; });
    if (!set) continue;
    const app::CellMeasurements input{set->cell, "simulated", set->table.measurements};
    app::DiagnosisRequest request;
    request.next = count;
    const auto first_answer = app::diagnoseModel(input, request);
    if (first_answer.diagnosis.verdict != Verdict::kAmbiguous) continue;
    ++ambiguous;
    if (first_answer.next.times != 1) continue;  // the proposal itself states that these measurements do not suffice
    ++separable;
    const int at_once = count / rounds;  // the first measurements of a long proposal are the shorter proposal
    const auto after = Session(truth, input, seed).run(first_answer, rounds, at_once, asProposed);
    proposed.add(after, hidden);
    random_ones.add(Session(truth, input, seed).run(first_answer, rounds, at_once, atRandom), hidden);
    fmt::print("{:3d} {:40s} chance {:.2f}; before", k, hidden, first_answer.next.probability);
    describe(first_answer.diagnosis);
    fmt::print("; after");
    describe(after);
    fmt::print("; one cause left: proposed {} of {}, random {}\n", proposed.one, separable, random_ones.one);
  }
  fmt::print("{} sets, {} ambiguous, {} of them said to be separable by {} readings\n", sets, ambiguous, separable,
             count);
  fmt::print("proposed: {} end in one cause, {} in the true one; random: {} and {}\n", proposed.one, proposed.right,
             random_ones.one, random_ones.right);
  return 10 * proposed.one >= 9 * separable ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App cli("what the proposed readings separate");
  int sets = 60, count = 12, rounds = 2;
  std::uint64_t seed = 1;
  cli.add_option("--sets", sets);
  cli.add_option("--readings", count);
  cli.add_option("--rounds", rounds, "that the readings are made in, diagnosed anew after each");
  cli.add_option("--seed", seed);
  CLI11_PARSE(cli, argc, argv);
  return run(sets, count, rounds, seed);
}
