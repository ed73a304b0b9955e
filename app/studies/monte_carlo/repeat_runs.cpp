#include "app/studies/monte_carlo/repeat_runs.hpp"

#include <cassert>
#include <thread>

#include "app/studies/monte_carlo/group_leader.hpp"
#include "app/studies/monte_carlo/rank_groups.hpp"
#include "app/studies/monte_carlo/run_workers.hpp"

namespace tubeplan::app {

namespace {

// Pauses between checks for messages: longer than a check, shorter than the computation of a chunk.
constexpr std::chrono::microseconds kPause{10000};
constexpr std::chrono::milliseconds kPauseAlone{20};
// Time after which a leader passes on the sum of its group.
constexpr std::chrono::seconds kPassEvery{1};

/// The first rank, which distributes chunks, works on some and adds the tallies.
class Master {
 public:
  Master(Experiment& experiment, RunSchedule& schedule, const RepeatHooks& hooks, Ranks* ranks)
      : experiment_(experiment), schedule_(schedule), hooks_(hooks), ranks_(ranks) {
    if (!ranks_) return;
    wanted_.resize(static_cast<std::size_t>(ranks_->size()), 0);
    senders_ = rankGroups(ranks_->size()).sendersTo(0);
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
        add({{result->runs}, result->tally});
    }
    return RepeatStatus::kDone;
  }

  /// Sends all ranks the request to stop and waits until they have stopped; leaders do so for their groups. Other
  /// messages that arrive meanwhile are dropped.
  void dismiss() {
    if (!ranks_) return;
    for (const int rank : senders_) ranks_->send(rank, kEnd, {});
    for (std::size_t finished = 0; finished < senders_.size();)
      if (const auto message = ranks_->receive()) finished += message->subject == kFinished;
  }

 private:
  void feed(RunWorkers& workers) {
    for (int wanted = workers.wanted(); wanted > 0; --wanted)
      if (const auto runs = schedule_.next()) workers.give(*runs);
    for (const int rank : senders_)
      if (const auto chunks = nextChunks(wanted_[static_cast<std::size_t>(rank)]); !chunks.empty())
        ranks_->send(rank, kRuns, wordsOfChunks(chunks));
  }

  /// Returns the next chunks, as many as are wanted, and subtracts their number from `wanted`.
  std::vector<RunRange> nextChunks(std::uint64_t& wanted) {
    std::vector<RunRange> chunks;
    for (; wanted > 0; --wanted) {
      const auto runs = schedule_.next();
      if (!runs) break;
      chunks.push_back(*runs);
    }
    return chunks;
  }

  bool takeMessages() {
    bool has_news = false;
    while (ranks_) {
      const auto message = ranks_->receive();
      if (!message) break;
      has_news = true;
      if (message->subject == kRequestRuns) wanted_[static_cast<std::size_t>(message->from)] += message->words.at(0);
      if (message->subject == kTally) add(doneIn(message->words));
    }
    return has_news;
  }

  void add(const DoneRuns& done) {
    const bool is_added = experiment_.add(done.tally);
    assert(is_added);
    (void)is_added;
    for (const RunRange& chunk : done.chunks) schedule_.finish(chunk);
    hooks_.progress(schedule_.done().size());
    hooks_.keep(false);
  }

  Experiment& experiment_;
  RunSchedule& schedule_;
  const RepeatHooks& hooks_;
  Ranks* ranks_;
  std::vector<int> senders_;           ///< ranks that send to the first rank
  std::vector<std::uint64_t> wanted_;  ///< number of chunks that each rank is waiting for
};

/// A rank other than the first: works on chunks and, as the leader of a group, adds up the tallies of the group.
class RankServer {
 public:
  RankServer(const Experiment& experiment, Ranks& ranks)
      : experiment_(experiment), ranks_(ranks), receiver_(rankGroups(ranks.size()).receiverOf(ranks.rank())) {
    const RankGroups groups = rankGroups(ranks.size());
    if (!groups.isLeader(ranks.rank())) return;
    std::vector<int> members = groups.sendersTo(ranks.rank());
    members.push_back(ranks.rank());
    leader_.emplace(experiment, ranks.rank(), members);
  }

  void run(int workers_count) {
    work(workers_count);
    sendOwn(kFinished, {});
    while (!has_left_) {
      receive(nullptr);
      std::this_thread::sleep_for(kPause);
    }
  }

 private:
  void work(int workers_count) {
    RunWorkers workers(experiment_, workers_count);
    sendOwn(kRequestRuns, {static_cast<std::uint64_t>(workers.wanted())});
    while (!is_over_) {
      receive(&workers);
      const auto result = workers.take(kPause);
      if (result && !is_over_) {
        sendOwn(kTally, wordsOfDone({{result->runs}, result->tally}));
        sendOwn(kRequestRuns, {1});
      }
      passOn();
    }
  }

  /// Handles all messages that have arrived; `workers` is null once this rank has stopped work.
  void receive(RunWorkers* workers) {
    while (const auto message = ranks_.receive()) {
      const RankMessage taken{message->from, ranks_.rank(), message->subject, message->words};
      if (!leader_)
        deliver(taken, workers);
      else
        for (const auto& next : leader_->take(taken)) deliver(next, workers);
    }
  }

  /// Sends a message, or hands it to this rank's own workers.
  void deliver(const RankMessage& message, RunWorkers* workers) {
    has_left_ = has_left_ || (message.to == receiver_ && message.subject == kFinished);
    if (message.to != ranks_.rank()) return ranks_.send(message.to, message.subject, message.words);
    is_over_ = is_over_ || message.subject == kEnd;
    if (message.subject != kRuns || !workers) return;
    for (const RunRange& chunk : chunksIn(message.words, 0, message.words.size())) workers->give(chunk);
  }

  /// Sends a message of this rank's own workers to the receiver, or to the leader that this rank is.
  void sendOwn(int subject, const TallyWords& words) {
    const RankMessage message{ranks_.rank(), receiver_, subject, words};
    if (!leader_) return deliver(message, nullptr);
    for (const auto& next : leader_->take(message)) deliver(next, nullptr);
  }

  void passOn() {
    const auto now = std::chrono::steady_clock::now();
    if (!leader_ || (!leader_->isIdle() && now - passed_ < kPassEvery)) return;
    for (const auto& message : leader_->pass()) deliver(message, nullptr);
    passed_ = now;
  }

  const Experiment& experiment_;
  Ranks& ranks_;
  int receiver_;
  std::optional<GroupLeader> leader_;
  std::chrono::steady_clock::time_point passed_ = std::chrono::steady_clock::now();
  bool is_over_ = false, has_left_ = false;
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
  RankServer(experiment, ranks).run(workers_count);
}

}  // namespace tubeplan::app
