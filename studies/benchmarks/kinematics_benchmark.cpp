// Benchmark of flexible kinematics relative to rigid kinematics: the converged deflected shape of the Cobra arm and its
// Jacobians with respect to the joints and to all arm parameters, for single postures and batches. The reference is
// Orocos KDL's rigid kinematics of the same chain in the same run. Inverse kinematics is measured for a tube (all
// branches) and for a via point.
#include <benchmark/benchmark.h>

#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <map>
#include <random>
#include <string>

#include "deflection/inverse/inverse_solver.hpp"
#include "deflection/kinematics.hpp"
#include "deflection/revolute_chain/kernels.hpp"
#include "tests/deflection/cobra.hpp"

namespace tubeplan::benchmarks {
namespace {

using namespace deflection;

KDL::Chain rigidChain(const Arm& arm) {
  KDL::Chain chain;
  for (const auto& row : arm.rows) {
    const auto& dh = std::get<DenavitHartenberg<double>>(row.placement);
    const bool moves = row.joint.type != JointType::kPassive;
    // In Craig's convention, a and alpha precede the joint. The joint therefore turns about the z axis at the end of
    // the segment.
    const auto before = KDL::Frame::DH_Craig1989(dh.a, dh.alpha, dh.d, dh.theta + row.joint.offset);
    if (!moves) {
      chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), before));
      continue;
    }
    const KDL::Joint turn(row.joint.name, before.p, before.M * KDL::Vector(0, 0, 1), KDL::Joint::RotAxis);
    chain.addSegment(KDL::Segment(turn, before));
  }
  const Eigen::Vector3d& tip = arm.p_LT;
  chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), KDL::Frame(KDL::Vector(tip.x(), tip.y(), tip.z()))));
  return chain;
}

/// Random postures used by all benchmarks.
struct Postures {
  Arm arm = cobraArm();
  std::vector<Posture> list;
  std::size_t at = 0;

  Postures() {
    std::mt19937_64 random(3);
    for (int k = 0; k < 64; ++k) list.push_back({randomJoints(arm, random), 20 * kPound * (k % 3)});
  }
  const Posture& next() { return list[at++ % list.size()]; }
};

void rigidPose(benchmark::State& state) {
  Postures postures;
  const KDL::Chain chain = rigidChain(postures.arm);
  KDL::ChainFkSolverPos_recursive solver(chain);
  KDL::JntArray q(4);
  KDL::Frame tip;
  for (auto _ : state) {
    q.data = postures.next().q;
    benchmark::DoNotOptimize(solver.JntToCart(q, tip));
    benchmark::DoNotOptimize(tip);
  }
  const auto shape = solveFlexibleKinematics(postures.arm, postures.list[0]);
  q.data = postures.list[0].q;
  solver.JntToCart(q, tip);
  state.counters["off_m"] = (Eigen::Vector3d(tip.p.x(), tip.p.y(), tip.p.z()) - shape.X_BT.p).norm();
}

void rigidJacobian(benchmark::State& state) {
  Postures postures;
  const KDL::Chain chain = rigidChain(postures.arm);
  KDL::ChainFkSolverPos_recursive position(chain);
  KDL::ChainJntToJacSolver derivatives(chain);
  KDL::JntArray q(4);
  KDL::Frame tip;
  KDL::Jacobian jacobian(4);
  for (auto _ : state) {
    q.data = postures.next().q;
    benchmark::DoNotOptimize(position.JntToCart(q, tip));
    benchmark::DoNotOptimize(derivatives.JntToJac(q, jacobian));
    benchmark::DoNotOptimize(jacobian);
  }
}

void flexiblePose(benchmark::State& state) {
  Postures postures;
  PreparedArm arm(postures.arm);
  for (auto _ : state) {
    benchmark::DoNotOptimize(arm.solve(postures.next()));
    benchmark::DoNotOptimize(arm.X_BD());
  }
}

/// Measures the deflected shape of single postures with all outputs; no data is reused between postures.
void singleShape(benchmark::State& state) {
  Postures postures;
  for (auto _ : state) benchmark::DoNotOptimize(solveFlexibleKinematics(postures.arm, postures.next()));
}

void derive(benchmark::State& state, const std::vector<Variable>& variables) {
  Postures postures;
  TipDifferentiation tip(postures.arm);
  for (auto _ : state) {
    benchmark::DoNotOptimize(tip.solve(postures.next(), variables));
    benchmark::DoNotOptimize(tip.columns().data());
  }
  state.counters["variables"] = static_cast<double>(variables.size());
}

void flexibleJacobian(benchmark::State& state) { derive(state, jointVariables(cobraArm())); }

void numbersJacobian(benchmark::State& state) {
  std::vector<Variable> variables;
  for (const auto& parameter : parametersOf(cobraArm())) variables.push_back(Variable::number(parameter.path));
  derive(state, variables);
}

