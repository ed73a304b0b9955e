// Messages between the ranks of a campaign.
#pragma once

#include "app/studies/monte_carlo/experiment.hpp"

namespace tubeplan::app {

/// Subject of a message. The receiver of a rank (rank_groups.hpp) gives it runs and receives its tallies.
enum RankSubject : int {
  kRequestRuns = 1,  ///< to the receiver: number of further chunks of runs wanted
  kRuns,             ///< from the receiver: first and end of each chunk
  kTally,            ///< to the receiver: DoneRuns as words
  kEnd,              ///< from the receiver: stop work and leave
  kFinished,         ///< to the receiver: last message
};

struct RankMessage {
  int from = -1, to = -1;
  int subject = 0;
  TallyWords words;
};

/// Chunks that are done, and the sum of their tallies.
struct DoneRuns {
  std::vector<RunRange> chunks;
  TallyWords tally;
};

[[nodiscard]] inline TallyWords wordsOfChunks(const std::vector<RunRange>& chunks) {
  TallyWords words;
  for (const RunRange& chunk : chunks) words.insert(words.end(), {chunk.first, chunk.end});
  return words;
}

/// Returns the chunks in the words from `first` up to `end`.
[[nodiscard]] inline std::vector<RunRange> chunksIn(const TallyWords& words, std::size_t first, std::size_t end) {
  std::vector<RunRange> chunks;
  for (std::size_t k = first; k + 1 < end; k += 2) chunks.push_back({words.at(k), words.at(k + 1)});
  return chunks;
}

[[nodiscard]] inline TallyWords wordsOfDone(const DoneRuns& done) {
  TallyWords words{done.chunks.size()};
  const TallyWords chunks = wordsOfChunks(done.chunks);
  words.insert(words.end(), chunks.begin(), chunks.end());
  words.insert(words.end(), done.tally.begin(), done.tally.end());
  return words;
}

[[nodiscard]] inline DoneRuns doneIn(const TallyWords& words) {
  const std::size_t end = 1 + 2 * static_cast<std::size_t>(words.at(0));
  return {chunksIn(words, 1, end), TallyWords(words.begin() + static_cast<std::ptrdiff_t>(end), words.end())};
}

}  // namespace tubeplan::app
