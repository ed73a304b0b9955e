#include "app/storage/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

namespace fs = std::filesystem;

class AtomicFile : public FolderTest {
 protected:
  [[nodiscard]] int entries() const {
    return static_cast<int>(std::distance(fs::recursive_directory_iterator(folder), {}));
  }
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
  for (const fs::path& path :
       {fs::path(file) / "a.txt", folder, fs::path("/proc/none/a.txt"), fs::path("/dev/null/a")}) {
    expectSays(messageOf([&] { checkWritableFile(path, "--out"); }), "--out: ");
    expectSays(messageOf([&] { writeFileAtomically(path, "y", "--out"); }), "--out: ");
  }
  EXPECT_EQ(entries(), 1);
}

TEST_F(AtomicFile, writesToAPipeAndNeverReplacesIt) {
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  checkWritableFile(pipe, "--out");
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  writeFileAtomically(pipe, "through", "--out");
  char text[8] = {};
  EXPECT_EQ(::read(reader, text, sizeof text), 7);
  ::close(reader);
  EXPECT_STREQ(text, "through");
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_EQ(entries(), 1);
}

TEST_F(AtomicFile, replacesTheFileBehindALink) {
  const std::string file = write("file", "old");
  fs::create_symlink("file", folder / "link");
  writeFileAtomically(folder / "link", "new", "--out");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(contentOf(file), "new");
  EXPECT_EQ(entries(), 2);
}

TEST_F(AtomicFile, filesThatBelongTogetherAreAllNewOrAllOld) {
  write("cell.yaml", "old cell");
  const std::vector<TextFile> files = {{folder / "cell.yaml", "new cell"}, {folder / "new/arm.yaml", "new arm"}};
  writeFilesTogether(files, "--out");
  EXPECT_EQ(contentOf(folder / "cell.yaml"), "new cell");
  EXPECT_EQ(contentOf(folder / "new/arm.yaml"), "new arm");
  EXPECT_EQ(entries(), 3);
  // If the last file cannot be written, the others stay as they are, and everything created for them is removed.
  const std::vector<TextFile> too_many = {
      {folder / "cell.yaml", "newer"}, {folder / "newer/arm.yaml", "newer"}, {"/proc/none/a.txt", "newer"}};
  expectSays(messageOf([&] { writeFilesTogether(too_many, "--out"); }), "--out: ");
  EXPECT_EQ(contentOf(folder / "cell.yaml"), "new cell");
  EXPECT_EQ(entries(), 3);
}

TEST_F(AtomicFile, folderThatCannotTakeAllFilesTakesNone) {
  write("a.txt", "old");
  std::filesystem::create_directory(folder / "c.txt");  // a file cannot be renamed over a folder
  {
    OutputFolder out(folder, "--out");
    for (const char* name : {"a.txt", "b.txt", "c.txt", "d.txt"}) out.write(name, "new");
    expectSays(messageOf([&] { out.commit(); }), "c.txt");
  }
  EXPECT_EQ(contentOf(folder / "a.txt"), "old");
  EXPECT_FALSE(fs::exists(folder / "b.txt"));
  EXPECT_EQ(entries(), 2);
}

TEST_F(AtomicFile, folderIsOfOneProgramAtATime) {
  {
    OutputFolder out(folder, "--out");
    const std::string message = messageOf([&] { OutputFolder second(folder, "--out"); });
    expectSays(message, "another run of tubeplan (process " + std::to_string(::getpid()) + ") is writing to");
  }
  // The files that a killed program leaves do not lock the target.
  fs::create_directory(folder / ".tubeplan.1999999999.part");
  OutputFolder again(folder, "--out");
  again.write("a.txt", "a");
  again.commit();
  EXPECT_EQ(contentOf(folder / "a.txt"), "a");
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

TEST_F(AtomicFile, whatAKilledProgramLeftGoesAndWhatIsNotItsOwnStays) {
  const std::string nobody = "1999999999", own = std::to_string(::getpid());  // `nobody` exceeds every process id
  for (const std::string& name : {".tubeplan." + nobody + ".part", ".tubeplan." + own + ".part"}) {
    fs::create_directory(folder / name);
    write(name + "/plan.json", "half");
  }
  write(".film." + nobody + ".part", "x");
  write(".a.txt." + nobody + ".part", "x");
  write(".a.txt.12x.part", "x");
  removeLeftovers(folder, "tubeplan");
  EXPECT_FALSE(fs::exists(folder / (".tubeplan." + nobody + ".part")));
  EXPECT_TRUE(fs::exists(folder / (".tubeplan." + own + ".part") / "plan.json"));
  EXPECT_EQ(entries(), 5);
  removeLeftovers(folder, "a.txt");
  EXPECT_EQ(entries(), 4);
  EXPECT_TRUE(fs::exists(folder / ".a.txt.12x.part"));
  removeLeftovers(folder / "none", "a.txt");
}

TEST_F(AtomicFile, refusesFoldersThatCannotBeWritten) {
  const std::string file = write("file", "x");
  for (const fs::path& path : {fs::path(file), fs::path(file) / "deeper", fs::path("/proc/none")})
    expectSays(messageOf([&] { OutputFolder out(path, "--out"); }), "--out: ");
  EXPECT_EQ(entries(), 1);
}

}  // namespace
}  // namespace tubeplan::app
