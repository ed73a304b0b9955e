// Check that a plan's files belong to a given tube sheet and agree on every tube.
#pragma once

#include <string>
#include <vector>

#include "app/formats/plan/plan_reader.hpp"
#include "tubesheets/sheet.hpp"

namespace tubeplan::app {

/// Returns one sentence for each mismatch: a plan for another sheet (or the mirror image of this sheet), leg or viewing
/// side; a tube entry or path row that names another leg or tube than the visit; a path.csv that does not belong to
/// plan.json. At most twenty path rows are reported.
[[nodiscard]] std::vector<std::string> findIdentityProblems(const PlanFiles& files, const tubesheets::Sheet& sheet);

/// Returns the sheet mirrored at the divider plate, with hot and cold leg exchanged.
[[nodiscard]] tubesheets::Sheet mirroredLeg(tubesheets::Sheet sheet);

}  // namespace tubeplan::app
