#include "app/studies/monte_carlo/repeat_runs.hpp"

#include <cassert>

#include "app/studies/monte_carlo/run_workers.hpp"

namespace tubeplan::app {

namespace {

/// Subjects of the messages between ranks. The first rank distributes chunks of runs; the other ranks are workers.
enum Subject {
  kWant = 1,  ///< to the first rank: number of further chunks wanted
  kRuns,      ///< to a worker rank: first and end of a chunk
  kTally,     ///< to the first rank: first and end of a chunk, then its tally
  kEnd,       ///< to a worker rank: stop work and leave
  kLeft,      ///< to the first rank: last message of a worker rank
};

// Pauses between checks for messages: longer than a check, shorter than the computation of a chunk.
constexpr std::chrono::microseconds kPause{10000};
constexpr std::chrono::milliseconds kPauseAlone{20};

/// The first rank, which distributes chunks, works on some and adds the tallies.
class Master {
 public:
  Master(Experiment& experiment, RunSchedule& schedule, const RepeatHooks& hooks, Ranks* ranks)
      : experiment_(experiment), schedule_(schedule), hooks_(hooks), ranks_(ranks) {
    if (ranks_) wanted_.resize(static_cast<std::size_t>(ranks_->size()), 0);
  }

  RepeatStatus run(int workers_count) {
    RunWorkers workers(experiment_, workers_count);
    hooks_.progress(schedule_.done().size());
    while (!schedule_.isComplete()) {
      if (hooks_.stop()) {
        hooks_.keep(true);
        return RepeatStatus::kStopped;
      }
      feed(workers);
      const bool has_news = takeMessages();
      const auto pause = ranks_ ? kPause : std::chrono::duration_cast<std::chrono::microseconds>(kPauseAlone);
      if (const auto result = workers.take(has_news ? std::chrono::microseconds(0) : pause))
        add(result->runs, result->tally);
    }
    return RepeatStatus::kDone;
  }

  /// Sends all ranks the request to stop and waits until they have stopped. Other messages that arrive meanwhile are
  /// dropped.
  void dismiss() {
    if (!ranks_) return;
    for (int rank = 1; rank < ranks_->size(); ++rank) ranks_->send(rank, kEnd, {});
    for (int left = 0; left < ranks_->size() - 1;)
      if (const auto message = ranks_->receive()) left += message->subject == kLeft;
  }

 private:
  void feed(RunWorkers& workers) {
    for (int wanted = workers.wanted(); wanted > 0; --wanted)
      if (const auto runs = schedule_.next()) workers.give(*runs);
    for (std::size_t rank = 1; rank < wanted_.size(); ++rank)
      for (; wanted_[rank] > 0; --wanted_[rank]) {
        const auto runs = schedule_.next();
        if (!runs) return;
        ranks_->send(static_cast<int>(rank), kRuns, {runs->first, runs->end});
      }
  }

  bool takeMessages() {
    bool has_news = false;
    while (ranks_) {
      auto message = ranks_->receive();
      if (!message) break;
      has_news = true;
      auto& words = message->words;
      if (message->subject == kWant) wanted_[static_cast<std::size_t>(message->from)] += static_cast<int>(words.at(0));
      if (message->subject != kTally) continue;
      const RunRange runs{words.at(0), words.at(1)};
      words.erase(words.begin(), words.begin() + 2);
      ++wanted_[static_cast<std::size_t>(message->from)];
      add(runs, words);
    }
    return has_news;
  }

  void add(RunRange runs, const TallyWords& tally) {
    const bool is_added = experiment_.add(tally);
    assert(is_added);
    (void)is_added;
    schedule_.finish(runs);
    hooks_.progress(schedule_.done().size());
    hooks_.keep(false);
  }

  Experiment& experiment_;
  RunSchedule& schedule_;
  const RepeatHooks& hooks_;
  Ranks* ranks_;
  std::vector<int> wanted_;  ///< number of chunks that each rank is waiting for
};

}  // namespace

RepeatStatus repeatRuns(Experiment& experiment, RunSchedule& schedule, int workers, const RepeatHooks& hooks,
                        Ranks* ranks) {
  Master master(experiment, schedule, hooks, ranks);
  const RepeatStatus status = master.run(workers);
  master.dismiss();
  return status;
}

void serveRuns(const Experiment& experiment, int workers_count, Ranks& ranks) {
  {
    RunWorkers workers(experiment, workers_count);
    ranks.send(0, kWant, {static_cast<std::uint64_t>(workers.wanted())});
    for (bool is_over = false; !is_over;) {
      while (const auto message = ranks.receive()) {
        if (message->subject == kRuns) workers.give({message->words.at(0), message->words.at(1)});
        is_over = is_over || message->subject == kEnd;
      }
      const auto result = workers.take(kPause);
      if (!result || is_over) continue;
      TallyWords words{result->runs.first, result->runs.end};
      words.insert(words.end(), result->tally.begin(), result->tally.end());
      ranks.send(0, kTally, words);
    }
  }
  ranks.send(0, kLeft, {});
}

}  // namespace tubeplan::app
