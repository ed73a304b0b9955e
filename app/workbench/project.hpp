// A workbench's situation as one file: the cell, every model as its files would stand, readings with those set aside,
// touches, and what was found out. Only a plan is left out: it is made again.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/workbench/session.hpp"

namespace tubeplan::app {

inline constexpr const char* kProjectExtension = ".tubeplan";

/// As it stands in the file: what readProject takes.
[[nodiscard]] std::string projectText(const Session& session);

/// The situation that was written. Files that the cell names beside its arm (hole maps, meshes) are read where they
/// stood. Throws InputError for what is no project, is damaged, or names files that are gone.
[[nodiscard]] Session readProject(const std::filesystem::path& file);

/// {file, cell, readings, models, saved}: what a project is of, from its first line alone; null for what is none.
[[nodiscard]] nlohmann::json projectSummary(const std::filesystem::path& file);

/// Whether two situations begin with the same cell, to the letter, and have the same readings.
[[nodiscard]] bool hasSameInputs(const Session& one, const Session& other);

/// Whether anything stands in it that its inputs alone do not give.
[[nodiscard]] bool hasWork(const Session& session);

/// Whether that stands in no project yet.
[[nodiscard]] bool isUnsaved(const Session& session);

}  // namespace tubeplan::app
