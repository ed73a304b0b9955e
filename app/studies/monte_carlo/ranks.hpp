// The other processes of a campaign that runs on several machines. The one place that knows MPI is mpi_ranks.cpp; built
// without it, no_ranks.cpp stands in.
#pragma once

#include <optional>
#include <string>

#include "app/studies/monte_carlo/tally_words.hpp"

namespace tubeplan::app {

/// Whether this program was built to run on several machines.
[[nodiscard]] bool isBuiltForRanks();

/// Whether a starter of parallel programs (mpirun, srun) started several of this process, by what it leaves in the
/// environment. Nothing of MPI is touched unless this says so.
[[nodiscard]] bool areRanksLaunched();

/// How many of them are on this machine, 1 where that is not known.
[[nodiscard]] int ranksOnThisMachine();

/// One for the life of the process, in a program built for it.
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }

  /// What the first rank says, on every rank; all must ask.
  [[nodiscard]] std::string fromFirst(const std::string& text);

  /// Whether this holds on every rank; all must ask.
  [[nodiscard]] bool holdsEverywhere(bool here);

  struct Message {
    int from = -1;
    int subject = 0;
    TallyWords words;
  };
  void send(int to, int subject, const TallyWords& words);

  /// A message that has come; nothing where there is none. Never waits for one.
  [[nodiscard]] std::optional<Message> receive();

 private:
  int rank_ = 0, size_ = 1;
};

}  // namespace tubeplan::app
