#include "app/formats/yaml/strict_yaml.hpp"

#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

std::string refusal(const std::string& text) {
  return messageOf([&] { (void)parseYaml(text, "f.yaml"); });
}

TEST(StrictYaml, keepsPathsLinesAndColumns) {
  const YamlNode root = parseYaml("# a comment\na: {b: [1, 2.5]}\nc:\n  - d: text\n", "f.yaml");
  const YamlNode* b1 = findNode(root, "a.b[1]");
  ASSERT_TRUE(b1);
  EXPECT_EQ(b1->number(), 2.5);
  EXPECT_EQ(b1->where(), "f.yaml:2:12 (a.b[1])");
  const YamlNode* d = findNode(root, "c[0].d");
  ASSERT_TRUE(d);
  EXPECT_EQ(d->line, 4);
  EXPECT_EQ(d->text(), "text");
  EXPECT_EQ(findNode(root, "a.x"), nullptr);
}

TEST(StrictYaml, refusesADoubleKeyWithBothLines) {
  const std::string message = refusal("a: 1\nb: 2\na: 3\n");
  expectSays(message, "f.yaml:3:1");
  expectSays(message, "'a' occurs a second time");
  expectSays(message, "line 1");
  expectSays(refusal("m: {x: 1, x: 1}\n"), "'x' occurs a second time");
}

TEST(StrictYaml, refusesATabButNotInAComment) {
  expectSays(refusal("a:\n\tb: 1\n"), "f.yaml:2:1: found a tab");
  EXPECT_EQ(parseYaml("a: 1 #\tcomment\n", "f").at("a").number(), 1);
}

TEST(StrictYaml, refusesWhatIsNoPlainData) {
  expectSays(refusal("a: &x 1\nb: *x\n"), "anchor");
  expectSays(refusal("a: !!float 1\n"), "tag");
  // A lone `!`, the tag for quoted text, must be refused: it shifted the start of a list or map (found by fuzzing).
  for (const char* text :
       {" !{tjon: [po, d:' 00]}", "a: ! [1, 2]\n", "a: ! word\n", "a: ! 'word'\n", "a: !\n", "! a: 1\n"})
    expectSays(refusal(text), "tag");
  expectSays(refusal("a: 1\n---\nb: 2\n"), "second document");
  expectSays(refusal("[1, 2]: 3\n"), "cannot be a key");
  expectSays(refusal("- 1\n- 2\n"), "a list of 2");
  expectSays(refusal("# only a comment\n"), "only comments");
}

TEST(StrictYaml, refusesBrokenTextWithItsPlace) {
  for (const char* text : {"a: [1, 2\nb: 3\n", "a: {x: 1\n", "a: \"open\n", "a: 'it''s open\n", "'a: 1\n", "a: b: c\n",
                           "a: 1\n  b: 2\n", "}\n", "a: @x\n"})
    expectSays(refusal(text), "f.yaml:");
}

TEST(StrictYaml, endsOnDeepNesting) {
  for (const char* bracket : {"[", "{a: ", "- ", "? "}) {
    std::string text = "a:\n  ";
    for (int i = 0; i < 20000; ++i) text += bracket;
    expectSays(refusal(text), "f.yaml:");
  }
}

TEST(StrictYaml, namesUnknownAndMissingKeys) {
  const YamlNode root = parseYaml("lenght: 1\nother: 2\n", "f.yaml");
  const std::string unknown = messageOf([&] { root.expectKeys({"length"}, {"other"}); });
  expectSays(unknown, "f.yaml:1:");
  expectSays(unknown, "'lenght'");
  expectSays(unknown, "did you mean 'length'?");
  expectSays(messageOf([&] { root.expectKeys({"must"}, {"lenght", "other"}); }), "no key 'must'");
}

TEST(StrictYaml, readsNumbersStrictly) {
  const YamlNode root = parseYaml(
      "a: 1.0121e7\nb: '5'\nc: .nan\nd: -inf\ne: 12 in\nf: 1e999\ng: +3\nh: [1]\ni:\nj: 0x10\nk: 1_000\n", "f");
  EXPECT_EQ(root.at("a").number(), 1.0121e7);
  EXPECT_EQ(root.at("g").number(), 3);
  for (const char* key : {"b", "c", "d", "e", "f", "h", "i", "j", "k"})
    EXPECT_THROW((void)root.at(key).number(), InputError) << key;
  expectSays(messageOf([&] { (void)root.at("c").number(); }), "found .nan, expected a finite number");
  expectSays(messageOf([&] { (void)root.at("e").number(); }), "'12 in'");
  expectSays(messageOf([&] { (void)root.at("i").number(); }), "nothing");
}

TEST(StrictYaml, readsWordsListsAndWholeNumbersStrictly) {
  const YamlNode root = parseYaml("yes: yes\ntrue: true\nlist: [1, 2]\nhalf: 1.5\n", "f");
  EXPECT_TRUE(root.at("true").boolean());
  EXPECT_THROW((void)root.at("yes").boolean(), InputError);
  EXPECT_THROW((void)root.at("list").list(3, "three"), InputError);
  EXPECT_THROW((void)root.at("half").integer(0, 9), InputError);
  EXPECT_EQ(root.at("list").items[1].integer(0, 2), 2);
  EXPECT_THROW((void)root.at("list").items[1].integer(0, 1), InputError);
  EXPECT_THROW((void)root.at("list").text(), InputError);
}

using StrictYamlFile = FolderTest;

TEST_F(StrictYamlFile, refusesFilesThatAreNone) {
  const auto refusedFile = [&](const std::string& path) { return messageOf([&] { (void)readYamlFile(path); }); };
  expectSays(refusedFile((folder / "none.yaml").string()), "no such file");
  expectSays(refusedFile(folder.string()), "a folder");
  expectSays(refusedFile(write("empty.yaml", "")), "the file is empty");
  expectSays(refusedFile(write("blank.yaml", " \n\n")), "the file is empty");
  expectSays(refusedFile(write("binary.yaml", std::string("a: 1\nb\0c", 8))), "binary.yaml:2: found the byte 0x00");
  expectSays(refusedFile(write("latin.yaml", "a: 1\nb: \xE4\n")), "0xE4");
  expectSays(refusedFile("/dev/zero"), "64 MB");
}

TEST_F(StrictYamlFile, acceptsWindowsLinesAndAByteOrderMark) {
  const YamlFile file = readYamlFile(write("windows.yaml",
                                           "\xEF\xBB\xBF"
                                           "a: 1\r\nb: two words\r\n"));
  EXPECT_EQ(file.root.at("a").number(), 1);
  EXPECT_EQ(file.root.at("b").text(), "two words");
}

TEST(InputError, isOneLineOfText) {
  const InputError error("f:1", inQuotes("a\nb\x01"), "c\nd", "e");
  EXPECT_EQ(std::string(error.what()), "f:1: found 'a\\x0Ab\\x01', expected c d; e");
}

}  // namespace
}  // namespace tubeplan::app
