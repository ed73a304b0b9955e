// Processes ("ranks") of a campaign that runs on several machines. Only mpi_ranks.cpp uses MPI; a build without MPI
// compiles no_ranks.cpp instead.
#pragma once

#include <optional>
#include <string>

#include "app/studies/monte_carlo/tally_words.hpp"

namespace tubeplan::app {

/// Returns true if this program was built with MPI, to run on several machines.
[[nodiscard]] bool isBuiltForRanks();

/// Returns true if, according to the environment, a parallel launcher (mpirun, srun) started several copies of this
/// process. Only then is MPI used.
[[nodiscard]] bool areRanksLaunched();

/// Returns the number of launched processes on this machine; 1 if it is unknown.
[[nodiscard]] int ranksOnThisMachine();

/// Communication between the ranks. There is one object for the life of the process, only in a program built with MPI.
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }

  /// Returns the first rank's text on every rank; all ranks must call this function.
  [[nodiscard]] std::string fromFirst(const std::string& text);

  /// Returns true on every rank if `value` is true on all ranks; all ranks must call this function.
  [[nodiscard]] bool isTrueOnAllRanks(bool value);

  struct Message {
    int from = -1;
    int subject = 0;
    TallyWords words;
  };
  void send(int to, int subject, const TallyWords& words);

  /// Returns a message that has arrived, or nothing. Does not wait.
  [[nodiscard]] std::optional<Message> receive();

 private:
  int rank_ = 0, size_ = 1;
};

}  // namespace tubeplan::app
