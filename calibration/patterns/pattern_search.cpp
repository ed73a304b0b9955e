#include "calibration/patterns/pattern_search.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

namespace {

constexpr double kAbsorbed = 1e-6;  // squared fraction of a column's norm below which the column is considered absorbed
constexpr int kTrendSteps = 5;
constexpr Index kFewGroups = 40;
constexpr PatternFrame kFrames[] = {PatternFrame::kWorld, PatternFrame::kRadial, PatternFrame::kTool};

const Eigen::Matrix3d& axesOf(const MeasurementScene& scene, PatternFrame frame, std::size_t k) {
  static const Eigen::Matrix3d kWorldAxes = Eigen::Matrix3d::Identity();
  if (frame == PatternFrame::kRadial) return scene.radials[k];
  return frame == PatternFrame::kTool ? scene.tools[k] : kWorldAxes;
}

/// Returns an orthonormal basis of columns that remain after a projection. `lengths` are the norms before the
/// projection; remainders that are only rounding errors are dropped.
MatrixXd orthonormal(const MatrixXd& columns, const VectorXd& lengths) {
  if (columns.cols() == 0) return columns;
  const MatrixXd scaled = columns * lengths.cwiseMax(1e-300).cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> gram(scaled.transpose() * scaled);
  const Index rank = (gram.eigenvalues().array() > kAbsorbed).count();
  const auto kept = gram.eigenvectors().rightCols(rank);
  return scaled * kept * gram.eigenvalues().tail(rank).cwiseSqrt().cwiseInverse().asDiagonal();
}

/// The measurements to search, with the components of their residual that the fitted unknowns absorb.
struct SearchedScene {
  const MeasurementScene& scene;
  const MeasurementWeights& weights;
  MatrixXd absorbed;  ///< orthonormal basis of the fitted unknowns' columns
  VectorXd r;
  int freedom = 0;
  const StopQuestion& stop;

  [[nodiscard]] Index rowOf(int measurement) const { return weights.first_row[static_cast<std::size_t>(measurement)]; }

  /// Returns orthonormal columns for basis functions in the axes of a frame, without the components that `others`
  /// (orthonormal) and the touched points absorb.
  [[nodiscard]] MatrixXd columnsOf(const MatrixXd& basis, PatternFrame frame, const MatrixXd& others) const {
    throwIfStopped(stop);
    MatrixXd columns(weights.rows, 3 * basis.cols());
    for (std::size_t k = 0; k < scene.measurements.size(); ++k) {
      const MatrixXd along = weights.whitener[k] * placeSlope(scene, k) * axesOf(scene, frame, k);
      for (Index j = 0; j < basis.cols(); ++j)
        columns.block(weights.first_row[k], 3 * j, along.rows(), 3) = along * basis(static_cast<Index>(k), j);
    }
    const VectorXd lengths = columns.colwise().norm();
    removeSharedParts(weights, columns);
    throwIfStopped(stop);
    columns -= (others * (others.transpose() * columns)).eval();
    return orthonormal(columns, lengths);
  }
};

MatrixXd joined(const MatrixXd& a, const MatrixXd& b) {
  MatrixXd both(a.rows(), a.cols() + b.cols());
  both << a, b;
  return both;
}

/// Divides the measurements into bins of neighbouring values: equal values always share a bin, and many different
/// values form at most kTrendSteps bins.
std::vector<std::vector<int>> lotsOf(const Variable& variable) {
  std::vector<int> order;
  for (int k = 0; k < static_cast<int>(variable.value.size()); ++k)
    if (std::isfinite(variable.value[k])) order.push_back(k);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return variable.value[a] < variable.value[b]; });
  std::set<double> distinct;
  for (const int k : order) distinct.insert(variable.value[k]);
  const bool all_separate = !variable.groups.empty() || static_cast<int>(distinct.size()) <= kTrendSteps;
  std::vector<std::vector<int>> lots;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_equal = i > 0 && variable.value[order[i]] == variable.value[order[i - 1]];
    const bool is_full = all_separate || i * kTrendSteps >= lots.size() * order.size();
    if (lots.empty() || (is_full && !is_equal)) lots.emplace_back();
    lots.back().push_back(order[i]);
  }
  return lots;
}

