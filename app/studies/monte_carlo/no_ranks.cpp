// Replacement for mpi_ranks.cpp in a build without MPI.
#include "app/studies/monte_carlo/ranks.hpp"

namespace tubeplan::app {

bool isBuiltForRanks() { return false; }

Ranks::Ranks() = default;

Ranks::~Ranks() = default;

std::string Ranks::fromFirst(const std::string& text) { return text; }

bool Ranks::isTrueOnAllRanks(bool value) { return value; }

void Ranks::send(int, int, const TallyWords&) {}

std::optional<Ranks::Message> Ranks::receive() { return std::nullopt; }

}  // namespace tubeplan::app
