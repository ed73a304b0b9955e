// Test fixture that runs the program in a temporary folder.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/app/test_files.hpp"

namespace tubeplan::app {

struct Outcome {
  int exit_code;
  std::string out, err;
};

class ProgramTest : public FolderTest {
 protected:
  [[nodiscard]] Outcome run(const std::string& arguments) const {
    const std::string command =
        "cd '" + folder.string() + "' && '" TUBEPLAN_PROGRAM "' " + arguments + " >out.txt 2>err.txt </dev/null";
    const int status = std::system(command.c_str());
    Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, contentOf(folder / "out.txt"),
                    contentOf(folder / "err.txt")};
    std::filesystem::remove(folder / "out.txt");
    std::filesystem::remove(folder / "err.txt");
    return outcome;
  }

  /// Writes the mock-up cell as `name`, its arm file, and holes.csv with the hole map `map`, which replaces the cell's
  /// layout.
  void writeMappedMockup(const std::string& name, const std::string& map) const {
    (void)write("holes.csv", map);
    (void)write("cobra-arm.yaml", contentOf(shippedCells() / "cobra-arm.yaml"));
    const std::string cell = contentOf(shippedCells() / "mockup.yaml");
    const auto layout = cell.find("layout: {"), end = cell.find('}', layout) + 1;
    ASSERT_NE(layout, std::string::npos);
    (void)write(name, cell.substr(0, layout) + "map: holes.csv\n  pitch: 1.0625" + cell.substr(end));
  }

  [[nodiscard]] static std::string shipped(const std::string& name) {
    return "'" + (shippedCells() / name).string() + "'";
  }
};

}  // namespace tubeplan::app
