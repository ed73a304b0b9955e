// Recognition of files that are given in place of a table: robot descriptions, meshes, workbooks, cells.
#pragma once

#include <string>
#include <string_view>

namespace tubeplan::app {

/// Throws InputError, which says what the file is and what to do with it, if the text is recognised as another kind of
/// file than a table.
void requireTable(const std::string& file, std::string_view text);

}  // namespace tubeplan::app
