// Experiment whose runs are counted by one type of tally. An experiment derives from it and performs each run.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
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

  [[nodiscard]] std::optional<TallyWords> run(RunRange runs, const std::function<bool()>& stop) const override {
    Tally tally = empty_;
    for (std::uint64_t run = runs.first; run < runs.end; ++run)
      if (stop() || !count(run, stop, tally)) return std::nullopt;
    return wordsOf(tally);
  }

  [[nodiscard]] bool add(const TallyWords& tally) override { return total_.merge(tally); }

  [[nodiscard]] std::optional<TallyWords> sum(const TallyWords& a, const TallyWords& b) const override {
    Tally tally = empty_;
    if (!tally.merge(a) || !tally.merge(b)) return std::nullopt;
    return wordsOf(tally);
  }

  [[nodiscard]] TallyWords total() const override { return wordsOf(total_); }
  [[nodiscard]] const Tally& tally() const { return total_; }

 private:
  /// Performs a run and counts it in `tally`. Returns false if it was stopped.
  [[nodiscard]] virtual bool count(std::uint64_t run, const std::function<bool()>& stop, Tally& tally) const = 0;

  [[nodiscard]] static TallyWords wordsOf(const Tally& tally) {
    TallyWords words;
    tally.put(words);
    return words;
  }

  Tally empty_, total_;
};

}  // namespace tubeplan::app
