// Groups of ranks by a simulated flow of messages: every run is counted once and the sum is the same for any grouping,
// and the first rank receives few messages.
#include "app/studies/monte_carlo/rank_groups.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <memory>

#include "app/studies/monte_carlo/group_leader.hpp"
#include "app/studies/monte_carlo/outage_tally.hpp"
#include "app/studies/monte_carlo/run_schedule.hpp"
#include "calibration/random_stream.hpp"

namespace tubeplan::app {
namespace {

/// Outages whose results depend on their index alone, without any arm.
class IndexedOutages : public Experiment {
 public:
  std::optional<TallyWords> run(RunRange runs, const std::function<bool()>&) const override {
    OutageTally tally;
    for (std::uint64_t run = runs.first; run < runs.end; ++run) {
      OutageTrial trial;
      trial.is_watched = run % 7 != 3;
      trial.change = static_cast<int>(run % calibration::hiddenChanges().size());
      trial.is_alarm = run % 3 == 0;
      trial.delay = run % 11;
      trial.after = {20, run % 20};
      tally.add(trial, run);
    }
    return wordsOfTally(tally);
  }
  bool add(const TallyWords& tally) override { return total_.merge(tally); }
  std::optional<TallyWords> sum(const TallyWords& a, const TallyWords& b) const override {
    OutageTally tally;
    if (!tally.merge(a) || !tally.merge(b)) return std::nullopt;
    return wordsOfTally(tally);
  }
  TallyWords total() const override { return wordsOfTally(total_); }

 private:
  static TallyWords wordsOfTally(const OutageTally& tally) {
    TallyWords words;
    tally.put(words);
    return words;
  }
  OutageTally total_;
};

constexpr std::uint64_t kOutages = 3000, kChunk = 7;

/// All ranks of a campaign in one thread. A random message that is under way arrives next; messages between two ranks
/// keep their order.
class SimulatedRanks {
 public:
  SimulatedRanks(const RankGroups& groups, std::uint64_t seed)
      : groups_(groups), random_(seed), schedule_(kOutages, kChunk) {
    for (int rank = 1; rank < groups.ranks; ++rank) {
      if (!groups.isLeader(rank)) continue;
      auto members = groups.sendersTo(rank);
      members.push_back(rank);
      leaders_[rank] = std::make_unique<GroupLeader>(experiment_, rank, members);
    }
    for (int rank = 1; rank < groups.ranks; ++rank) sendOwn(rank, kRequestRuns, {2});
  }

  void run() {
    while (!schedule_.isComplete()) {
      ASSERT_TRUE(deliverOne() || passOn()) << "no message is under way, but runs are missing";
      if (random_.index(200) == 0) passOn();
    }
    for (const int rank : groups_.sendersTo(0)) send({0, rank, kEnd, {}});
    while (deliverOne()) continue;
  }

  [[nodiscard]] TallyWords total() const { return experiment_.total(); }
  [[nodiscard]] std::size_t talliesToFirst() const { return tallies_to_first_; }
  /// Returns the number of ranks whose last message the first rank has received.
  [[nodiscard]] std::size_t finishedSenders() const { return finished_senders_; }

 private:
  void send(const RankMessage& message) { under_way_[{message.from, message.to}].push_back(message); }

  /// Sends a message of a rank's own workers; a leader takes it itself.
  void sendOwn(int rank, int subject, const TallyWords& words) {
    const RankMessage message{rank, groups_.receiverOf(rank), subject, words};
    if (!leaders_.contains(rank)) return send(message);
    for (const auto& next : leaders_[rank]->take(message)) handOn(next);
  }

  void handOn(const RankMessage& message) {
    if (leaders_.contains(message.to) && message.from == message.to)
      takeOwn(message);
    else
      send(message);
  }

  bool passOn() {
    bool is_any = false;
    for (auto& [rank, leader] : leaders_)
      for (const auto& message : leader->pass()) {
        send(message);
        is_any = true;
      }
    return is_any;
  }

  bool deliverOne() {
    if (under_way_.empty()) return false;
    auto chosen = under_way_.begin();
    std::advance(chosen, random_.index(static_cast<int>(under_way_.size())));
    const RankMessage message = chosen->second.front();
    chosen->second.pop_front();
    if (chosen->second.empty()) under_way_.erase(chosen);
    if (message.to == 0)
      takeFirst(message);
    else if (leaders_.contains(message.to))
      for (const auto& next : leaders_[message.to]->take(message)) handOn(next);
    else
      takeOwn(message);
    return true;
  }

