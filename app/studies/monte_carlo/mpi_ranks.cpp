// Implementation of Ranks with MPI; the only file that uses MPI.
#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include "app/studies/monte_carlo/ranks.hpp"

namespace tubeplan::app {

bool isBuiltForRanks() { return true; }

Ranks::Ranks() {
  int provided = MPI_THREAD_SINGLE;
  // Several threads compute, but only the first thread calls MPI.
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Ranks::~Ranks() { MPI_Finalize(); }

std::string Ranks::fromFirst(const std::string& text) {
  std::uint64_t length = text.size();
  MPI_Bcast(&length, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
  std::string received = rank_ == 0 ? text : std::string(length, '\0');
  MPI_Bcast(received.data(), static_cast<int>(length), MPI_CHAR, 0, MPI_COMM_WORLD);
  return received;
}

bool Ranks::isTrueOnAllRanks(bool value) {
  int local = value, on_all = 0;
  MPI_Allreduce(&local, &on_all, 1, MPI_INT, MPI_LAND, MPI_COMM_WORLD);
  return on_all != 0;
}

void Ranks::send(int to, int subject, const TallyWords& words) {
  MPI_Send(words.data(), static_cast<int>(words.size()), MPI_UINT64_T, to, subject, MPI_COMM_WORLD);
}

std::optional<Ranks::Message> Ranks::receive() {
  int has_come = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &has_come, &status);
  if (!has_come) return std::nullopt;
  int count = 0;
  MPI_Get_count(&status, MPI_UINT64_T, &count);
  Message message{status.MPI_SOURCE, status.MPI_TAG, TallyWords(static_cast<std::size_t>(count))};
  MPI_Recv(message.words.data(), count, MPI_UINT64_T, message.from, message.subject, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return message;
}

}  // namespace tubeplan::app
