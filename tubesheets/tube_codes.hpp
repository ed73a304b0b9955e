// What inspection programs say of a tube in a word or a code of three letters: one table.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tubesheets/tube.hpp"

namespace tubeplan::tubesheets {

/// What a code means for a visit.
enum class CodeUse {
  kState,   ///< the tube's state, which says whether a tool goes in
  kRemark,  ///< an outcome or a wish: the tube stays what the sheet says
  kDone,    ///< its work is done: a list leaves it out
};

struct TubeCode {
  std::string_view name;   ///< as it is written: "PLG"
  std::string_view words;  ///< for a reader
  CodeUse use = CodeUse::kRemark;
  TubeState state = TubeState::kOpen;  ///< of CodeUse::kState
};

/// All of them; the names of tube states come first.
[[nodiscard]] const std::vector<TubeCode>& tubeCodes();

/// By name, whatever its capitals, blanks and hyphens; null where there is none.
[[nodiscard]] const TubeCode* findTubeCode(std::string_view name);

/// The names that are states, "open, plugged, ..., PLG, ...", for messages.
[[nodiscard]] std::string tubeCodeNames();

}  // namespace tubeplan::tubesheets
