// Where --json goes: a file, or standard output.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace tubeplan::app {

/// Checks, before the work, that --json FILE can be written; "" (not asked for) and "-" always can.
void checkJsonTarget(const std::string& target);

/// Writes to standard output for "-", else to a file; nothing for "". NaN and infinity come out as null.
void writeJson(const std::string& target, nlohmann::json json);

/// Whether standard output is free for a text for people: it is not where the JSON goes there.
[[nodiscard]] inline bool printsText(const std::string& json_target) { return json_target != "-"; }

}  // namespace tubeplan::app
