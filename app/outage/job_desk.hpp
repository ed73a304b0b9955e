// Operations of a shift: selection of the next tube, its confirmation, and marks with the rules for their consistency.
#pragma once

#include <optional>
#include <string>

#include "app/outage/identity.hpp"
#include "app/outage/job_store.hpp"

namespace tubeplan::app {

/// Part of the job to which a request applies; an empty member means no restriction.
struct JobPart {
  std::string package, generator;
  std::optional<tubesheets::Leg> leg;

  [[nodiscard]] bool has(const JobItem& item) const;
  /// Returns true if the part is the whole job.
  [[nodiscard]] bool isWhole() const { return package.empty() && generator.empty() && !leg; }
};

/// Throws InputError for a package, a steam generator or a leg that the job does not have; messages name the options.
void requirePart(const JobFile& job, const JobPart& part);

/// Returns the items of the part that are to be visited, in their order: open or queued, and not at an end that was
/// plugged in the meantime. Pointers are into `items`, which are all items of a record.
[[nodiscard]] std::vector<const JobItem*> itemsToVisit(const std::vector<JobItem>& items, const JobPart& part);

/// Return the next of itemsToVisit(): the first open item, otherwise the queued item with the longest wait;
/// std::nullopt if no item is left.
[[nodiscard]] std::optional<JobItem> findNext(const std::vector<JobItem>& items, const JobPart& part);
[[nodiscard]] inline std::optional<JobItem> findNext(JobStore& store, const JobPart& part) {
  return findNext(store.items(), part);
}

/// Returns the item of a tube. Throws InputError if the tube is in no package, or in several and none is named.
[[nodiscard]] JobItem requireItem(JobStore& store, const TubeAddress& tube, const std::string& package);

struct MarkRequest {
  TubeAddress tube;
  std::string package;  ///< name of the package; may be empty if the tube is in only one package
  std::string mark;
  EventEntry entry;
  std::optional<std::int64_t> after;  ///< latest event of the item that the person has seen; std::nullopt: no check
};

/// Records a mark and returns the key of its event. Throws InputError, and records nothing, for an unknown mark, a tube
/// that is excluded, a tube that is done already unless a reason is given, a mark without the reason or the
/// confirmation that it needs, and an item that has changed since the event `after`.
std::int64_t markTube(JobStore& store, const MarkRequest& request);

struct ConfirmationRequest {
  TubeAddress tube;
  std::string package;
  std::string read;                             ///< address that was read back; empty if a position was measured
  std::optional<std::pair<double, double>> xy;  ///< measured position in the sheet frame [m]
  EventEntry entry;
};

/// Records a confirmation of the intended tube or of another tube, and returns the tube found. Throws InputError, and
/// records nothing, if the intended tube is confirmed by another method than its package asks for; another tube that is
/// found is recorded by any method.
[[nodiscard]] IdentityFinding confirmTube(JobStore& store, const ConfirmationRequest& request);

/// Undoes a mark, which restores the item's previous standing. Throws InputError if the event is not a mark, has
/// already been undone or is not the latest mark of its item, and for a missing reason.
std::int64_t undoMark(JobStore& store, std::int64_t event, const EventEntry& entry);

}  // namespace tubeplan::app
