// For any bytes sent, the workbench answers or closes the connection, keeps running, and touches nothing outside its
// folder.
#include "tests/app/workbench/random_calls.hpp"

#include "tests/app/workbench/running_server.hpp"

/// Limits the freed memory that the address sanitizer retains, which could exceed the memory growth that the test
/// allows.
extern "C" const char* __asan_default_options() { return "quarantine_size_mb=32"; }

namespace tubeplan::app {
namespace {

namespace fs = std::filesystem;

class RandomCallsTest : public WorkbenchTest {
 protected:
  /// Returns the content of every file outside the opened folder, keyed by path.
  [[nodiscard]] std::map<std::string, std::string> outside() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.path().string().find(opened().string()) != 0) files[entry.path().string()] = contentOf(entry.path());
    return files;
  }
};

TEST_F(RandomCallsTest, areAnsweredWithoutHarm) {
  write("secret.yaml", contentOf(shippedCells() / "bench.yaml"));
  fs::create_symlink(folder / "secret.yaml", opened() / "link.yaml");
  serve("mockup.yaml", "mockup-true.yaml");
  const auto before = outside();
  const std::size_t memory = residentMemory();
  const auto counts = RandomCalls(server->port(), 7).make(300);
  for (const auto& [status, count] : counts) RecordProperty(std::to_string(status), count);
  EXPECT_GT(counts.at(200), 10);
  EXPECT_GT(counts.at(422), 10);
  EXPECT_GT(counts.at(400), 5);
  EXPECT_GT(counts.at(403), 2);
  EXPECT_FALSE(counts.contains(500));
  EXPECT_EQ(get("/api/state").status, 200);
  EXPECT_EQ(outside(), before);
  EXPECT_LT(residentMemory(), memory + (256u << 20));
}

}  // namespace
}  // namespace tubeplan::app
