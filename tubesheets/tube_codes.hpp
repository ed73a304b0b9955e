// The table of words and three-letter codes that inspection programs use for tubes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tubesheets/tube.hpp"

namespace tubeplan::tubesheets {

/// Effect of a code on a visit.
enum class CodeUse {
  kState,   ///< the tube's state, which decides whether a tool enters
  kRemark,  ///< an outcome or a wish: the tube keeps the state that the sheet gives
  kDone,    ///< work done: a list leaves the tube out
};

struct TubeCode {
  std::string_view name;   ///< name as written: "PLG"
  std::string_view words;  ///< words for a reader
  CodeUse use = CodeUse::kRemark;
  TubeState state = TubeState::kOpen;  ///< state meant by a code of CodeUse::kState
};

/// Returns all codes; the names of tube states come first.
[[nodiscard]] const std::vector<TubeCode>& tubeCodes();

/// Finds a code by name, ignoring capitals, blanks and hyphens; null if there is none.
[[nodiscard]] const TubeCode* findTubeCode(std::string_view name);

/// Returns the names of states, "open, plugged, ..., PLG, ...", for messages.
[[nodiscard]] std::string tubeCodeNames();

}  // namespace tubeplan::tubesheets
