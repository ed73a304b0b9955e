// Git commit of the sources from which the program was built.
#pragma once

namespace tubeplan::app {

/// Returns the first twelve digits of the commit, followed by "+" if the sources contained uncommitted changes;
/// "unknown" if they were not in a repository.
[[nodiscard]] const char* sourceCommit();

}  // namespace tubeplan::app
