// Commit of the sources from which the program was built.
#pragma once

namespace tubeplan::app {

/// Returns twelve digits of the commit, with "+" if the sources had changed since; "unknown" outside a repository.
[[nodiscard]] const char* sourceCommit();

}  // namespace tubeplan::app
