// Experiment whose runs are counted by one type of tally. An experiment derives from it and performs the runs.
#pragma once

#include <utility>

#include "app/studies/monte_carlo/experiment.hpp"

namespace tubeplan::app {

/// `Tally` has `void put(TallyWords&) const` and `bool merge(const TallyWords&)`, which returns false for words of
/// another experiment.
template <class Tally>
class TallyExperiment : public Experiment {
 public:
  /// `empty` is the tally of no runs.
  explicit TallyExperiment(Tally empty) : empty_(empty), total_(std::move(empty)) {}

  [[nodiscard]] bool add(const TallyWords& tally) override { return total_.merge(tally); }

  [[nodiscard]] std::optional<TallyWords> sum(const TallyWords& a, const TallyWords& b) const override {
    Tally tally = empty_;
    if (!tally.merge(a) || !tally.merge(b)) return std::nullopt;
    return wordsOf(tally);
  }

  [[nodiscard]] TallyWords total() const override { return wordsOf(total_); }
  [[nodiscard]] const Tally& tally() const { return total_; }

 protected:
  [[nodiscard]] const Tally& empty() const { return empty_; }

  [[nodiscard]] static TallyWords wordsOf(const Tally& tally) {
    TallyWords words;
    tally.put(words);
    return words;
  }

 private:
  Tally empty_, total_;
};

}  // namespace tubeplan::app
