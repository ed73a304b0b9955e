// What libFuzzer gives text to: TUBEPLAN_READER names one of the readers that the program was built with. See run.sh.
#pragma once

#include <string>
#include <vector>

namespace tubeplan::app {

struct FuzzedReader {
  const char* name;
  void (*read)(const std::string& text);
  bool is_text = true;  ///< checked as readTextFile() does before it is read
};

/// Of this program.
const std::vector<FuzzedReader>& fuzzedReaders();

}  // namespace tubeplan::app
