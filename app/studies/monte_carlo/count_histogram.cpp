#include "app/studies/monte_carlo/count_histogram.hpp"

#include <limits>
#include <numeric>

namespace tubeplan::app {

void CountHistogram::add(std::size_t value) {
  if (counts_.size() <= value) counts_.resize(value + 1, 0);
  ++counts_[value];
}

void CountHistogram::merge(const CountHistogram& other) {
  if (counts_.size() < other.counts_.size()) counts_.resize(other.counts_.size(), 0);
  for (std::size_t value = 0; value < other.counts_.size(); ++value) counts_[value] += other.counts_[value];
}

std::uint64_t CountHistogram::count() const {
  return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
}

double CountHistogram::mean() const {
  std::uint64_t sum = 0;
  for (std::size_t value = 0; value < counts_.size(); ++value) sum += value * counts_[value];
  return static_cast<double>(sum) / static_cast<double>(count());
}

double CountHistogram::quantile(double share) const {
  const double least = share * static_cast<double>(count());
  std::uint64_t sum = 0;
  for (std::size_t value = 0; value < counts_.size(); ++value) {
    sum += counts_[value];
    if (sum > 0 && static_cast<double>(sum) >= least) return static_cast<double>(value);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

void CountHistogram::put(TallyWords& words) const {
  words.push_back(counts_.size());
  words.insert(words.end(), counts_.begin(), counts_.end());
}

CountHistogram CountHistogram::read(WordReader& reader) {
  CountHistogram read;
  read.counts_.resize(reader.nextSize());
  for (auto& count : read.counts_) count = reader.next();
  return read;
}

}  // namespace tubeplan::app
