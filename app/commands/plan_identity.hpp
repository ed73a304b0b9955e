// Whether a plan's files speak of this sheet and say the same of every tube.
#pragma once

#include <string>
#include <vector>

#include "app/formats/plan/plan_reader.hpp"
#include "tubesheets/sheet.hpp"

namespace tubeplan::app {

/// One sentence for each fault: another sheet (or this one's mirror image), another leg or viewing side, a tube entry
/// or a path row that names another leg or tube than the visit it belongs to. Path rows: the first twenty.
[[nodiscard]] std::vector<std::string> findIdentityProblems(const PlanFiles& files, const tubesheets::Sheet& sheet);

/// The same sheet seen in a mirror along the divider plate: hot for cold.
[[nodiscard]] tubesheets::Sheet mirroredLeg(tubesheets::Sheet sheet);

}  // namespace tubeplan::app
