#include "calibration/watch/change_watch.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "calibration/estimation/whitened_residual.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kTurnLever = 1;        // length that makes rotations comparable with shifts [m]
constexpr double kUndetermined = 1e-9;  // information, relative to the largest, below which a direction is undetermined
constexpr double kPartOfDirection = 1e-3;  // component from which on a direction counts as partly along an axis
constexpr int kLeftToJudge = 9;            // degrees of freedom beyond those of a step that suffice to judge it
constexpr int kMeasurementsToJudge = 30;   // largest number of measurements after an alarm that judge what has changed
constexpr int kAlikeStarts = 4;            // number of latest measurements that are all tried as the start of a change

/// Returns the earlier measurements that are tried as the last one before a change: the latest ones, then ever sparser
/// ones.
std::vector<int> startsBefore(int measurement) {
  std::vector<int> starts;
  for (int back = 1; back <= measurement + 1; back = back < kAlikeStarts ? back + 1 : back * 3 / 2 + 1)
    starts.push_back(measurement - back);
  if (starts.empty() || starts.back() != -1) starts.push_back(-1);
  return starts;
}

/// Returns the unknowns of base and parameters, whose variables are all 0 at the watched arm.
std::vector<Unknown> unknownsOf(const WatchedArm& watched, PlacedArm& placed) {
  placed = {watched.arm, {{"", watched.X_WB, false}}};
  FreeChoice base_alone{{}, true, {}};
  std::vector<Unknown> unknowns = chooseUnknowns(placed, base_alone).list;
  for (const Unknown& number : watched.uncertainty.numbers)
    unknowns.push_back(rebased(number, deflection::locate(placed.arm, number.path)));
  return unknowns;
}

/// Returns a matrix L with L L^T = P, with one column for each direction that is uncertain at all.
MatrixXd rootOf(const MatrixXd& P) {
  const VectorXd scale = P.diagonal().cwiseMax(0).cwiseSqrt();
  const VectorXd inverse = (scale.array() > 0).select(scale.cwiseInverse(), VectorXd::Zero(scale.size()));
  const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(inverse.asDiagonal() * P * inverse.asDiagonal());
  const Index first = (axes.eigenvalues().array() < kUndetermined).count();
  const Index count = P.rows() - first;
  return scale.asDiagonal() * axes.eigenvectors().rightCols(count) *
         axes.eigenvalues().tail(count).cwiseSqrt().asDiagonal();
}

/// Whitens each measurement by its own covariance. Encoder noise that measurements at the same joint values share is
/// then counted as if it were independent, because a watch must not mix a measurement with later ones.
void whitenOneByOne(MeasurementWeights& weights) {
  weights.shared.clear();
  for (std::size_t k = 0; k < weights.whitener.size(); ++k) {
    const MatrixXd covariance = weights.covariance(k);
    weights.whitener[k] = covariance.llt().matrixL().solve(MatrixXd::Identity(covariance.rows(), covariance.cols()));
  }
}

/// Sums over the measurements up to one of them; z are the uncertain directions, of unit prior variance, and J the
/// derivatives with respect to a step of the base.
struct Sums {
  MatrixXd zz, zj;
  Matrix6 jj = Matrix6::Zero();
  VectorXd ze;
  Eigen::Matrix<double, 6, 1> je = Eigen::Matrix<double, 6, 1>::Zero();
  double ee = 0;
  int rows = 0;
  double innovations = 0;  ///< sum of squared innovations

  explicit Sums(Index directions)
      : zz(MatrixXd::Zero(directions, directions)), zj(MatrixXd::Zero(directions, 6)), ze(VectorXd::Zero(directions)) {}

  void add(const MatrixXd& H, const MatrixXd& J, const VectorXd& e) {
    zz += H.transpose() * H;
    zj += H.transpose() * J;
    jj += J.transpose() * J;
    ze += H.transpose() * e;
    je += J.transpose() * e;
    ee += e.squaredNorm();
    rows += static_cast<int>(e.size());
  }
};

/// A statistic with its degrees of freedom, and the step of the base that it belongs to.
struct Statistic {
  double chi2 = 0;
  int degrees_of_freedom = 0;
  BaseStep step = BaseStep::Zero(), sigma = BaseStep::Zero();
};