void stiffnessJacobian(benchmark::State& state) {
  std::vector<Variable> variables;
  for (const auto& parameter : parametersOf(cobraArm()))
    if (parameter.quantity == Quantity::kTorquePerAngle || parameter.quantity == Quantity::kPressure)
      variables.push_back(Variable::number(parameter.path));
  for (int axis = 0; axis < 3; ++axis) variables.push_back(Variable::gravityTurn(axis));
  for (const auto& joint : jointVariables(cobraArm())) variables.push_back(joint);
  derive(state, variables);
}

constexpr int kSideBySide = 64;

/// Measures the deflected shapes of a batch of postures, with Jacobians if `derive`; one iteration is one posture.
void batch(benchmark::State& state, bool derive) {
  Postures postures;
  Kinematics kinematics(postures.arm);
  PostureBatch all;
  all.resize(4, kSideBySide);
  for (Eigen::Index k = 0; k < kSideBySide; ++k) {
    const Posture& posture = postures.next();
    all.q.col(k) = posture.q;
    all.load[k] = posture.load;
  }
  TipBatch tips;
  int at = 0;
  for (auto _ : state) {
    if (at++ % kSideBySide != 0) continue;
    if (derive)
      kinematics.solveWithJacobian(all, tips);
    else
      kinematics.solve(all, tips);
    benchmark::DoNotOptimize(tips.poses.data());
  }
  state.counters["lanes"] = simd::kernels().back().lanes;
}

void batchedPose(benchmark::State& state) { batch(state, false); }
void batchedJacobian(benchmark::State& state) { batch(state, true); }

/// Goals that are reachable under the full load, with start postures whose tip is about one inch from the goal.
struct InverseProblems {
  Arm arm = cobraArm();
  std::vector<ToolGoal> goals;
  std::vector<Eigen::VectorXd> starts;
  InverseSolver solver{arm, 90, -Eigen::Vector3d::UnitZ()};

  InverseProblems() {
    std::mt19937_64 random(4);
    for (int k = 0; k < kSideBySide; ++k) {
      const Eigen::VectorXd q = randomJoints(arm, random);
      const auto shape = solveFlexibleKinematics(arm, {q, 90}, {1e-14, 100});
      goals.push_back({shape.X_BD.p, shape.X_BD.R * arm.tool_axis_L});
      starts.push_back(q.array() + (k % 2 ? 0.01 : -0.01));
    }
  }
};

void inverseOfTubes(benchmark::State& state) {
  InverseProblems problems;
  int at = 0;
  double branches = 0;
  for (auto _ : state) {
    if (at++ % kSideBySide != 0) continue;
    const auto found = problems.solver.solve(problems.goals);
    branches = 0;
    for (const auto& one : found) branches += static_cast<double>(one.branches.size());
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["branches"] = branches / kSideBySide;
}

void inverseOfViaPoints(benchmark::State& state) {
  InverseProblems problems;
  int at = 0;
  for (auto _ : state) {
    if (at++ % kSideBySide != 0) continue;
    benchmark::DoNotOptimize(problems.solver.refine(problems.goals, problems.starts));
  }
  state.SetItemsProcessed(state.iterations());
}

BENCHMARK(rigidPose)->Name("rigid KDL/pose");
BENCHMARK(rigidJacobian)->Name("rigid KDL/pose and Jacobian");
BENCHMARK(flexiblePose)->Name("flexible/pose");
BENCHMARK(singleShape)->Name("flexible/single shape");
BENCHMARK(batchedPose)->Name("flexible/pose, batched");
BENCHMARK(batchedJacobian)->Name("flexible/pose and Jacobian by joints, batched");
BENCHMARK(inverseOfTubes)->Name("inverse/tubes, all branches");
BENCHMARK(inverseOfViaPoints)->Name("inverse/via points");
BENCHMARK(flexibleJacobian)->Name("flexible/pose and Jacobian by joints");
BENCHMARK(stiffnessJacobian)->Name("flexible/pose and Jacobian by stiffnesses, base and joints");
BENCHMARK(numbersJacobian)->Name("flexible/pose and Jacobian by all numbers");

/// Prints the usual table, then the medians as multiples of the rigid arm's median.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs)
      if (run.aggregate_name == "median") medians_[run.run_name.function_name] = run.GetAdjustedCPUTime();
  }
  void Finalize() override {
    ConsoleReporter::Finalize();
    print("flexible/pose", "rigid KDL/pose");
    print("flexible/pose, batched", "rigid KDL/pose");
    print("flexible/pose and Jacobian by joints", "rigid KDL/pose and Jacobian");
    print("flexible/pose and Jacobian by joints, batched", "rigid KDL/pose and Jacobian");
  }

 private:
  void print(const std::string& ours, const std::string& theirs) {
    if (medians_.count(ours) && medians_.count(theirs))
      GetOutputStream() << ours << " / " << theirs << ": " << medians_[ours] / medians_[theirs] << "\n";
  }

  std::map<std::string, double> medians_;
};

}  // namespace
}  // namespace tubeplan::benchmarks

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  tubeplan::benchmarks::RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
  return 0;
}
