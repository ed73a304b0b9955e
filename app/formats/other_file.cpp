#include "app/formats/other_file.hpp"

#include <algorithm>
#include <array>

#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

constexpr std::size_t kHead = 1u << 16;  // bytes of a file in which its kind shows

/// Kind of file, known by its first bytes, and by any one of further strings if some are listed.
struct OtherFile {
  std::string_view begin;
  std::array<std::string_view, 4> any_of;  ///< empty strings do not count
  const char *is, *advice;
};

constexpr const char* kExportTable = "export the readings as a table (CSV) and open that";

/// The first row that fits applies.
constexpr OtherFile kOtherFiles[] = {
    {"<",
     {"<robot"},
     "a robot description (URDF)",
     "convert it to an arm and a cell: drop it on the page of `tubeplan serve`, or run `tubeplan arm import`"},
    {"<", {"<sdf", "<mujoco"}, "a robot description, but not a URDF", "convert it to URDF and import that"},
    {"<", {"<html", "<HTML", "<!DOCTYPE", "<!doctype"}, "a web page", kExportTable},
    {"<", {"?>", "</", "/>"}, "an XML document", kExportTable},
    {"{",
     {"\"tubes\"", "\"visits\""},
     "a plan or a result (JSON)",
     "open the readings or the work list from which it was made"},
    {"{", {"\":", "\" :"}, "a JSON document", kExportTable},
    {"[", {"\":", "\" :"}, "a JSON document", kExportTable},
    {"solid", {"facet"}, "a mesh (STL)", "name the file as a solid in a cell's `scene` or `link_shapes`"},
    {"ply\n", {}, "a mesh (PLY)", "name the file as a solid in a cell's `scene` or `link_shapes`"},
    {"",
     {"\nlinks:\n", "\nbase: {", "\nbase:\n", "\ntubesheet:"},
     "a cell or an arm file",
     "open the cell by its name, from its folder"},
    {"PK\x03\x04", {}, "a workbook or an archive (zip)", "save the sheet with the table as CSV and open that"},
    {"\xD0\xCF\x11\xE0", {}, "a workbook of an old format", "save the sheet with the table as CSV and open that"},
    {"%PDF", {}, "a PDF document", kExportTable},
    {"SQLite format 3", {}, "a database, such as a job's record", "put the record into the opened folder"},
};

bool fits(const OtherFile& kind, std::string_view head) {
  if (!head.starts_with(kind.begin)) return false;
  bool has_none = true;
  for (const std::string_view part : kind.any_of) {
    if (part.empty()) continue;
    if (head.find(part) != head.npos) return true;
    has_none = false;
  }
  return has_none;
}

std::string_view headOf(std::string_view text) {
  constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
  if (text.starts_with(kUtf8Mark)) text.remove_prefix(kUtf8Mark.size());
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return text.substr(0, kHead);
}

}  // namespace

void requireTable(const std::string& file, std::string_view text) {
  for (const OtherFile& kind : kOtherFiles)
    if (fits(kind, headOf(text)))
      throw InputError::problem(file, std::string("the file is no table, but ") + kind.is, kind.advice);
}

}  // namespace tubeplan::app
