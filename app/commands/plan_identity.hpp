// Check that a plan's files belong to a given tube sheet and agree on every tube.
#pragma once

#include <string>
#include <vector>

#include "app/formats/plan/plan_reader.hpp"
#include "tubesheets/sheet.hpp"

namespace tubeplan::app {

/// Returns one sentence for each fault: the plan was made for another sheet (or for the mirror image of this sheet),
/// another leg or another viewing side; a tube entry or path row names another leg or tube than the visit does; or
/// path.csv is not the path of plan.json. At most twenty path rows are reported.
[[nodiscard]] std::vector<std::string> findIdentityProblems(const PlanFiles& files, const tubesheets::Sheet& sheet);

/// Returns the sheet mirrored at the divider plate, with hot and cold leg exchanged.
[[nodiscard]] tubesheets::Sheet mirroredLeg(tubesheets::Sheet sheet);

}  // namespace tubeplan::app
