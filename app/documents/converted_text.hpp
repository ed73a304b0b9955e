// Sentences with numbers in other units than those in which they were written.
#pragma once

#include <string>
#include <string_view>

#include "app/formats/unit_names.hpp"

namespace tubeplan::app {

/// Returns a text in which numbers followed by a unit, such as "0.12 mm" and "3.0 ± 0.2 deg", have the units of
/// `target`, with at least three digits. A clause in which a unit may belong to several numbers, or in which "in" may
/// be the word, keeps its units.
[[nodiscard]] std::string textInUnits(std::string_view text, const TargetUnits& target);

}  // namespace tubeplan::app