class ChangeWatch {
 public:
  ChangeWatch(const MatrixXd& H, const MatrixXd& J, const VectorXd& e, const std::vector<int>& first_row)
      : H_(H), J_(J), e_(e), first_row_(first_row) {}

  Watch watch(const WatchOptions& options) {
    const int count = static_cast<int>(first_row_.size()), planned = std::max(count, options.planned);
    const double tests = 2. * planned * static_cast<double>(startsBefore(planned).size());
    tail_ = options.false_alarms / tests;
    Watch result;
    result.status = WatchStatus::kQuiet;
    sums_.emplace_back(H_.cols());
    for (int k = 0; k < count && !result.alarm; ++k) {
      if (shouldStop(options.stop)) {
        result.status = WatchStatus::kStopped;
        return result;
      }
      addMeasurement(k);
      result.level.push_back(testAfter(k, result.alarm));
      ++result.tested;
    }
    if (!result.alarm) return result;
    result.status = WatchStatus::kAlarm;
    for (int k = result.alarm->measurement + 1; k < std::min(count, result.alarm->measurement + kMeasurementsToJudge);
         ++k)
      addMeasurement(k);
    judge(*result.alarm);
    return result;
  }

 private:
  void addMeasurement(int k) {
    const Index first = first_row_[static_cast<std::size_t>(k)];
    const bool is_last = k + 1 == static_cast<int>(first_row_.size());
    const Index rows = (is_last ? e_.size() : first_row_[static_cast<std::size_t>(k) + 1]) - first;
    Sums sums = sums_.back();
    sums.add(H_.middleRows(first, rows), J_.middleRows(first, rows), e_.segment(first, rows));
    all_.compute(MatrixXd::Identity(H_.cols(), H_.cols()) + sums.zz);
    sums.innovations = sums.ee - sums.ze.dot(all_.solve(sums.ze));
    sums_.push_back(std::move(sums));
  }

  /// Tests all starts of a change after measurement k; returns the largest statistic as a fraction of its limit.
  double testAfter(int k, std::optional<WatchAlarm>& alarm) {
    const Sums& now = sums_.back();
    const VectorXd estimate = all_.solve(now.ze);
    double largest = 0;
    for (const int start : startsBefore(k)) {
      const Sums& before = sums_[static_cast<std::size_t>(start + 1)];
      const Statistic of_base = baseStep(now, before, estimate);
      const Statistic of_all = innovations(now, before);
      for (const Statistic* statistic : {&of_base, &of_all}) {
        if (statistic->degrees_of_freedom == 0) continue;
        const double level = statistic->chi2 / limit(statistic->degrees_of_freedom);
        if (level <= largest) continue;
        largest = level;
        if (level > 1) alarm = alarmOf(k, start + 1, *statistic);
      }
    }
    return largest;
  }

  static WatchAlarm alarmOf(int measurement, int since, const Statistic& beyond) {
    WatchAlarm alarm;
    alarm.measurement = measurement;
    alarm.since = since;
    alarm.chi2 = beyond.chi2;
    alarm.degrees_of_freedom = beyond.degrees_of_freedom;
    return alarm;
  }

  /// Judges by all measurements since the change, those after the alarm too, whether a step of the base explains them.
  void judge(WatchAlarm& alarm) {
    const Sums &now = sums_.back(), &before = sums_[static_cast<std::size_t>(alarm.since)];
    const Statistic of_base = baseStep(now, before, all_.solve(now.ze));
    const Statistic of_all = innovations(now, before);
    alarm.judged_to = static_cast<int>(sums_.size()) - 2;
    alarm.step = of_base.step;
    alarm.step_sigma = of_base.sigma;
    if (of_all.degrees_of_freedom < of_base.degrees_of_freedom + kLeftToJudge) return;
    alarm.kind = explains(of_base, of_all) ? ChangeKind::kBaseStep : ChangeKind::kOther;
  }

