// The processes of a campaign that runs on several machines. Only mpi_ranks.cpp uses MPI; a build without MPI has
// no_ranks.cpp instead.
#pragma once

#include <optional>
#include <string>

#include "app/studies/monte_carlo/tally_words.hpp"

namespace tubeplan::app {

/// Returns true if this program was built to run on several machines.
[[nodiscard]] bool isBuiltForRanks();

/// Returns true if a launcher of parallel programs (mpirun, srun) started several copies of this process, according to
/// the environment. MPI is used only then.
[[nodiscard]] bool areRanksLaunched();

/// Returns how many of them are on this machine, 1 if that is unknown.
[[nodiscard]] int ranksOnThisMachine();

/// The ranks of this program; one object for the life of the process, in a program built for it.
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }

  /// Returns the text of the first rank on every rank; all must call it.
  [[nodiscard]] std::string fromFirst(const std::string& text);

  /// Returns true if this holds on every rank; all must call it.
  [[nodiscard]] bool holdsEverywhere(bool here);

  struct Message {
    int from = -1;
    int subject = 0;
    TallyWords words;
  };
  void send(int to, int subject, const TallyWords& words);

  /// Returns a message that has arrived, or nothing. It never waits.
  [[nodiscard]] std::optional<Message> receive();

 private:
  int rank_ = 0, size_ = 1;
};

}  // namespace tubeplan::app
