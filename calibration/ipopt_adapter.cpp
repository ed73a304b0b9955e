// The one place that knows Ipopt.
#include <IpIpoptApplication.hpp>
#include <IpSolveStatistics.hpp>
#include <IpTNLP.hpp>
#include <algorithm>
#include <cmath>

#include "calibration/least_squares.hpp"

namespace tubeplan::calibration {

namespace {

using Eigen::MatrixXd, Eigen::VectorXd;
using Ipopt::Index, Ipopt::Number;
constexpr double kUnbounded = 2e19;  // what Ipopt takes for infinity

/// Half the squared residual in scaled variables; one evaluation serves objective, gradient and Hessian at a point.
class ScaledProblem : public Ipopt::TNLP {
 public:
  explicit ScaledProblem(const LeastSquaresProblem& problem) : problem_(problem), n_(problem.start.size()) {}

  VectorXd solution;
  double chi2 = std::numeric_limits<double>::quiet_NaN();
  int evaluations = 0;

  bool get_nlp_info(Index& n, Index& m, Index& jacobian, Index& hessian, IndexStyleEnum& style) override {
    n = static_cast<Index>(n_);
    m = jacobian = 0;
    hessian = n * (n + 1) / 2;
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* lower, Number* upper, Index, Number*, Number*) override {
    for (Index k = 0; k < n; ++k) {
      lower[k] = std::max(problem_.lower[k] / problem_.scale[k], -kUnbounded);
      upper[k] = std::min(problem_.upper[k] / problem_.scale[k], kUnbounded);
    }
    return true;
  }

  bool get_starting_point(Index n, bool, Number* x, bool, Number*, Number*, Index, bool, Number*) override {
    for (Index k = 0; k < n; ++k) x[k] = problem_.start[k] / problem_.scale[k];
    return true;
  }

  bool eval_f(Index, const Number* x, bool, Number& value) override {
    if (!update(x)) return false;
    value = r_.squaredNorm() / 2;
    return std::isfinite(value);
  }

  bool eval_grad_f(Index n, const Number* x, bool, Number* gradient) override {
    if (!update(x)) return false;
    Eigen::Map<VectorXd>(gradient, n) = J_.transpose() * r_;
    return true;
  }

  bool eval_g(Index, const Number*, bool, Index, Number*) override { return true; }
  bool eval_jac_g(Index, const Number*, bool, Index, Index, Index*, Index*, Number*) override { return true; }

  bool eval_h(Index n, const Number* x, bool, Number factor, Index, const Number*, bool, Index, Index* rows,
              Index* columns, Number* values) override {
    if (values && !update(x)) return false;
    const MatrixXd H = values ? MatrixXd(factor * J_.transpose() * J_) : MatrixXd();
    for (Index i = 0, k = 0; i < n; ++i)
      for (Index j = 0; j <= i; ++j, ++k) {
        if (values)
          values[k] = H(i, j);
        else
          rows[k] = i, columns[k] = j;
      }
    return true;
  }

  /// Ipopt's own test is absolute in the gradient; with a large misfit rounding keeps it from ever being met. An
  /// objective that stays the same to rounding twice is as far down as it goes.
  bool intermediate_callback(Ipopt::AlgorithmMode, Index, Number value, Number, Number, Number, Number, Number, Number,
                             Number, Index, const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    resting_ = std::abs(value - last_value_) <= 1e-13 * std::abs(value) ? resting_ + 1 : 0;
    last_value_ = value;
    return resting_ < 2;
  }

  void finalize_solution(Ipopt::SolverReturn, Index n, const Number* x, const Number*, const Number*, Index,
                         const Number*, const Number*, Number value, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    solution = Eigen::Map<const VectorXd>(x, n).cwiseProduct(problem_.scale);
    chi2 = 2 * value;
  }

 private:
  bool update(const Number* scaled) {
    const VectorXd x = Eigen::Map<const VectorXd>(scaled, n_).cwiseProduct(problem_.scale);
    if (x_.size() == x.size() && x_ == x) return ok_;
    x_ = x;
    ++evaluations;
    ok_ = problem_.evaluate(x_, r_, &J_);
    if (ok_) J_ = J_ * problem_.scale.asDiagonal();
    return ok_;
  }

  const LeastSquaresProblem& problem_;
  Eigen::Index n_;
  VectorXd x_, r_;
  MatrixXd J_;
  bool ok_ = false;
  double last_value_ = std::numeric_limits<double>::quiet_NaN();
  int resting_ = 0;
};

Ipopt::SmartPtr<Ipopt::IpoptApplication> makeSolver(const LeastSquaresOptions& options) {
  Ipopt::SmartPtr<Ipopt::IpoptApplication> solver = IpoptApplicationFactory();
  auto settings = solver->Options();
  settings->SetIntegerValue("print_level", 0);
  settings->SetStringValue("sb", "yes");
  settings->SetNumericValue("tol", options.tolerance);
  settings->SetIntegerValue("max_iter", options.max_iterations);
  // Whitened residuals need no second scaling, and a least-squares start should not be pushed off its bounds.
  settings->SetStringValue("nlp_scaling_method", "none");
  settings->SetNumericValue("bound_relax_factor", 0);
  settings->SetNumericValue("acceptable_tol", options.tolerance * 1e3);
  settings->SetStringValue("mu_strategy", "adaptive");
  return solver;
}

const char* reasonOf(Ipopt::ApplicationReturnStatus status) {
  switch (status) {
    case Ipopt::Maximum_Iterations_Exceeded:
      return "stopped at the iteration limit";
    case Ipopt::Restoration_Failed:
      return "no step lowers the error";
    case Ipopt::Error_In_Step_Computation:
      return "the steps have become too small";
    case Ipopt::Invalid_Number_Detected:
      return "the model could not be evaluated";
    default:
      return "the solver failed";
  }
}

}  // namespace

LeastSquaresResult minimizeLeastSquares(const LeastSquaresProblem& problem, const LeastSquaresOptions& options) {
  LeastSquaresResult result;
  Ipopt::SmartPtr<ScaledProblem> scaled = new ScaledProblem(problem);
  auto solver = makeSolver(options);
  if (solver->Initialize("") != Ipopt::Solve_Succeeded) {
    result.status = LeastSquaresStatus::kFailed;
    result.reason = "Ipopt could not start";
    return result;
  }
  const auto status = solver->OptimizeTNLP(scaled);
  const bool good = status == Ipopt::Solve_Succeeded || status == Ipopt::Solved_To_Acceptable_Level ||
                    status == Ipopt::Search_Direction_Becomes_Too_Small || status == Ipopt::User_Requested_Stop;
  result.status = good                                           ? LeastSquaresStatus::kConverged
                  : status == Ipopt::Maximum_Iterations_Exceeded ? LeastSquaresStatus::kIterationLimit
                                                                 : LeastSquaresStatus::kFailed;
  if (!good) result.reason = reasonOf(status);
  result.x = scaled->solution.size() ? scaled->solution : problem.start;
  result.chi2 = scaled->chi2;
  if (Ipopt::IsValid(solver->Statistics())) result.iterations = solver->Statistics()->IterationCount();
  result.evaluations = scaled->evaluations;
  return result;
}

}  // namespace tubeplan::calibration