/// Returns, for each measurement, the part of its error that the pattern explains and the fit does not absorb, in the
/// axes of the frame [m].
Eigen::Matrix3Xd followedErrors(const SearchedScene& search, PatternFrame frame, const VectorXd& followed) {
  const auto& scene = search.scene;
  Eigen::Matrix3Xd errors(3, static_cast<Index>(scene.measurements.size()));
  for (std::size_t k = 0; k < scene.measurements.size(); ++k) {
    const MatrixXd seen = placeSlope(scene, k);
    const VectorXd error = search.weights.whitener[k].triangularView<Eigen::Lower>().solve(
        followed.segment(search.weights.first_row[k], seen.rows()));
    errors.col(static_cast<Index>(k)) = axesOf(scene, frame, k).transpose() * seen.transpose() * error;
  }
  return errors;
}

void describeTrend(const Variable& variable, const Eigen::Matrix3Xd& errors, PatternTest& test) {
  for (const auto& lot : lotsOf(variable)) {
    TrendStep step{0, Vector3d::Zero(), static_cast<int>(lot.size())};
    for (const int k : lot) {
      step.at += variable.value[k] / static_cast<double>(lot.size());
      step.error += errors.col(k) / static_cast<double>(lot.size());
    }
    test.trend.push_back(step);
  }
  test.groups = variable.groups;
  const Vector3d mean_squares = errors.rowwise().squaredNorm() / static_cast<double>(errors.cols());
  test.followed_rms = std::sqrt(mean_squares.sum());
  for (int c = 0; c < 3; ++c) {
    const auto by_component = [c](const TrendStep& a, const TrendStep& b) { return a.error[c] < b.error[c]; };
    const auto [low, high] = std::minmax_element(test.trend.begin(), test.trend.end(), by_component);
    const double size = test.trend.size() == 1 ? std::sqrt(mean_squares[c]) : high->error[c] - low->error[c];
    if (test.component >= 0 && size <= test.size) continue;
    test.size = size;
    test.component = c;
    test.low = static_cast<int>(low - test.trend.begin());
    test.high = static_cast<int>(high - test.trend.begin());
  }
}

double tailOfF(double F, int numbers, int remaining_freedom) {
  if (!std::isfinite(F)) return 0;
  return fisherTail(F, numbers, remaining_freedom);
}

/// A variable whose effect is to be tested in the axes of one frame.
struct Question {
  const PatternKind* kind;
  const Variable* variable;
  PatternFrame frame;
};

bool isConstant(const Variable& variable) { return variable.groups.empty() && !varies(variable.value); }

/// The part of the residual that a variable explains, and the number of degrees of freedom used for it.
struct Followed {
  VectorXd part;
  int numbers = 0;
};

/// Returns a column of ones and zeros for each group. This is suitable for few groups; measurements may share a touched
/// point or noise with measurements of other groups.
MatrixXd membershipOf(const Variable& variable) {
  MatrixXd basis = MatrixXd::Zero(variable.value.size(), static_cast<Index>(variable.groups.size()));
  for (Index k = 0; k < variable.value.size(); ++k) basis(k, static_cast<Index>(variable.value[k])) = 1;
  return basis;
}

Followed followFunctions(const SearchedScene& search, const Question& question, const MatrixXd& fitted_columns,
                         const VectorXd& r) {
  const Variable& variable = *question.variable;
  const MatrixXd basis = variable.groups.empty() ? variable.basis : membershipOf(variable);
  const MatrixXd columns = search.columnsOf(basis, question.frame, fitted_columns);
  return {columns * (columns.transpose() * r), static_cast<int>(columns.cols())};
}

