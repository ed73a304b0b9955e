// Independent confirmation of a tube's identity: a person or an instrument, not the arm's encoders, identifies the tube
// at the tool. An offset from the centre of a hole confirms nothing, because every hole has a centre.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/outage/job_store.hpp"

namespace tubeplan::app {

/// Tube that was identified at the tool, if it is not the intended tube.
struct IdentityFinding {
  bool is_same = false;
  std::string found;   ///< address of the tube that was found; empty if the position is at no hole
  std::string reason;  ///< difference between found and intended tube, such as "the legs are exchanged"
};

/// Compares a tube that was read back with the intended tube.
[[nodiscard]] IdentityFinding compareRead(const TubeAddress& meant, const TubeAddress& read);

/// Compares a measured position of the tool [m], in the frame of the meant tube's sheet, with the holes of that sheet
/// and of the steam generator's other leg. The position is at a hole if it lies within 0.4 pitch of the hole's centre.
[[nodiscard]] IdentityFinding comparePosition(const TubeAddress& meant, double x, double y,
                                              const std::vector<TubeEnd>& ends, double pitch);

/// Returns the reason why a confirmation by this method does not count: the package asks for another. Returns an empty
/// text if it counts.
[[nodiscard]] std::string findWrongMethod(const WorkPackage& package, std::string_view method);

/// Returns the reason why the tool must not enter: the package requires a confirmation, and the item's latest one is
/// missing, older than the latest mark, by another method, of another tube, or by the person who marks it. Returns an
/// empty text if the tool may enter.
[[nodiscard]] std::string findMissingConfirmation(const WorkPackage& package,
                                                  const std::vector<JobEvent>& events_of_item,
                                                  const std::string& person);

}  // namespace tubeplan::app
