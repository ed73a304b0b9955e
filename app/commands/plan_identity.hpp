// Check that a plan's files belong to this sheet and agree on every tube.
#pragma once

#include <string>
#include <vector>

#include "app/formats/plan/plan_reader.hpp"
#include "tubesheets/sheet.hpp"

namespace tubeplan::app {

/// Returns one sentence for each fault: another sheet (or this one's mirror image), another leg or viewing side, a tube
/// entry or a path row that names another leg or tube than its visit. Path rows: the first twenty.
[[nodiscard]] std::vector<std::string> findIdentityProblems(const PlanFiles& files, const tubesheets::Sheet& sheet);

/// Returns the mirror image of the sheet along the divider plate, with hot and cold leg exchanged.
[[nodiscard]] tubesheets::Sheet mirroredLeg(tubesheets::Sheet sheet);

}  // namespace tubeplan::app
