// Which sources the program was built of.
#pragma once

namespace tubeplan::app {

/// Twelve digits of the commit, with "+" where the sources had changed since; "unknown" outside a repository.
[[nodiscard]] const char* sourceCommit();

}  // namespace tubeplan::app
