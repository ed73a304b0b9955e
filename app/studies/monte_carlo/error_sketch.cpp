#include "app/studies/monte_carlo/error_sketch.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

namespace tubeplan::app {

namespace {

constexpr double kNothingAdded = std::numeric_limits<double>::quiet_NaN();
constexpr int kPartBits = 6;
static_assert(1 << kPartBits == ErrorSketch::kPartsOfOctave);

}  // namespace

std::uint64_t ErrorSketch::unitsOf(double error) {
  assert(error >= 0);
  return static_cast<std::uint64_t>(std::llround(std::min(error, kLargest) / kUnit));
}

// Returns the bin of a number. Numbers below 2^6 have a bin each; for larger numbers the bin is determined by the
// octave and the six bits after the leading bit.
std::uint32_t ErrorSketch::partOf(std::uint64_t units) {
  if (units < kPartsOfOctave) return static_cast<std::uint32_t>(units);
  const int shift = std::bit_width(units) - 1 - kPartBits;
  return static_cast<std::uint32_t>((static_cast<std::uint64_t>(shift) << kPartBits) + (units >> shift));
}

std::uint64_t ErrorSketch::startOf(std::uint32_t part) {
  if (part < 2 * kPartsOfOctave) return part;
  const std::uint32_t shift = part / kPartsOfOctave - 1;
  return static_cast<std::uint64_t>(part - shift * kPartsOfOctave) << shift;
}

void ErrorSketch::makeRoom(std::uint32_t part) {
  if (counts_.empty()) first_part_ = part;
  if (part < first_part_) {
    counts_.insert(counts_.begin(), first_part_ - part, 0);
    first_part_ = part;
  }
  if (part >= first_part_ + counts_.size()) counts_.resize(part - first_part_ + 1, 0);
}

void ErrorSketch::add(std::uint64_t units) {
  const std::uint32_t part = partOf(units);
  makeRoom(part);
  ++counts_[part - first_part_];
  ++count_;
  sum_ += units;
  squares_ += static_cast<WideCount>(units) * units;
  max_ = std::max(max_, units);
}

void ErrorSketch::merge(const ErrorSketch& other) {
  if (other.count_ == 0) return;
  makeRoom(other.first_part_);
  makeRoom(other.first_part_ + static_cast<std::uint32_t>(other.counts_.size()) - 1);
  for (std::size_t k = 0; k < other.counts_.size(); ++k)
    counts_[other.first_part_ - first_part_ + k] += other.counts_[k];
  count_ += other.count_;
  sum_ += other.sum_;
  squares_ += other.squares_;
  max_ = std::max(max_, other.max_);
}

double ErrorSketch::mean() const {
  return count_ ? static_cast<double>(sum_) / static_cast<double>(count_) * kUnit : kNothingAdded;
}

double ErrorSketch::rms() const {
  return count_ ? std::sqrt(static_cast<double>(squares_) / static_cast<double>(count_)) * kUnit : kNothingAdded;
}

double ErrorSketch::sigma() const {
  if (count_ < 2) return kNothingAdded;
  const auto n = static_cast<long double>(count_), sum = static_cast<long double>(sum_);
  const long double spread = static_cast<long double>(squares_) - sum / n * sum;
  return static_cast<double>(std::sqrt(std::max(spread, 0.L) / (n - 1))) * kUnit;
}

double ErrorSketch::max() const { return count_ ? static_cast<double>(max_) * kUnit : kNothingAdded; }

double ErrorSketch::quantile(double share) const {
  assert(share >= 0 && share <= 1);
  if (count_ == 0) return kNothingAdded;
  const double rank = std::max(1., std::ceil(share * static_cast<double>(count_)));
  double below = 0;
  for (std::size_t k = 0; k < counts_.size(); ++k) {
    const auto count = static_cast<double>(counts_[k]);
    if (below + count < rank) {
      below += count;
      continue;
    }
    const std::uint32_t part = first_part_ + static_cast<std::uint32_t>(k);
    const auto start = static_cast<double>(startOf(part)), end = static_cast<double>(startOf(part + 1) - 1);
    const double within = start + (end - start) * (rank - below) / count;
    return std::min(within, static_cast<double>(max_)) * kUnit;
  }
  return max();
}

std::vector<ErrorSketch::Point> ErrorSketch::distribution() const {
  std::vector<Point> points;
  std::uint64_t so_far = 0;
  for (std::size_t k = 0; k < counts_.size(); ++k) {
    if (counts_[k] == 0) continue;
    so_far += counts_[k];
    const std::uint64_t end = startOf(first_part_ + static_cast<std::uint32_t>(k) + 1) - 1;
    points.push_back({static_cast<double>(std::min(end, max_)) * kUnit, so_far});
  }
  return points;
}

void ErrorSketch::put(TallyWords& words) const {
  words.push_back(count_);
  if (count_ == 0) return;
  words.push_back(max_);
  putWide(words, sum_);
  putWide(words, squares_);
  words.push_back(first_part_);
  words.push_back(counts_.size());
  words.insert(words.end(), counts_.begin(), counts_.end());
}

ErrorSketch ErrorSketch::read(WordReader& reader) {
  ErrorSketch sketch;
  sketch.count_ = reader.next();
  if (sketch.count_ == 0) return sketch;
  sketch.max_ = reader.next();
  sketch.sum_ = reader.nextWide();
  sketch.squares_ = reader.nextWide();
  sketch.first_part_ = static_cast<std::uint32_t>(reader.next());
  sketch.counts_.resize(reader.nextSize());
  for (auto& count : sketch.counts_) count = reader.next();
  return sketch;
}

}  // namespace tubeplan::app
