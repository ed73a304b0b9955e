#include "app/studies/monte_carlo/group_leader.hpp"

#include <cassert>

namespace tubeplan::app {

GroupLeader::GroupLeader(const Experiment& experiment, int rank, const std::vector<int>& members)
    : experiment_(experiment), rank_(rank) {
  for (const int member : members) wanted_[member] = 0;
}

std::vector<RankMessage> GroupLeader::take(const RankMessage& message) {
  switch (message.subject) {
    case kRequestRuns:
      wanted_[message.from] += message.words.at(0);
      return {{rank_, 0, kRequestRuns, message.words}};
    case kRuns:
      for (const RunRange& chunk : chunksIn(message.words, 0, message.words.size())) waiting_.push_back(chunk);
      return shareOut();
    case kTally:
      add(doneIn(message.words));
      return {};
    case kEnd:
      return toAll(kEnd);
    default:
      if (++finished_members_ < wanted_.size()) return {};
      return {{rank_, 0, kFinished, {}}};
  }
}

std::vector<RankMessage> GroupLeader::pass() {
  if (done_.chunks.empty()) return {};
  const RankMessage message{rank_, 0, kTally, wordsOfDone(done_)};
  done_ = {};
  return {message};
}

std::vector<RankMessage> GroupLeader::shareOut() {
  std::vector<RankMessage> messages;
  for (auto& [member, wanted] : wanted_) {
    std::vector<RunRange> chunks;
    for (; wanted > 0 && !waiting_.empty(); --wanted) {
      chunks.push_back(waiting_.front());
      waiting_.pop_front();
    }
    under_way_ += chunks.size();
    if (!chunks.empty()) messages.push_back({rank_, member, kRuns, wordsOfChunks(chunks)});
  }
  return messages;
}

std::vector<RankMessage> GroupLeader::toAll(int subject) const {
  std::vector<RankMessage> messages;
  for (const auto& [member, wanted] : wanted_) messages.push_back({rank_, member, subject, {}});
  return messages;
}

void GroupLeader::add(DoneRuns done) {
  under_way_ -= done.chunks.size();
  if (done_.chunks.empty()) {
    done_ = std::move(done);
    return;
  }
  const auto sum = experiment_.sum(done_.tally, done.tally);
  assert(sum);
  done_.tally = *sum;
  done_.chunks.insert(done_.chunks.end(), done.chunks.begin(), done.chunks.end());
}

}  // namespace tubeplan::app
