// Fuzz targets for libFuzzer; the environment variable TUBEPLAN_READER selects a target of the program (see run.sh).
#pragma once

#include <string>
#include <vector>

namespace tubeplan::app {

struct FuzzedReader {
  const char* name;
  void (*read)(const std::string& text);
  bool is_text = true;  ///< if true, the input is validated as in readTextFile() before it is read
};

/// Returns all fuzz targets of this program.
const std::vector<FuzzedReader>& fuzzedReaders();

}  // namespace tubeplan::app