/// Returns the indices of the measurements of each group.
std::vector<std::vector<int>> membersOf(const Variable& variable) {
  std::vector<std::vector<int>> members(variable.groups.size());
  for (Index k = 0; k < variable.value.size(); ++k)
    members[static_cast<std::size_t>(variable.value[k])].push_back(static_cast<int>(k));
  return members;
}

/// Analyses the variance by groups, where each group's mean is a parameter. With B the projection onto the groups'
/// means and Q the fitted unknowns, r^T B r has tr B - tr Q^T B Q degrees of freedom. The computation runs group by
/// group, so that many groups cost no more than one group of all measurements. A touched point or noise that
/// measurements share with other groups is not removed.
Followed followGroups(const SearchedScene& search, const Variable& variable, const MatrixXd& fitted_columns,
                      const VectorXd& r) {
  Followed followed{VectorXd::Zero(r.size()), 0};
  double numbers = 0;
  for (const auto& group : membersOf(variable)) {
    Index rows = 0;
    for (const int k : group) rows += rowsOf(search.scene.measurements[static_cast<std::size_t>(k)]);
    MatrixXd columns(rows, 3), fitted(rows, fitted_columns.cols());
    VectorXd own(rows);
    Index at = 0;
    for (const int k : group) {
      const auto n = static_cast<std::size_t>(k);
      const MatrixXd along = search.weights.whitener[n] * placeSlope(search.scene, n);
      columns.middleRows(at, along.rows()) = along;
      fitted.middleRows(at, along.rows()) = fitted_columns.middleRows(search.rowOf(k), along.rows());
      own.segment(at, along.rows()) = r.segment(search.rowOf(k), along.rows());
      at += along.rows();
    }
    const VectorXd lengths = columns.colwise().norm();
    removeSharedPartsWithin(search.weights, group, columns);
    const MatrixXd mean = orthonormal(columns, lengths);
    numbers += static_cast<double>(mean.cols()) - (mean.transpose() * fitted).squaredNorm();
    const VectorXd part = mean * (mean.transpose() * own);
    at = 0;
    for (const int k : group) {
      const Index count = rowsOf(search.scene.measurements[static_cast<std::size_t>(k)]);
      followed.part.segment(search.rowOf(k), count) = part.segment(at, count);
      at += count;
    }
  }
  followed.numbers = static_cast<int>(std::lround(numbers));
  return followed;
}

/// Tests a variable in one frame, in addition to the columns `others`. `PatternTest::numbers` is 0 if no column or no
/// degree of freedom remains.
PatternTest testVariable(const SearchedScene& search, const Question& question, const MatrixXd& others) {
  PatternTest test;
  const Variable& variable = *question.variable;
  test.kind = question.kind->name;
  test.variable = variable.name;
  test.unit = variable.unit;
  test.frame = question.frame;
  MatrixXd fitted_columns = others;
  if (!isConstant(variable))
    fitted_columns = joined(others, search.columnsOf(MatrixXd::Ones(variable.value.size(), 1), question.frame, others));
  throwIfStopped(search.stop);
  const VectorXd r = search.r - fitted_columns * (fitted_columns.transpose() * search.r);
  const bool is_dense = static_cast<Index>(variable.groups.size()) <= kFewGroups;
  const Followed followed = is_dense ? followFunctions(search, question, fitted_columns, r)
                                     : followGroups(search, variable, fitted_columns, r);
  test.remaining_freedom =
      search.freedom - static_cast<int>(fitted_columns.cols() - search.absorbed.cols()) - followed.numbers;
  if (followed.numbers <= 0 || test.remaining_freedom < 1) return test;
  test.numbers = followed.numbers;
  test.fall = followed.part.squaredNorm();
  test.share = test.fall / std::max(1e-300, search.r.squaredNorm());
  test.F = test.fall / test.numbers / std::max(1e-300, (r.squaredNorm() - test.fall) / test.remaining_freedom);
  test.p_value = tailOfF(test.F, test.numbers, test.remaining_freedom);
  describeTrend(variable, -followedErrors(search, question.frame, followed.part), test);
  return test;
}

