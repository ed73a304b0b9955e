#include "app/workbench/page_files.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

namespace fs = std::filesystem;

struct ContentType {
  std::string_view extension, type;
};
constexpr ContentType kTypes[] = {
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".json", "application/json"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".ico", "image/x-icon"},
    {".woff2", "font/woff2"},
    {".wasm", "application/wasm"},
    {".txt", "text/plain; charset=utf-8"},
    {".map", "application/json"},
};

constexpr const char* kNoPage =
    "<!DOCTYPE html><html lang=\"en\"><meta charset=\"utf-8\"><title>Tubeplan</title><h1>Tubeplan</h1><p>This program "
    "was built without the workbench's page, because npm or its packages were not available, or TUBEPLAN_WORKBENCH is "
    "off. Install Node.js with npm, configure and build again. Its data are served at /api/state.</p></html>";

std::string typeOf(const std::string& name) {
  const std::string extension = fs::path(name).extension().string();
  for (const auto& type : kTypes)
    if (type.extension == extension) return std::string(type.type);
  return "application/octet-stream";
}

}  // namespace

PageFiles::PageFiles(const std::string& folder) {
  if (folder.empty()) return;
  std::error_code error;
  folder_ = fs::canonical(folder, error);
  if (error || !fs::is_directory(folder_))
    throw InputError::problem("--page", inQuotes(folder) + " is not a folder", "give a folder with index.html");
}

std::optional<std::string> PageFiles::contentOf(const std::string& name) const {
  if (folder_.empty()) {
    for (const auto& file : embeddedPage())
      if (file.path == name) return std::string(file.content);
    if (name == "index.html") return kNoPage;
    return std::nullopt;
  }
  std::error_code error;
  const fs::path place = fs::canonical(folder_ / name, error);
  const bool is_inside =
      !error && std::mismatch(folder_.begin(), folder_.end(), place.begin(), place.end()).first == folder_.end();
  if (!is_inside || !fs::is_regular_file(place, error)) return std::nullopt;
  std::ifstream stream(place, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

std::optional<PageFile> PageFiles::find(std::string_view path) const {
  std::string name(path.substr(std::min(path.find_first_not_of('/'), path.size())));
  if (name.find('\0') != std::string::npos) return std::nullopt;
  if (name.find('.') == std::string::npos) name = "index.html";
  auto content = contentOf(name);
  if (!content) return std::nullopt;
  return PageFile{std::move(*content), typeOf(name), name.starts_with("assets/")};
}

}  // namespace tubeplan::app
