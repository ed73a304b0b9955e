// Nothing outside the opened folder is read or written.
#include "app/workbench/opened_folder.hpp"

#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

namespace fs = std::filesystem;

class OpenedFolderTest : public FolderTest {
 protected:
  OpenedFolderTest() {
    fs::create_directories(folder / "opened/inner");
    write("secret.yaml", "secret");
    write("opened/a.yaml", "a");
    write("opened/b.csv", "b");
    write("opened/.hidden.yaml", "h");
    write("opened/inner/c.yaml", "c");
  }
  [[nodiscard]] OpenedFolder opened() const { return OpenedFolder(folder / "opened"); }
};

TEST_F(OpenedFolderTest, readsItsOwnFiles) {
  EXPECT_EQ(contentOf(opened().fileToRead("a.yaml")), "a");
  EXPECT_EQ(opened().names(".yaml"), std::vector<std::string>{"a.yaml"});
  EXPECT_EQ(opened().names(".csv"), std::vector<std::string>{"b.csv"});
}

TEST_F(OpenedFolderTest, refusesNamesThatLeadElsewhere) {
  const std::string names[] = {"",
                               ".",
                               "..",
                               "../secret.yaml",
                               "inner/c.yaml",
                               (folder / "secret.yaml").string(),
                               "a.yaml/",
                               "./a.yaml",
                               ".hidden.yaml",
                               "..\\secret.yaml",
                               "a\n.yaml",
                               std::string("a.yaml\0x", 8),
                               "missing.yaml",
                               std::string(5000, 'a')};
  for (const auto& name : names) EXPECT_NE(messageOf([&] { (void)opened().fileToRead(name); }), "") << name;
  for (const auto& name : names) {
    if (name == "missing.yaml") continue;
    EXPECT_NE(messageOf([&] { (void)opened().fileToWrite(name); }), "") << name;
  }
}

TEST_F(OpenedFolderTest, followsNoLinkOut) {
  fs::create_symlink(folder / "secret.yaml", folder / "opened/link.yaml");
  fs::create_symlink(folder / "opened/inner/c.yaml", folder / "opened/deep.yaml");
  fs::create_symlink("a.yaml", folder / "opened/same.yaml");
  EXPECT_NE(messageOf([&] { (void)opened().fileToRead("link.yaml"); }), "");
  EXPECT_NE(messageOf([&] { (void)opened().fileToRead("deep.yaml"); }), "");
  EXPECT_EQ(contentOf(opened().fileToRead("same.yaml")), "a");
  for (const char* name : {"link.yaml", "same.yaml"})
    EXPECT_NE(messageOf([&] { (void)opened().fileToWrite(name); }), "") << name;
}

TEST_F(OpenedFolderTest, refusesAFolderAsAFile) {
  EXPECT_NE(messageOf([&] { (void)opened().fileToRead("inner"); }), "");
  EXPECT_NE(messageOf([&] { (void)opened().fileToWrite("inner"); }), "");
  EXPECT_NE(messageOf([&] { OpenedFolder(folder / "missing"); }), "");
  EXPECT_NE(messageOf([&] { OpenedFolder(folder / "secret.yaml"); }), "");
}

TEST_F(OpenedFolderTest, isTheRealPlaceOfALink) {
  fs::create_directory_symlink(folder / "opened", folder / "other");
  EXPECT_EQ(OpenedFolder(folder / "other").path(), fs::canonical(folder / "opened"));
  EXPECT_EQ(contentOf(OpenedFolder(folder / "other").fileToRead("a.yaml")), "a");
}

}  // namespace
}  // namespace tubeplan::app
