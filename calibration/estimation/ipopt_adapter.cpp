// Interior-point method by Ipopt. Ipopt is used only in this file.
#include <IpIpoptApplication.hpp>
#include <IpSolveStatistics.hpp>
#include <IpTNLP.hpp>
#include <cmath>
#include <mutex>

#include "calibration/estimation/scaled_problem.hpp"

namespace tubeplan::calibration {

namespace {

using Eigen::MatrixXd, Eigen::VectorXd;
using Ipopt::Number;
constexpr double kUnbounded = 2e19;      // Ipopt's value for infinity
constexpr double kRestingShare = 1e-13;  // relative change of chi2 that is attributed to rounding
constexpr double kNearBound = 1e-2;      // distance below which a variable is near a bound, in units of its scale

/// The problem in Ipopt's interface; its objective is half the squared residual. Trial points are evaluated without a
/// Jacobian. The Jacobian at an accepted point gives both the gradient and the (Gauss-Newton) Hessian.
class NonlinearProgram : public Ipopt::TNLP {
 public:
  NonlinearProgram(ScaledProblem& problem, const IterationObserver& observe)
      : problem_(problem), observe_(observe), n_(problem.lower().size()) {}

  VectorXd solution;
  double chi2 = std::numeric_limits<double>::quiet_NaN();

  bool get_nlp_info(Ipopt::Index& n, Ipopt::Index& m, Ipopt::Index& jacobian, Ipopt::Index& hessian,
                    IndexStyleEnum& style) override {
    n = static_cast<Ipopt::Index>(n_);
    m = jacobian = 0;
    hessian = n * (n + 1) / 2;
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Ipopt::Index n, Number* lower, Number* upper, Ipopt::Index, Number*, Number*) override {
    Eigen::Map<VectorXd>(lower, n) = problem_.lower().cwiseMax(-kUnbounded);
    Eigen::Map<VectorXd>(upper, n) = problem_.upper().cwiseMin(kUnbounded);
    return true;
  }

  bool get_starting_point(Ipopt::Index n, bool, Number* x, bool, Number*, Number*, Ipopt::Index, bool,
                          Number*) override {
    Eigen::Map<VectorXd>(x, n) = problem_.start();
    return true;
  }

  bool eval_f(Ipopt::Index, const Number* x, bool, Number& value) override {
    value = chi2At(x) / 2;
    return std::isfinite(value);
  }

  bool eval_grad_f(Ipopt::Index n, const Number* x, bool, Number* gradient) override {
    if (!linearize(x)) return false;
    Eigen::Map<VectorXd>(gradient, n) = J_.transpose() * r_;
    return true;
  }

  bool eval_g(Ipopt::Index, const Number*, bool, Ipopt::Index, Number*) override { return true; }
  bool eval_jac_g(Ipopt::Index, const Number*, bool, Ipopt::Index, Ipopt::Index, Ipopt::Index*, Ipopt::Index*,
                  Number*) override {
    return true;
  }

  bool eval_h(Ipopt::Index n, const Number* x, bool, Number factor, Ipopt::Index, const Number*, bool, Ipopt::Index,
              Ipopt::Index* rows, Ipopt::Index* columns, Number* values) override {
    if (values && !linearize(x)) return false;
    const MatrixXd H = values ? MatrixXd(factor * J_.transpose() * J_) : MatrixXd();
    for (Ipopt::Index i = 0, k = 0; i < n; ++i)
      for (Ipopt::Index j = 0; j <= i; ++j, ++k) {
        if (values)
          values[k] = H(i, j);
        else
          rows[k] = i, columns[k] = j;
      }
    return true;
  }

  /// Ends the iteration at the minimum. Ipopt's own test compares the gradient with an absolute tolerance, which
  /// rounding makes unattainable if the residuals are large. Here, the minimum is reached if a Gauss-Newton step
  /// predicts no decrease beyond rounding, or if two successive steps gave none.
  bool intermediate_callback(Ipopt::AlgorithmMode, Ipopt::Index iteration, Number value, Number, Number, Number,
                             Number step, Number damping, Number, Number, Ipopt::Index, const Ipopt::IpoptData*,
                             Ipopt::IpoptCalculatedQuantities*) override {
    if (observe_) observe_({"ipopt", static_cast<int>(iteration), 2 * value, step, damping});
    resting_ = std::abs(value - last_value_) <= kRestingShare * std::abs(value) ? resting_ + 1 : 0;
    last_value_ = value;
    return resting_ < 2 && !isAtBottom(value);
  }

  void finalize_solution(Ipopt::SolverReturn, Ipopt::Index n, const Number* x, const Number*, const Number*,
                         Ipopt::Index, const Number*, const Number*, Number, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    solution = Eigen::Map<const VectorXd>(x, n);
    chi2 = chi2At(x);  // the value that Ipopt passes is invalid if an evaluation has failed
  }

 private:
  /// Returns true if a Gauss-Newton step predicts no further decrease. Near a bound, returns false, because Ipopt's
  /// steps also depend on the barrier terms there.
  [[nodiscard]] bool isAtBottom(Number value) const {
    const double now = 2 * value;
    if (!linearized_ || !(std::abs(r_.squaredNorm() - now) <= kRestingShare * now)) return false;
    const VectorXd room =
        (linearized_x_ - problem_.lower()).cwiseMin(problem_.upper() - linearized_x_).cwiseMin(1 / kNearBound);
    if (!(room.minCoeff() >= kNearBound)) return false;
    const VectorXd gradient = J_.transpose() * r_;
    const Eigen::LLT<MatrixXd> normal(J_.transpose() * J_);
    if (normal.info() != Eigen::Success) return false;
    return normal.matrixL().solve(gradient).squaredNorm() <= kRestingShare * now;
  }