  void takeFirst(const RankMessage& message) {
    finished_senders_ += message.subject == kFinished;
    if (message.subject == kTally) {
      ++tallies_to_first_;
      const DoneRuns done = doneIn(message.words);
      EXPECT_TRUE(experiment_.add(done.tally));
      for (const RunRange& chunk : done.chunks) schedule_.finish(chunk);
    }
    if (message.subject != kRequestRuns) return;
    std::vector<RunRange> chunks;
    for (std::uint64_t k = 0; k < message.words.at(0); ++k)
      if (const auto chunk = schedule_.next()) chunks.push_back(*chunk);
    if (!chunks.empty()) send({0, message.from, kRuns, wordsOfChunks(chunks)});
  }

  /// Workers of a rank: they finish chunks at once, or leave.
  void takeOwn(const RankMessage& message) {
    if (message.subject == kEnd) return sendOwn(message.to, kFinished, {});
    for (const RunRange& chunk : chunksIn(message.words, 0, message.words.size())) {
      sendOwn(message.to, kTally, wordsOfDone({{chunk}, *experiment_.run(chunk, [] { return false; })}));
      sendOwn(message.to, kRequestRuns, {1});
    }
  }

  RankGroups groups_;
  calibration::RandomStream random_;
  IndexedOutages experiment_;
  RunSchedule schedule_;
  std::map<int, std::unique_ptr<GroupLeader>> leaders_;
  std::map<std::pair<int, int>, std::deque<RankMessage>> under_way_;
  std::size_t tallies_to_first_ = 0, finished_senders_ = 0;
};

TallyWords sumInOneProcess() {
  return *IndexedOutages().run({0, kOutages}, [] { return false; });
}

TEST(RankGroups, SendEveryRankToOneLeaderAndLeadersToTheFirst) {
  for (const int ranks : {1, 2, 9, 10, 64, 65, 10'000}) {
    const RankGroups groups = rankGroups(ranks, 9);
    std::size_t senders = 0;
    for (int rank = 0; rank < std::min(ranks, 200); ++rank) {
      EXPECT_TRUE(groups.isLeader(groups.receiverOf(rank)));
      EXPECT_EQ(groups.receiverOf(groups.receiverOf(rank)), 0);
    }
    senders = groups.sendersTo(0).size();
    EXPECT_LE(senders, ranks <= 9 ? ranks - 1 : static_cast<int>(2 * std::sqrt(ranks)) + 1);
  }
}

TEST(RankGroups, AreOneForFewRanks) {
  EXPECT_EQ(rankGroups(kMostRanksOfOneGroup).size, kMostRanksOfOneGroup);
  EXPECT_EQ(rankGroups(kMostRanksOfOneGroup + 1).size, 9);
  EXPECT_EQ(rankGroups(10'000).size, 100);
}

TEST(GroupLeader, TheSumIsTheSameForAnyGroupingAndOrder) {
  const TallyWords sum = sumInOneProcess();
  for (const int ranks : {2, 3, 7, 30})
    for (const int size : {1, 2, 4, 6, ranks})
      for (const std::uint64_t seed : {1, 2, 3}) {
        SimulatedRanks simulated({ranks, size}, seed);
        simulated.run();
        EXPECT_EQ(simulated.total(), sum) << ranks << " ranks in groups of " << size << ", seed " << seed;
        EXPECT_EQ(simulated.finishedSenders(), RankGroups({ranks, size}).sendersTo(0).size());
      }
}

TEST(GroupLeader, SendsFewerTalliesToTheFirstRank) {
  SimulatedRanks flat({36, 36}, 1), grouped({36, 6}, 1);
  flat.run();
  grouped.run();
  EXPECT_EQ(flat.talliesToFirst(), (kOutages + kChunk - 1) / kChunk);
  EXPECT_LT(2 * grouped.talliesToFirst(), flat.talliesToFirst());
}

TEST(GroupLeader, PassesNothingWithoutATally) {
  IndexedOutages outages;
  GroupLeader leader(outages, 4, {4, 5});
  EXPECT_TRUE(leader.pass().empty());
  EXPECT_TRUE(leader.isIdle());
  (void)leader.take({5, 4, kRequestRuns, {1}});
  const auto given = leader.take({0, 4, kRuns, {0, 7}});
  ASSERT_EQ(given.size(), 1u);
  EXPECT_EQ(given.front().to, 5);
  EXPECT_FALSE(leader.isIdle());
  EXPECT_TRUE(leader.pass().empty());
}

}  // namespace
}  // namespace tubeplan::app
