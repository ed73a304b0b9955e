#include "calibration/measurement_checks/step_scan.hpp"

#include <algorithm>
#include <cmath>

#include "calibration/estimation/prior.hpp"
#include "calibration/estimation/whitened_residual.hpp"
#include "calibration/measurement_checks/robust_fit.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/statistics.hpp"
#include "deflection/parameters.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// Weights under Student's t distribution. Its scale fits the majority of the measurements, but is at least the noise;
/// `roots` are the square roots of the weights, one per row.
struct RowWeights {
  VectorXd roots;
  double variance = 1;
};
RowWeights weightsOf(const std::vector<Measurement>& measurements, const std::vector<int>& first_row,
                     const VectorXd& residual) {
  std::vector<double> squares;
  for (std::size_t k = 0; k < measurements.size(); ++k)
    squares.push_back(residual.segment(first_row[k], rowsOf(measurements[k])).squaredNorm() / rowsOf(measurements[k]));
  const double variance = std::max(1., median(squares));
  VectorXd roots(residual.size());
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    const int rows = rowsOf(measurements[k]);
    roots.segment(first_row[k], rows).setConstant(std::sqrt(studentWeight(rows * squares[k], rows, variance)));
  }
  return {roots, variance};
}

PredictionRequest slopesOfSteps(const deflection::Arm& arm) {
  PredictionRequest request;
  request.by_base = request.by_joints = true;
  for (const char* name : {"tool.tip.x", "tool.tip.y", "tool.tip.z"})
    if (const auto tip = deflection::findParameter(arm, name))
      request.numbers.push_back(deflection::Variable::number(tip->path));
  return request;
}

}  // namespace

double priceOfStep(int numbers, const std::vector<Measurement>& measurements) {
  const auto count = static_cast<double>(measurements.size());
  return numbers / 2. * std::log(3 * count) + std::log(count);
}

StepScan::StepScan(PlacedArm fitted, const FreeChoice& open, const std::vector<Measurement>& measurements,
                   const std::vector<StepForm>& forms)
    : measurements_(measurements), forms_(forms) {
  ok_ = measurements.size() >= 2 * kFewestOfStep && linearize(std::move(fitted), open);
}

bool StepScan::linearize(PlacedArm fitted, const FreeChoice& open) {
  const auto unknowns = chooseUnknowns(fitted, open);
  const auto weights = weighMeasurements(fitted, measurements_);
  if (!weights) return false;
  const auto at = whitenedResidual(fitted, unknowns.list, measurements_, *weights, zerosOf(unknowns.list), true);
  if (!at.ok || !at.r.allFinite() || !at.jacobian.allFinite()) return false;
  first_row_ = weights->first_row;
  const auto [roots, variance] = weightsOf(measurements_, first_row_, at.r);
  residual_ = roots.cwiseProduct(at.r);
  const MatrixXd J = roots.asDiagonal() * at.jacobian;
  MatrixXd A = J.transpose() * J;
  A.diagonal() += variance * priorSlopes(unknowns.list).cwiseAbs2();
  for (Index k = 0; k < A.rows(); ++k) {
    const double typical = unknowns.list[static_cast<std::size_t>(k)].typical;
    A(k, k) += 1e-9 * A(k, k) + 1e-12 / (typical * typical);
  }
  const Eigen::LLT<MatrixXd> factor(A);
  if (factor.info() != Eigen::Success) return false;
  by_fit_ = factor.matrixL().solve(J.transpose());
  residual_by_fit_ = by_fit_ * residual_;

  MeasurementPredictor predictor(fitted.arm);
  const PredictionRequest request = slopesOfSteps(fitted.arm);
  for (const StepForm& form : forms_) by_step_.emplace_back(MatrixXd::Zero(residual_.size(), form.numbers));
  for (std::size_t k = 0; k < measurements_.size(); ++k) {
    if (hasUnknownPlace(measurements_[k])) continue;  // an unknown place absorbs any step
    const auto& X_WB = basePoseAt(fitted, measurements_[k]);
    const Prediction predicted = predictor.predict(X_WB, measurements_[k], request);
    if (!predicted.ok) return false;
    for (std::size_t f = 0; f < forms_.size(); ++f) {
      if (!isOf(forms_[f], k)) continue;
      const MatrixXd slopes = forms_[f].slopes(predicted);
      if (slopes.cols() != forms_[f].numbers) return false;
      by_step_[f].middleRows(first_row_[k], slopes.rows()) = roots[first_row_[k]] * (weights->whitener[k] * slopes);
    }
  }
  return std::ranges::all_of(by_step_, [](const MatrixXd& S) { return S.allFinite(); });
}

