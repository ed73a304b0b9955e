#include "app/atomic_file.hpp"

#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

namespace fs = std::filesystem;

class AtomicFile : public FolderTest {
 protected:
  [[nodiscard]] int entries() const { return static_cast<int>(std::distance(fs::recursive_directory_iterator(folder), {})); }
};

TEST_F(AtomicFile, replacesTheFileAndLeavesNothingElse) {
  writeFileAtomically(folder / "new/a.txt", "one", "--out");
  writeFileAtomically(folder / "new/a.txt", "two", "--out");
  EXPECT_EQ(contentOf(folder / "new/a.txt"), "two");
  EXPECT_EQ(entries(), 2);
}

TEST_F(AtomicFile, checksWithoutATrace) {
  checkWritableFile(folder / "new/deeper/a.txt", "--out");
  EXPECT_EQ(entries(), 0);
}

TEST_F(AtomicFile, refusesPlacesThatCannotBeWritten) {
  const std::string file = write("file", "x");
  for (const fs::path& path : {fs::path(file) / "a.txt", folder, fs::path("/proc/none/a.txt"), fs::path("/dev/null/a")}) {
    EXPECT_SAYS(messageOf([&] { checkWritableFile(path, "--out"); }), "--out: found");
    EXPECT_SAYS(messageOf([&] { writeFileAtomically(path, "y", "--out"); }), "--out: found");
  }
  EXPECT_EQ(entries(), 1);
}

TEST_F(AtomicFile, folderShowsAllFilesAtCommit) {
  write("old.txt", "old");
  OutputFolder out(folder, "--out");
  out.write("a.txt", "a");
  EXPECT_FALSE(fs::exists(folder / "a.txt"));
  out.write("old.txt", "new");
  EXPECT_EQ(contentOf(folder / "old.txt"), "old");
  out.commit();
  EXPECT_EQ(contentOf(folder / "a.txt"), "a");
  EXPECT_EQ(contentOf(folder / "old.txt"), "new");
}

TEST_F(AtomicFile, folderWithoutCommitNeverWas) {
  {
    OutputFolder out(folder / "x/y/", "--out");
    out.write("a.txt", "a");
    EXPECT_TRUE(fs::exists(folder / "x/y"));
  }
  EXPECT_EQ(entries(), 0);
  {
    OutputFolder out(folder / "x/y/", "--out");
    out.write("a.txt", "a");
    out.commit();
  }
  EXPECT_EQ(entries(), 3);
}

TEST_F(AtomicFile, refusesFoldersThatCannotBeWritten) {
  const std::string file = write("file", "x");
  for (const fs::path& path : {fs::path(file), fs::path(file) / "deeper", fs::path("/proc/none")})
    EXPECT_SAYS(messageOf([&] { OutputFolder out(path, "--out"); }), "--out: found");
  EXPECT_EQ(entries(), 1);
}

}  // namespace
}  // namespace tubeplan::app