  double chi2At(const Number* at) {
    const VectorXd x = Eigen::Map<const VectorXd>(at, n_);
    if (linearized_ && isAt(x, linearized_x_)) return r_.squaredNorm();
    if (isAt(x, x_)) return chi2_;
    x_ = x;
    return chi2_ = problem_.chi2At(x);
  }

  bool linearize(const Number* at) {
    const VectorXd x = Eigen::Map<const VectorXd>(at, n_);
    if (isAt(x, linearized_x_)) return linearized_;
    linearized_x_ = x;
    return linearized_ = problem_.linearizeAt(x, r_, J_);
  }

  static bool isAt(const VectorXd& x, const VectorXd& known) { return known.size() == x.size() && known == x; }

  ScaledProblem& problem_;
  const IterationObserver& observe_;
  Eigen::Index n_;
  VectorXd x_;  // point at which chi2_ was computed
  double chi2_ = std::numeric_limits<double>::quiet_NaN();
  VectorXd linearized_x_, r_;  // point at which r_ and J_ were computed, and the residual there
  MatrixXd J_;
  bool linearized_ = false;
  double last_value_ = std::numeric_limits<double>::quiet_NaN();
  int resting_ = 0;
};

/// Returns a solver, or null if Ipopt could not start.
Ipopt::SmartPtr<Ipopt::IpoptApplication> makeSolver() {
  Ipopt::SmartPtr<Ipopt::IpoptApplication> solver = IpoptApplicationFactory();
  auto settings = solver->Options();
  settings->SetIntegerValue("print_level", 0);
  settings->SetStringValue("sb", "yes");
  // Whitened residuals need no further scaling, and bounds must hold exactly, whereas Ipopt relaxes them by default.
  settings->SetStringValue("nlp_scaling_method", "none");
  settings->SetNumericValue("bound_relax_factor", 0);
  settings->SetStringValue("mu_strategy", "adaptive");
  // Overhead dominates the cost of each linear solution by MUMPS. These settings reduce the number of solutions per
  // step from three to one, and refine a solution only if it is inaccurate.
  settings->SetStringValue("mu_oracle", "loqo");
  settings->SetIntegerValue("min_refinement_steps", 0);
  if (solver->Initialize("") != Ipopt::Solve_Succeeded) return nullptr;
  return solver;
}

struct Meaning {
  LeastSquaresStatus status;
  const char* reason;
};

Meaning meaningOf(Ipopt::ApplicationReturnStatus status) {
  using Status = LeastSquaresStatus;
  switch (status) {
    case Ipopt::Solve_Succeeded:
      return {Status::kConverged, "the gradient is within tolerance"};
    case Ipopt::Solved_To_Acceptable_Level:
      return {Status::kConverged, "the gradient is within a thousand tolerances"};
    case Ipopt::User_Requested_Stop:
    case Ipopt::Search_Direction_Becomes_Too_Small:
      return {Status::kConverged, "chi2 falls only within rounding"};
    case Ipopt::Maximum_Iterations_Exceeded:
      return {Status::kIterationLimit, "stopped at the iteration limit"};
    case Ipopt::Restoration_Failed:
      return {Status::kFailed, "no step lowers the error"};
    case Ipopt::Error_In_Step_Computation:
      return {Status::kFailed, "the steps have become too small"};
    case Ipopt::Invalid_Number_Detected:
      return {Status::kFailed, "the model could not be evaluated"};
    default:
      return {Status::kFailed, "the solver failed"};
  }
}

}  // namespace

LeastSquaresResult minimizeByInteriorPoint(const LeastSquaresProblem& problem, const LeastSquaresStop& stop,
                                           const IterationObserver& observe) {
  // Calls are serialised, because MUMPS, the linear solver of Debian's Ipopt, keeps its instances in a process-wide
  // table without a lock. All calls share one Ipopt instance, because creating one takes longer than solving a typical
  // problem.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  static const Ipopt::SmartPtr<Ipopt::IpoptApplication> solver = makeSolver();
  using Status = LeastSquaresStatus;
  ScaledProblem scaled(problem);
  Ipopt::SmartPtr<NonlinearProgram> program = new NonlinearProgram(scaled, observe);
  if (!Ipopt::IsValid(solver))
    return scaled.resultAt(scaled.start(), program->chi2, Status::kFailed, "Ipopt could not start");
  solver->Options()->SetNumericValue("tol", stop.tolerance);
  solver->Options()->SetNumericValue("acceptable_tol", stop.tolerance * 1e3);
  solver->Options()->SetIntegerValue("max_iter", stop.max_iterations);
  const auto [status, reason] = meaningOf(solver->OptimizeTNLP(program));
  if (!std::isfinite(program->chi2)) return scaled.failureAtStart();
  const int iterations = Ipopt::IsValid(solver->Statistics()) ? solver->Statistics()->IterationCount() : 0;
  return scaled.resultAt(program->solution, program->chi2, status, reason, iterations);
}

}  // namespace tubeplan::calibration
