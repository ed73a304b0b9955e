#include "app/studies/monte_carlo/confidence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tubeplan::app {

namespace {
constexpr double kNoCase = std::numeric_limits<double>::quiet_NaN();
}

Probability wilsonInterval(double count, double of) {
  if (!(of > 0)) return {kNoCase, 0, 1};
  const double share = count / of, z2 = kTwoSided95 * kTwoSided95;
  const double middle = (share + z2 / (2 * of)) / (1 + z2 / of);
  const double half = kTwoSided95 / (1 + z2 / of) * std::sqrt(share * (1 - share) / of + z2 / (4 * of * of));
  // Clamp, so that rounding cannot exclude the value itself at 0 or 1.
  return {share, std::clamp(middle - half, 0., share), std::clamp(middle + half, share, 1.)};
}

void RunSums::add(std::uint64_t sum, std::uint64_t count) {
  ++runs_;
  count_ += count;
  squared_counts_ += count * count;
  sum_ += sum;
  squares_ += static_cast<WideCount>(sum) * sum;
  products_ += static_cast<WideCount>(sum) * count;
}

void RunSums::merge(const RunSums& other) {
  runs_ += other.runs_;
  count_ += other.count_;
  squared_counts_ += other.squared_counts_;
  sum_ += other.sum_;
  squares_ += other.squares_;
  products_ += other.products_;
}

double RunSums::mean() const { return count_ ? static_cast<double>(sum_) / static_cast<double>(count_) : kNoCase; }

double RunSums::standardError() const {
  if (runs_ < 2 || count_ == 0) return kNoCase;
  const auto runs = static_cast<long double>(runs_), count = static_cast<long double>(count_);
  const long double mean = static_cast<long double>(sum_) / count;
  const long double spread = static_cast<long double>(squares_) - 2 * mean * static_cast<long double>(products_) +
                             mean * mean * static_cast<long double>(squared_counts_);
  return static_cast<double>(std::sqrt(std::max(spread, 0.L) * runs / (runs - 1)) / count);
}

Probability RunSums::probability() const {
  if (count_ == 0) return {kNoCase, 0, 1};
  const double share = mean(), error = standardError();
  const double cases = error > 0 ? std::min(share * (1 - share) / (error * error), static_cast<double>(count_))
                                 : static_cast<double>(runs_);
  return wilsonInterval(share * cases, cases);
}

void RunSums::put(TallyWords& words) const {
  words.insert(words.end(), {runs_, count_, squared_counts_});
  putWide(words, sum_);
  putWide(words, squares_);
  putWide(words, products_);
}

RunSums RunSums::read(WordReader& reader) {
  RunSums sums;
  sums.runs_ = reader.next();
  sums.count_ = reader.next();
  sums.squared_counts_ = reader.next();
  sums.sum_ = reader.nextWide();
  sums.squares_ = reader.nextWide();
  sums.products_ = reader.nextWide();
  return sums;
}

}  // namespace tubeplan::app
