// The table of terms and three-letter codes that inspection programs use for tubes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tubesheets/tube.hpp"

namespace tubeplan::tubesheets {

/// Effect of a code on whether its tube is visited.
enum class CodeUse {
  kState,   ///< state of the tube, which decides whether a tool can enter
  kRemark,  ///< inspection result or request; does not change the tube's state
  kDone,    ///< work is done; the tube is omitted from work lists
};

struct TubeCode {
  std::string_view name;   ///< name as written in tables, such as "PLG"
  std::string_view words;  ///< description for reports
  CodeUse use = CodeUse::kRemark;
  TubeState state = TubeState::kOpen;  ///< state of the tube, for a code of CodeUse::kState
};

/// Returns all codes; the names of tube states come first.
[[nodiscard]] const std::vector<TubeCode>& tubeCodes();

/// Finds a code by name, ignoring case, blanks and punctuation; null if there is none.
[[nodiscard]] const TubeCode* findTubeCode(std::string_view name);

/// Returns the names of all codes that mean a state, for messages: "open, plugged, ..., PLG, ...".
[[nodiscard]] std::string tubeCodeNames();

}  // namespace tubeplan::tubesheets