bool StepScan::isOf(const StepForm& form, std::size_t measurement) const {
  return !form.setup || *form.setup == measurements_[measurement].setup;
}

std::optional<StepScan::Explained> StepScan::explained(const Sums& sums) const {
  MatrixXd reduced = sums.by_step - sums.by_fit.transpose() * sums.by_fit;
  constexpr double kLeastUnexplained =
      1e-6;  // smallest fraction of a column's squared length that the fit must leave unexplained
  for (Index k = 0; k < reduced.rows(); ++k)
    if (!(reduced(k, k) > kLeastUnexplained * sums.by_step(k, k))) return std::nullopt;
  const VectorXd scale = reduced.diagonal().cwiseSqrt().cwiseInverse();
  reduced = scale.asDiagonal() * reduced * scale.asDiagonal();
  reduced.diagonal().array() += 1e-9;
  const Eigen::LLT<MatrixXd> factor(reduced);
  if (factor.info() != Eigen::Success) return std::nullopt;
  const VectorXd b = scale.cwiseProduct(sums.residual - sums.by_fit.transpose() * residual_by_fit_);
  const VectorXd size = -factor.solve(b);
  return Explained{-b.dot(size) / 2, scale.cwiseProduct(size)};
}

StepScan::Sums StepScan::sumsOf(const MatrixXd& columns) const {
  return {by_fit_ * columns, columns.transpose() * columns, columns.transpose() * residual_};
}

double StepScan::gainOf(double fall) const {
  const double before = residual_.squaredNorm() - residual_by_fit_.squaredNorm();
  const double rows = static_cast<double>(residual_.size());
  const double after = std::max(before - 2 * fall, 0.);
  // Negative log likelihood as a function of the sum of squares, with the best scale that is at least one.
  const auto cost = [&](double squares) {
    const double variance = std::max(1., squares / rows);
    return rows / 2 * std::log(variance) + squares / (2 * variance);
  };
  return cost(before) - cost(after);
}

std::optional<FoundStep> StepScan::bestStep(std::size_t form) const {
  const int numbers = forms_[form].numbers;
  std::vector<std::size_t> members;
  for (std::size_t k = 0; k < measurements_.size(); ++k)
    if (isOf(forms_[form], k)) members.push_back(k);
  const std::size_t fewest = std::max<std::size_t>(kFewestOfStep, static_cast<std::size_t>(2 * numbers + 2) / 3);
  if (members.size() < 2 * fewest) return std::nullopt;
  Sums sums{MatrixXd::Zero(by_fit_.rows(), numbers), MatrixXd::Zero(numbers, numbers), VectorXd::Zero(numbers)};
  FoundStep best;
  double most = 0;
  for (std::size_t m = members.size(); m-- > fewest;) {
    const std::size_t k = members[m];
    const Index first = first_row_[k], rows = rowsOf(measurements_[k]);
    const auto columns = by_step_[form].middleRows(first, rows);
    sums.by_fit += by_fit_.middleCols(first, rows) * columns;
    sums.by_step += columns.transpose() * columns;
    sums.residual += columns.transpose() * residual_.segment(first, rows);
    if (members.size() - m < fewest) continue;
    const auto candidate = explained(sums);
    if (!candidate || !(candidate->gain > most)) continue;
    most = candidate->gain;
    best = {form, k, 0, candidate->size};
  }
  if (!(most > 0)) return std::nullopt;
  best.merit = gainOf(most) - priceOfStep(numbers, measurements_);
  return best;
}

std::vector<FoundStep> StepScan::steps() const {
  std::vector<FoundStep> found;
  for (std::size_t f = 0; f < forms_.size(); ++f)
    if (auto best = bestStep(f)) found.push_back(std::move(*best));
  std::ranges::stable_sort(found, std::greater{}, &FoundStep::merit);
  return found;
}