void correctByHolm(std::vector<PatternTest>& tests, double level) {
  double corrected = 0;
  for (std::size_t k = 0; k < tests.size(); ++k) {
    corrected = std::max(corrected, std::min(1., static_cast<double>(tests.size() - k) * tests[k].p_value));
    tests[k].p_corrected = corrected;
    tests[k].is_finding = corrected <= level;
  }
}

/// Returns one finding for each variable, tested again in addition to all stronger independent findings.
std::vector<PatternTest> distinctFindings(const SearchedScene& search, const std::vector<Question>& questions,
                                          const std::vector<PatternTest>& tests, double level) {
  std::vector<PatternTest> findings;
  MatrixXd fitted_columns = search.absorbed;
  for (const auto& test : tests) {
    const bool is_reported = std::any_of(findings.begin(), findings.end(),
                                         [&](const PatternTest& other) { return other.variable == test.variable; });
    if (!test.is_finding || is_reported) continue;
    findings.push_back(test);
    const auto question = std::find_if(questions.begin(), questions.end(), [&](const Question& q) {
      return q.variable->name == test.variable && q.frame == test.frame;
    });
    const PatternTest again = findings.size() == 1 ? test : testVariable(search, *question, fitted_columns);
    if (again.p_value * static_cast<double>(tests.size()) > level)
      findings.back().goes_with = findings.front().variable;
    else if (question->variable->groups.empty())
      fitted_columns =
          joined(fitted_columns, search.columnsOf(question->variable->basis, question->frame, fitted_columns));
  }
  return findings;
}

}  // namespace

PatternSearch searchPatterns(const MeasurementScene& scene, const MeasurementWeights& weights,
                             const WhitenedResidual& residual, double level, const WorkHooks& hooks) {
  PatternSearch result;
  reportProgress(hooks, "patterns");
  SearchedScene search{scene,      weights, orthonormal(residual.jacobian, residual.jacobian.colwise().norm()),
                       residual.r, 0,       hooks.stop};
  search.freedom = weights.degrees_of_freedom - static_cast<int>(search.absorbed.cols());
  std::vector<std::vector<Variable>> variables;
  for (const auto& kind : patternKinds()) {
    variables.push_back(kind.variables(scene));
    if (variables.back().empty()) result.not_tested.push_back(std::string(kind.name) + ": needs " + kind.needs);
  }
  std::vector<Question> questions;
  for (std::size_t k = 0; k < variables.size(); ++k)
    for (const auto& variable : variables[k])
      for (const PatternFrame frame : kFrames)
        if (variable.groups.empty() || frame == PatternFrame::kWorld)
          questions.push_back({&patternKinds()[k], &variable, frame});
  std::vector<PatternTest> tests(questions.size());
  tbb::parallel_for(std::size_t{0}, questions.size(), [&](std::size_t k) {
    if (!shouldStop(hooks.stop)) tests[k] = testVariable(search, questions[k], search.absorbed);
  });
  throwIfStopped(hooks.stop);
  for (const auto& test : tests)
    if (test.numbers > 0)
      result.tests.push_back(test);
    else if (test.frame == PatternFrame::kWorld)
      result.not_tested.push_back(test.variable + ": the fit absorbs it, or there are too few readings");
  std::stable_sort(result.tests.begin(), result.tests.end(),
                   [](const PatternTest& a, const PatternTest& b) { return a.p_value < b.p_value; });
  correctByHolm(result.tests, level);
  result.findings = distinctFindings(search, questions, result.tests, level);
  return result;
}

}  // namespace tubeplan::calibration
