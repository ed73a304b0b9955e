// Files of other kinds are named when they are given in place of a table, and every table is let through.
#include "app/formats/other_file.hpp"

#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> filesOf(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(TUBEPLAN_SOURCE_DIR) / folder))
    if (entry.path().extension() == extension) files.push_back(entry.path());
  EXPECT_FALSE(files.empty()) << folder;
  return files;
}

TEST(OtherFile, everyShippedFileOfAnotherKindIsNamed) {
  constexpr std::pair<const char*, const char*> kFolders[] = {{"tests/app/urdf", ".urdf"}, {"app/cells", ".yaml"}};
  constexpr const char* kWords[] = {"URDF", "a cell or an arm"};
  for (std::size_t k = 0; k < std::size(kFolders); ++k)
    for (const auto& file : filesOf(kFolders[k].first, kFolders[k].second)) {
      const std::string text = contentOf(file);
      if (text.find("\nlinks:") == text.npos && text.find("\nbase:") == text.npos && k == 1)
        continue;  // a sheet or a job
      expectSays(messageOf([&] { requireTable(file.string(), text); }), kWords[k]);
    }
}

TEST(OtherFile, whatOtherProgramsWriteIsNamed) {
  constexpr std::pair<const char*, const char*> kFiles[] = {
      {"<?xml version='1.0'?><!-- a -->\n<robot name='a'>", "URDF"},
      {"\xEF\xBB\xBF<?xml version='1.0'?><sdf version='1.6'>", "not a URDF"},
      {"<!DOCTYPE html><html>", "web page"},
      {"<rows><row/></rows>", "XML"},
      {"{\"visits\": []}", "plan"},
      {"{\n \"x\": 1}", "JSON"},
      {"[{\"x\": 1}]", "JSON"},
      {"solid part\nfacet normal 0 0 1", "STL"},
      {"ply\nformat ascii 1.0", "PLY"},
      {"PK\x03\x04", "workbook"},
      {"\xD0\xCF\x11\xE0", "workbook"},
      {"%PDF-1.7", "PDF"},
      {"SQLite format 3", "database"}};
  for (const auto& [text, word] : kFiles) expectSays(messageOf([&] { requireTable("given", text); }), word);
}

TEST(OtherFile, tablesAreLetThrough) {
  for (const auto& file : filesOf("tests", ".csv"))
    EXPECT_NO_THROW(requireTable(file.string(), contentOf(file))) << file;
  for (const char* text :
       {"", "id,kind\n", "P1 1 2 3\n", "[1] 2 3\n", "# units: mm\nx;y\n", "solid;x\n1;2\n", "units: {mm}\nx y\n"})
    EXPECT_NO_THROW(requireTable("given", text)) << text;
}

}  // namespace
}  // namespace tubeplan::app
