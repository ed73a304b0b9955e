// Target of --json: a file, or standard output.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace tubeplan::app {

/// Checks, before the work, that --json FILE can be written; "" (not asked for) and "-" always can.
void checkJsonTarget(const std::string& target);

/// Writes to standard output for "-", else to a file; nothing for "". NaN and infinity are written as null.
void writeJson(const std::string& target, nlohmann::json json);

/// Returns true if standard output is free for text, because the JSON is not written there.
[[nodiscard]] inline bool printsText(const std::string& json_target) { return json_target != "-"; }

}  // namespace tubeplan::app
