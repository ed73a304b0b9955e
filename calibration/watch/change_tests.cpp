#include "calibration/watch/change_tests.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kUninformed = 1e-9;   // information, relative to the largest, below which a direction is undetermined
constexpr int kAlikeStarts = 4;        // number of latest measurements of which each is tried as the start of a change
constexpr double kSameWay = 1 - 1e-8;  // cosine above which two columns count as one direction
constexpr double kBeyondRounding = 1 + 1e-9;  // ratio above which two levels differ by more than rounding
constexpr Index kNumbersOfBase = 6;           // largest number of numbers of a candidate

/// Returns the generalised likelihood ratio of numbers with this information and score, and their count as far as they
/// are determined.
std::pair<double, int> likelihoodRatio(const MatrixXd& information, const VectorXd& score) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(information);
  const double least = kUninformed * std::max(1., axes.eigenvalues().tail<1>()[0]);
  double chi2 = 0;
  int count = 0;
  for (Index a = 0; a < score.size(); ++a) {
    if (axes.eigenvalues()[a] <= least) continue;
    const double along = axes.eigenvectors().col(a).dot(score);
    chi2 += along * along / axes.eigenvalues()[a];
    ++count;
  }
  return {chi2, count};
}

}  // namespace

std::vector<int> startsBefore(int measurement) {
  std::vector<int> starts;
  for (int back = 1; back <= measurement + 1; back = back < kAlikeStarts ? back + 1 : back * 3 / 2 + 1)
    starts.push_back(measurement - back);
  if (starts.empty() || starts.back() != -1) starts.push_back(-1);
  return starts;
}

MeasuredTests::MeasuredTests(const RowsAndCandidates& watched, double share, int planned)
    : watched_(watched), innovation_limit_(share / (planned * static_cast<double>(startsBefore(planned).size()))) {
  findDirections(share, planned * static_cast<int>(startsBefore(planned).size()));
  const Index n = watched.rows.H.cols(), c = watched.rows.changes.cols();
  sums_.push_back({MatrixXd::Zero(n, n), MatrixXd::Zero(n, c), MatrixXd::Zero(c, kNumbersOfBase), VectorXd::Zero(n),
                   VectorXd::Zero(c)});
}

/// Groups one-number candidates with parallel columns; each candidate with several numbers is a separate direction.
/// False alarms are allotted to the limits by prior probability, separately for the base and for all other candidates.
void MeasuredTests::findDirections(double share, int tests) {
  const auto& list = watched_.candidates.list;
  MatrixXd measured = watched_.rows.changes;
  for (int k = 0; k < watched_.rows.count(); ++k)
    if (watched_.rows.isCounted(k)) measured.middleRows(watched_.rows.first(k), watched_.rows.rowsOf(k)).setZero();
  measured.colwise().normalize();
  for (const CandidateChange& candidate : list) {
    const auto isSame = [&](const Direction& d) {
      return d.columns.size() == 1 && candidate.columns.size() == 1 &&
             std::abs(measured.col(d.columns[0]).dot(measured.col(candidate.columns[0]))) > kSameWay;
    };
    const auto same = std::ranges::find_if(directions_, isSame);
    if (same == directions_.end())
      directions_.push_back({candidate.columns, candidate.prior});
    else
      same->prior += candidate.prior;
  }
  const double others = 1 - directions_.front().prior;
  for (std::size_t d = 0; d < directions_.size(); ++d)
    directions_[d].limit = ChiSquareLimit(share * (d == 0 ? 1 : directions_[d].prior / others) / tests);
}

void MeasuredTests::take(int k) {
  const WatchedRows& rows = watched_.rows;
  Sums sums = sums_.back();
  if (!rows.isCounted(k)) {
    const auto H = rows.H.middleRows(rows.first(k), rows.rowsOf(k));
    const auto C = rows.changes.middleRows(rows.first(k), rows.rowsOf(k));
    const auto e = rows.r.segment(rows.first(k), rows.rowsOf(k));
    sums.zz += H.transpose() * H;
    sums.zc += H.transpose() * C;
    sums.ze += H.transpose() * e;
    sums.ce += C.transpose() * e;
    for (const Direction& direction : directions_)
      for (const int i : direction.columns)
        for (std::size_t j = 0; j < direction.columns.size(); ++j)
          sums.cc(i, static_cast<Index>(j)) += C.col(i).dot(C.col(direction.columns[j]));
    sums.ee += e.squaredNorm();
    sums.rows += static_cast<int>(e.size());
  }
  all_.compute(MatrixXd::Identity(rows.H.cols(), rows.H.cols()) + sums.zz);
  sums.innovations = sums.ee - sums.ze.dot(all_.solve(sums.ze));
  sums_.push_back(std::move(sums));
}

TestedLevel MeasuredTests::add(int k) {
  take(k);
  TestedLevel nearest;
  if (watched_.rows.isCounted(k)) return nearest;
  for (const int before : startsBefore(k)) testStart(before + 1, nearest);
  return nearest;
}

void MeasuredTests::testStart(int start, TestedLevel& nearest) {
  const Sums &now = sums_.back(), &before = sums_[static_cast<std::size_t>(start)];
  const int rows = now.rows - before.rows;
  if (rows == 0) return;
  const double innovations = now.innovations - before.innovations;
  if (const double level = innovations / innovation_limit_(rows); level > kBeyondRounding * nearest.level)
    nearest = {"innovations", level, start, innovations, rows};
  cross_ = now.zc - before.zc;
  solved_ = all_.solve(cross_);
  score_ = now.ce - before.ce - cross_.transpose() * all_.solve(now.ze);
  for (std::size_t d = 0; d < directions_.size(); ++d)
    testDirection(directions_[d], d == 0 ? kBaseMoved : "candidates", start, nearest);
}

void MeasuredTests::testDirection(Direction& direction, const char* test, int start, TestedLevel& nearest) {
  const auto count = static_cast<Index>(direction.columns.size());
  MatrixXd information(count, count);
  VectorXd score(count);
  for (Index i = 0; i < count; ++i) {
    const int column = direction.columns[static_cast<std::size_t>(i)];
    score[i] = score_[column];
    for (Index j = 0; j < count; ++j)
      information(i, j) = sums_.back().cc(column, j) - sums_[static_cast<std::size_t>(start)].cc(column, j) -
                          cross_.col(column).dot(solved_.col(direction.columns[static_cast<std::size_t>(j)]));
  }
  double chi2 = 0;
  int determined = 0;
  if (count == 1) {
    determined = information(0, 0) > kUninformed * std::max(1., sums_.back().cc(direction.columns[0], 0));
    if (determined > 0) chi2 = score[0] * score[0] / information(0, 0);
  } else {
    std::tie(chi2, determined) = likelihoodRatio(information, score);
  }
  if (determined == 0) return;
  if (const double level = chi2 / direction.limit(determined); level > kBeyondRounding * nearest.level)
    nearest = {test, level, start, chi2, determined};
}

}  // namespace tubeplan::calibration
