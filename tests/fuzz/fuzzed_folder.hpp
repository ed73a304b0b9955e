// Folder in memory with the shipped files, to which a fuzzed input may refer.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace tubeplan::app {

inline std::string shippedCell(const std::string& name) { return TUBEPLAN_SOURCE_DIR "/app/cells/" + name; }

inline const std::string& fuzzedFolder() {
  static const std::string kFolder = [] {
    const std::string folder =
        "/dev/shm/tubeplan-fuzz-" + std::to_string(::getppid()) + "/" + std::to_string(::getpid());
    std::filesystem::create_directories(folder);
    std::filesystem::copy(shippedCell(""), folder, std::filesystem::copy_options::recursive);
    return folder;
  }();
  return kFolder;
}

/// Writes the text to a file `name` in the folder and returns the path, for readers that take a path.
inline std::string fileOf(const std::string& text, const std::string& name) {
  const std::string path = fuzzedFolder() + "/" + name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

}  // namespace tubeplan::app