  /// Returns true if what the step of the base leaves of the innovations is no larger than noise (p > 0.001).
  static bool explains(const Statistic& of_base, const Statistic& of_all) {
    const int left = of_all.degrees_of_freedom - of_base.degrees_of_freedom;
    return left <= 0 || of_all.chi2 - of_base.chi2 < chiSquareQuantile(0.001, left);
  }

  /// Returns the sum of squared innovations between two sums, whatever has changed.
  static Statistic innovations(const Sums& now, const Sums& before) {
    return {now.innovations - before.innovations, now.rows - before.rows, {}, {}};
  }

  /// Returns the generalised likelihood ratio of a step of the base between two sums.
  [[nodiscard]] Statistic baseStep(const Sums& now, const Sums& before, const VectorXd& estimate) const {
    const MatrixXd cross = now.zj - before.zj;
    Matrix6 information = now.jj - before.jj - cross.transpose() * all_.solve(cross);
    Eigen::Matrix<double, 6, 1> score = now.je - before.je - cross.transpose() * estimate;
    Eigen::Matrix<double, 6, 1> scale = Eigen::Matrix<double, 6, 1>::Ones();
    scale.tail<3>().setConstant(1 / kTurnLever);
    information = scale.asDiagonal() * information * scale.asDiagonal();
    score = scale.cwiseProduct(score);
    const Eigen::SelfAdjointEigenSolver<Matrix6> axes(information);
    Statistic statistic;
    for (int a = 0; a < 6; ++a) {
      const double value = axes.eigenvalues()[a];
      if (value <= kUndetermined * std::max(1., axes.eigenvalues()[5])) {
        for (int c = 0; c < 6; ++c)
          if (std::abs(axes.eigenvectors()(c, a)) > kPartOfDirection)
            statistic.sigma[c] = std::numeric_limits<double>::infinity();
        continue;
      }
      const double along = axes.eigenvectors().col(a).dot(score);
      statistic.chi2 += along * along / value;
      ++statistic.degrees_of_freedom;
      statistic.step -= along / value * scale.cwiseProduct(axes.eigenvectors().col(a));
      statistic.sigma += scale.cwiseProduct(axes.eigenvectors().col(a)).cwiseAbs2() / value;
    }
    statistic.sigma = statistic.sigma.cwiseSqrt();
    return statistic;
  }

  double limit(int degrees_of_freedom) {
    const auto k = static_cast<std::size_t>(degrees_of_freedom);
    if (limits_.size() <= k) limits_.resize(k + 1, 0);
    if (limits_[k] == 0) limits_[k] = chiSquareQuantile(tail_, degrees_of_freedom);
    return limits_[k];
  }

  const MatrixXd &H_, &J_;
  const VectorXd& e_;
  const std::vector<int>& first_row_;
  std::vector<Sums> sums_;      // sums_[k]: over the first k measurements
  Eigen::LLT<MatrixXd> all_;    // factor of the information on z from all measurements so far
  double tail_ = 0;             // probability with which one statistic exceeds its limit by chance
  std::vector<double> limits_;  // limit for each number of degrees of freedom; 0: not yet computed
};

}  // namespace

Watch watchForChange(const WatchedArm& watched, const std::vector<Measurement>& measurements,
                     const WatchOptions& options) {
  Watch none;
  none.status = WatchStatus::kNotComputed;
  none.reason = "there are no readings";
  if (measurements.empty()) return none;
  PlacedArm placed;
  const std::vector<Unknown> unknowns = unknownsOf(watched, placed);
  auto weights = weighMeasurements(placed, measurements, {}, watched.model_error, options.stop);
  none.reason = "the model cannot be evaluated at the readings";
  if (!weights) return none;
  none.reason = "readings of points or surfaces of unknown place cannot be watched one by one";
  if (!weights->points.empty()) return none;
  whitenOneByOne(*weights);
  const auto residual =
      whitenedResidual(placed, unknowns, measurements, *weights, zerosOf(unknowns), true, options.stop);
  none.reason = "the model cannot be evaluated at the readings";
  if (!residual.ok) return none;
  const MatrixXd H = residual.jacobian * rootOf(watched.uncertainty.covariance), J = residual.jacobian.leftCols<6>();
  return ChangeWatch(H, J, residual.r, weights->first_row).watch(options);
}

}  // namespace tubeplan::calibration
