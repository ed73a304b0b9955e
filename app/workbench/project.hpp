// Project file of a session: the text of every model file, all measurements including those set aside, touches, and
// results. Plans are not stored; they are computed again.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/workbench/session.hpp"

namespace tubeplan::app {

inline constexpr const char* kProjectExtension = ".tubeplan";

/// Returns the text of a project file for readProject().
[[nodiscard]] std::string projectText(const Session& session);

/// Reads the session in a project file. Hole maps and meshes that the cell names are read from their original paths.
/// Throws InputError if the file is not a project, is damaged, or names missing files.
[[nodiscard]] Session readProject(const std::filesystem::path& file);

/// Returns {file, program, cell, "cell file", measurements, models, saved}, read from the first line of the file; null
/// if the file is not a project.
[[nodiscard]] nlohmann::json projectSummary(const std::filesystem::path& file);

/// Returns true if two sessions have the same text of the first cell and the same measurements.
[[nodiscard]] bool hasSameInputs(const Session& first, const Session& second);

/// Returns true if the session contains more than its inputs: added models, touches, or measurements set aside or read
/// under assumptions.
[[nodiscard]] bool hasWork(const Session& session);

/// Returns true if the session has work that is not saved in a project file.
[[nodiscard]] bool isUnsaved(const Session& session);

}  // namespace tubeplan::app
