// The shipped job with fewer tubes, as a record in a temporary folder.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "app/outage/job_store.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {

class JobTest : public FolderTest {
 protected:
  /// Returns a job of two steam generators with two legs each; `packages` are the lines below the key `packages`.
  [[nodiscard]] std::string jobText(const std::string& packages) const {
    const std::string cell = (shippedCells() / "mockup.yaml").string();
    return "job: test\nunits: {length: in, angle: deg, force: lbf}\nsteam_generators:\n"
           "  - {name: A, hot: '" +
           cell +
           "', cold: mirrored, states: states.csv}\n"
           "  - {name: B, hot: '" +
           cell +
           "', cold: mirrored}\n"
           "tools: [{name: bobbin, speed: 40, change_s: 900}]\npackages:\n" +
           packages +
           "shifts: [{name: day, from: \"06:00\", to: \"18:00\"}, {name: night, from: \"18:00\", to: \"06:00\"}]\n";
  }

  /// Makes a record of the job and returns its path.
  std::string made(const std::string& packages, const std::string& states = "row,column,state\n10,20,plugged\n") {
    (void)write("states.csv", states);
    const std::string path = (folder / "job.record").string();
    JobStore::create(readJobFile(write("job.yaml", jobText(packages))), path);
    return path;
  }
};

}  // namespace tubeplan::app
