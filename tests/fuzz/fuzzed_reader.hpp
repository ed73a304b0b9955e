// Readers for libFuzzer: TUBEPLAN_READER names one of those in the program. See run.sh.
#pragma once

#include <string>
#include <vector>

namespace tubeplan::app {

struct FuzzedReader {
  const char* name;
  void (*read)(const std::string& text);
  bool is_text = true;  ///< true: checked as in readTextFile() before it is read
};

/// Returns the readers of this program.
const std::vector<FuzzedReader>& fuzzedReaders();

}  // namespace tubeplan::app
