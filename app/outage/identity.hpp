// Independent confirmation of a tube's identity: somebody or something other than the arm's encoders says which tube
// the tool is at. An offset from the centre of a hole confirms nothing, because every hole has a centre.
#pragma once

#include <string>
#include <vector>

#include "app/outage/job_store.hpp"

namespace tubeplan::app {

/// Tube that was found where another was meant.
struct IdentityFinding {
  bool is_same = false;
  std::string found;   ///< address of the tube that was found; empty if the position is at no hole
  std::string reason;  ///< how the found tube differs from the meant one, such as "the legs are exchanged"
};

/// Compares a tube that was read back with the tube that is meant.
[[nodiscard]] IdentityFinding compareRead(const TubeAddress& meant, const TubeAddress& read);

/// Compares a measured position of the tool [m], in the frame of the meant tube's sheet, with the holes of that sheet
/// and of the steam generator's other leg. The position is at a hole if it lies within 0.4 pitch of the hole's centre.
[[nodiscard]] IdentityFinding comparePosition(const TubeAddress& meant, double x, double y,
                                              const std::vector<TubeEnd>& ends, double pitch);

/// Returns why the tool may not enter the tube: its package demands a confirmation, and the latest one of this item is
/// missing, older than the latest mark, by another method, of another tube, or by the person who marks it. Returns an
/// empty text if it may.
[[nodiscard]] std::string findMissingConfirmation(const WorkPackage& package,
                                                  const std::vector<JobEvent>& events_of_item, const std::string& who);

}  // namespace tubeplan::app
