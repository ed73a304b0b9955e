#include "calibration/diagnosis/model_selection/step_time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tubeplan::calibration {

using Eigen::MatrixXd;

namespace {

constexpr std::size_t kMostTimes = 12;  // tried at once

/// Middles of the gaps between the readings' times, from one time to another.
std::vector<double> gapsBetween(const std::vector<Measurement>& readings, double from, double to) {
  std::vector<double> times;
  for (const auto& reading : readings)
    if (reading.conditions.states(Condition::kTime)) times.push_back(reading.conditions[Condition::kTime]);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::vector<double> gaps;
  for (std::size_t k = 0; k + 1 < times.size(); ++k)
    if (const double time = (times[k] + times[k + 1]) / 2; time >= from && time <= to) gaps.push_back(time);
  return gaps;
}

/// Of these times of a step the one that lowers chi-square most.
std::size_t bestTime(const DiagnosisWork& work, Cause cause, const ModelTerm& term, const std::vector<double>& times) {
  cause.levels = times;
  const Signatures signatures(work.basis.fitted, {cause});
  EvidenceGram gram;
  const MatrixXd S = signatures.columnsAt(work.basis.readings, work.basis.weights, work.basis.stop);
  if (S.rows() != work.basis.residual.r.size()) return times.size() / 2;
  gram.add(work.basis.residual.jacobian, S, MatrixXd(S.rows(), 0), -work.basis.residual.r);
  const LinearEvidence evidence(gram, work.basis.unknowns, {});
  std::size_t best = 0;
  double most = -1;
  for (std::size_t k = 0; k < times.size(); ++k) {
    std::vector<int> columns;
    for (const int number : term.numbers)
      columns.push_back(signatures.columnsOf(0, static_cast<int>(k))[static_cast<std::size_t>(number)]);
    if (const double fall = evidence.fall(columns); fall > most) most = fall, best = k;
  }
  return best;
}

}  // namespace

double refinedTime(const DiagnosisWork& work, const CompetingModel& model, std::size_t index) {
  const ModelTerm& term = model.terms[index];
  const Cause& cause = work.cause(term.cause);
  const auto& levels = cause.levels;
  const auto level = static_cast<std::size_t>(term.level);
  const double from = level > 0 ? levels[level - 1] : -std::numeric_limits<double>::infinity();
  const double to = level + 1 < levels.size() ? levels[level + 1] : std::numeric_limits<double>::infinity();
  std::vector<double> gaps = gapsBetween(work.basis.readings, from, to);
  while (gaps.size() > kMostTimes) {
    const std::size_t step = gaps.size() / kMostTimes + 1;
    std::vector<double> some;
    for (std::size_t k = 0; k < gaps.size(); k += step) some.push_back(gaps[k]);
    const std::size_t best = bestTime(work, cause, term, some) * step;
    const std::size_t first = best > step ? best - step : 0, last = std::min(gaps.size() - 1, best + step);
    gaps = std::vector<double>(gaps.begin() + static_cast<std::ptrdiff_t>(first),
                               gaps.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  }
  return gaps.size() < 2 ? levels[level] : gaps[bestTime(work, cause, term, gaps)];
}

}  // namespace tubeplan::calibration