VectorXd StepScan::sizeAt(std::size_t form, std::size_t measurement) const {
  MatrixXd columns = by_step_[form];
  columns.topRows(first_row_[measurement]).setZero();
  const auto found = explained(sumsOf(columns));
  return found ? found->size : VectorXd::Zero(forms_[form].numbers);
}

MatrixXd StepScan::driftColumns(std::size_t form, const std::vector<VectorXd>& along) const {
  const MatrixXd& S = by_step_[form];
  MatrixXd columns(S.rows(), S.cols() * static_cast<Index>(along.size()));
  for (std::size_t c = 0; c < along.size(); ++c)
    for (std::size_t k = 0; k < measurements_.size(); ++k)
      columns.block(first_row_[k], static_cast<Index>(c) * S.cols(), rowsOf(measurements_[k]), S.cols()) =
          along[c][static_cast<Index>(k)] * S.middleRows(first_row_[k], rowsOf(measurements_[k]));
  return columns;
}

/// Returns candidate functions for a creep, each with one column per parameter. They depend on conditions (such as
/// time), load, joints or row number.
std::vector<std::vector<VectorXd>> StepScan::courses(const StepForm& form) const {
  const auto count = static_cast<Index>(measurements_.size());
  const auto by = [&](auto number) {
    VectorXd values(count);
    for (Index k = 0; k < count; ++k) values[k] = number(measurements_[static_cast<std::size_t>(k)], k);
    return values;
  };
  const auto centred = [](VectorXd values) {
    values.array() -= values.mean();
    const double largest = values.cwiseAbs().maxCoeff();
    return VectorXd(largest > 0 ? values / largest : values);
  };
  std::vector<std::vector<VectorXd>> courses;
  const auto add = [&](const VectorXd& values, bool with_square) {
    if (!values.allFinite()) return;
    const VectorXd along = centred(values);
    if (along.cwiseAbs().maxCoeff() == 0) return;
    courses.push_back({along});
    if (with_square) courses.push_back({along, along.cwiseAbs2()});
  };
  add(by([](const auto&, Index k) { return static_cast<double>(k); }), true);
  for (const auto& kind : deflection::kConditionKinds)
    add(by([&](const auto& m, Index) { return m.conditions[kind.condition]; }),
        kind.course == deflection::Course::kSlow);
  add(by([](const auto& m, Index) { return m.load; }), true);
  for (const double share : {0.25, 0.1})  // exponential warm-up
    add(by([&](const auto&, Index k) {
          return std::exp(-static_cast<double>(k) / (share * static_cast<double>(count)));
        }),
        false);
  for (Index j = 0; j < measurements_.front().q.size(); ++j) {
    add(by([&](const auto& m, Index) { return m.q[j]; }), false);
    add(by([&](const auto& m, Index) { return std::sin(m.q[j]); }), false);
    add(by([&](const auto& m, Index) { return std::cos(m.q[j]); }), false);
    add(by([&](const auto& m, Index) {
          const auto at = static_cast<std::size_t>(j);
          return at < m.approach_directions.size() ? m.approach_directions[at] : 0.;
        }),
        false);
  }
  if (form.is_of_tip) {
    std::vector<std::string> setups;
    for (const auto& m : measurements_)
      if (std::ranges::find(setups, m.setup) == setups.end()) setups.push_back(m.setup);
    for (std::size_t s = 1; s < setups.size(); ++s)
      add(by([&](const auto& m, Index) { return m.setup == setups[s] ? 1. : 0.; }), false);
  }
  return courses;
}

double StepScan::bestDrift() const {
  double best = 0;
  for (std::size_t f = 0; f < forms_.size(); ++f)
    for (const auto& along : courses(forms_[f])) {
      const MatrixXd columns = driftColumns(f, along);
      if (const auto found = explained(sumsOf(columns)))
        best = std::max(best, gainOf(found->gain) - priceOfStep(static_cast<int>(columns.cols()), measurements_));
    }
  return best;
}

}  // namespace tubeplan::calibration
