#include "studies/benchmarks/ceres_solver.hpp"

#include <ceres/ceres.h>

namespace tubeplan::benchmarks {

namespace {

using calibration::LeastSquaresProblem, calibration::LeastSquaresResult, calibration::LeastSquaresStatus;
using Eigen::MatrixXd, Eigen::VectorXd;
using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// All residuals as one cost function of a single block of variables, each of which is divided by its scale.
class WholeResidual : public ceres::CostFunction {
 public:
  WholeResidual(const LeastSquaresProblem& problem, int residuals) : problem_(problem) {
    set_num_residuals(residuals);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.start.size()));
  }

  mutable int evaluations = 0, jacobian_evaluations = 0;

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const bool derive = jacobians && jacobians[0];
    ++(derive ? jacobian_evaluations : evaluations);
    const VectorXd x = Eigen::Map<const VectorXd>(parameters[0], problem_.start.size()).cwiseProduct(problem_.scale);
    VectorXd r;
    MatrixXd jacobian;
    if (!problem_.evaluate(x, r, derive ? &jacobian : nullptr)) return false;
    Eigen::Map<VectorXd>(residuals, num_residuals()) = r;
    if (derive)
      Eigen::Map<RowMajorMatrix>(jacobians[0], num_residuals(), x.size()) = jacobian * problem_.scale.asDiagonal();
    return true;
  }

 private:
  const LeastSquaresProblem& problem_;
};

int countResiduals(const LeastSquaresProblem& problem) {
  VectorXd r;
  problem.evaluate(problem.start, r, nullptr);
  return static_cast<int>(r.size());
}

ceres::Solver::Options solverOptions() {
  ceres::Solver::Options options;
  options.trust_region_strategy_type = ceres::LEVENBERG_MARQUARDT;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = 200;
  // Gradient at which the interior-point method of `calibration` also stops.
  options.gradient_tolerance = 1e-10;
  options.function_tolerance = 1e-13;
  options.parameter_tolerance = 1e-13;
  return options;
}

LeastSquaresStatus statusOf(ceres::TerminationType type) {
  switch (type) {
    case ceres::CONVERGENCE:
      return LeastSquaresStatus::kConverged;
    case ceres::NO_CONVERGENCE:
      return LeastSquaresStatus::kIterationLimit;
    default:
      return LeastSquaresStatus::kFailed;
  }
}

}  // namespace

LeastSquaresResult minimizeByCeres(const LeastSquaresProblem& problem) {
  VectorXd x = problem.start.cwiseQuotient(problem.scale);
  WholeResidual cost(problem, countResiduals(problem));
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem program(ownership);
  program.AddResidualBlock(&cost, nullptr, x.data());
  for (int k = 0; k < x.size(); ++k) {
    program.SetParameterLowerBound(x.data(), k, problem.lower[k] / problem.scale[k]);
    program.SetParameterUpperBound(x.data(), k, problem.upper[k] / problem.scale[k]);
  }
  ceres::Solver::Summary summary;
  ceres::Solve(solverOptions(), &program, &summary);
  return {statusOf(summary.termination_type),
          summary.message,
          x.cwiseProduct(problem.scale),
          2 * summary.final_cost,
          static_cast<int>(summary.iterations.size()) - 1,
          cost.evaluations + 1,  // one more evaluation was needed to count the residuals
          cost.jacobian_evaluations};
}

}  // namespace tubeplan::benchmarks
