#include "app/formats/yaml/yaml_edit.hpp"

#include "app/formats/yaml/strict_yaml.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

TEST(YamlEdit, changesOneValueAndNothingElse) {
  const std::string text =
      "# top\na: 1   # one\nb: {c: [1, 2], d: 'x # y'}  # two\ne:\n  - f: plain words # three\n    g: 2\n";
  EXPECT_EQ(withYamlValue(text, "a", "5"), changed(text, "a: 1", "a: 5"));
  EXPECT_EQ(withYamlValue(text, "b.c", "[7]"), changed(text, "[1, 2]", "[7]"));
  EXPECT_EQ(withYamlValue(text, "b.c[1]", "9"), changed(text, "[1, 2]", "[1, 9]"));
  EXPECT_EQ(withYamlValue(text, "b.d", "z"), changed(text, "'x # y'", "z"));
  EXPECT_EQ(withYamlValue(text, "e[0].f", "z"), changed(text, "plain words", "z"));
  EXPECT_EQ(withYamlValue(text, "e[0].g", "z"), changed(text, "g: 2", "g: z"));
}

TEST(YamlEdit, addsMissingKeysWhereTheyBelong) {
  EXPECT_EQ(withYamlValue("b: {c: 1}  # x\n", "b.d", "2"), "b: {c: 1, d: 2}  # x\n");
  EXPECT_EQ(withYamlValue("b: {}\n", "b.d", "2"), "b: {d: 2}\n");
  EXPECT_EQ(withYamlValue("b:\n  c: 1  # x\nz: 3\n", "b.d", "2"), "b:\n  c: 1  # x\n  d: 2\nz: 3\n");
  EXPECT_EQ(withYamlValue("a: 1", "b", "2"), "a: 1\nb: 2\n");
  EXPECT_EQ(withYamlValue("a: 1\n", "b.c.d", "2"), "a: 1\nb: {c: {d: 2}}\n");
  EXPECT_EQ(withYamlValue("l:\n  - x: 1\n  - y: 2\n", "l[0].z", "3"), "l:\n  - x: 1\n    z: 3\n  - y: 2\n");
}

TEST(YamlEdit, replacesEmptyValuesAndBlocks) {
  EXPECT_EQ(withYamlValue("a:\nb: 1\n", "a", "2"), "a: 2\nb: 1\n");
  EXPECT_EQ(withYamlValue("a:\n  x: 1\n  y: [1,\n    2]\nb: 1\n", "a", "2"), "a: 2\nb: 1\n");
  EXPECT_EQ(withYamlValue("'a': \"x\\\"y\"\nb: 'it''s'\n", "b", "2"), "'a': \"x\\\"y\"\nb: 2\n");
  EXPECT_EQ(withYamlValue("'a': \"x\\\"y\"\nb: 'it''s'\n", "a", "2"), "'a': 2\nb: 'it''s'\n");
}

TEST(YamlEdit, replacesTextsOverSeveralLines) {
  EXPECT_EQ(withYamlValue("a: >-\n  one\n\n  two\nb: 1\n", "a", "2"), "a: 2\nb: 1\n");
  EXPECT_EQ(withYamlValue("m:\n  a: |\n    one\n  b: 1\n", "m.a", "2"), "m:\n  a: 2\n  b: 1\n");
  EXPECT_EQ(withYamlValue("a: |\n  one\n  two", "a", "2"), "a: 2");
  EXPECT_EQ(withYamlValue("l:\n  - |\n    one\n  - 3\n", "l[0]", "2"), "l:\n  - 2\n  - 3\n");
  // The sign `>` of a block scalar may be on the line below its key (found by fuzzing).
  EXPECT_EQ(withYamlValue("#l\nbase: \n>#d}\n  -", "base.position", "1"), "#l\nbase: \n{position: 1}");
}

TEST(YamlEdit, isNotMisledByCommentsInBrackets) {
  const std::string text = "a: {b: [1, # ] not the end\n  2], c: 5}\nd: 1\n";
  EXPECT_EQ(withYamlValue(text, "a.b", "[]"), "a: {b: [], c: 5}\nd: 1\n");
  EXPECT_EQ(withYamlValue(text, "a.c", "6"), changed(text, "c: 5", "c: 6"));
}

TEST(YamlEdit, takesAKeyAwayAndNothingElse) {
  const char* const lines = "a: 1  # one\nb:\n  c: |\n    x\n\n    y\n  d: 2\ne: [1,\n  2]\n";
  EXPECT_EQ(withoutYamlValue(lines, "a"), "b:\n  c: |\n    x\n\n    y\n  d: 2\ne: [1,\n  2]\n");
  EXPECT_EQ(withoutYamlValue(lines, "b"), "a: 1  # one\ne: [1,\n  2]\n");
  EXPECT_EQ(withoutYamlValue(lines, "b.c"), "a: 1  # one\nb:\n  d: 2\ne: [1,\n  2]\n");
  EXPECT_EQ(withoutYamlValue(lines, "e"), "a: 1  # one\nb:\n  c: |\n    x\n\n    y\n  d: 2\n");
  const char* const braces = "{a: 1, b: {c: 2, d: [3, 4]}, e: \"x, y\"}\n";
  EXPECT_EQ(withoutYamlValue(braces, "a"), "{b: {c: 2, d: [3, 4]}, e: \"x, y\"}\n");
  EXPECT_EQ(withoutYamlValue(braces, "b"), "{a: 1, e: \"x, y\"}\n");
  EXPECT_EQ(withoutYamlValue(braces, "b.d"), "{a: 1, b: {c: 2}, e: \"x, y\"}\n");
  EXPECT_EQ(withoutYamlValue(braces, "e"), "{a: 1, b: {c: 2, d: [3, 4]}}\n");
  EXPECT_EQ(withoutYamlValue("b: {c: 1}\n", "b.c"), "b: {}\n");
}

TEST(YamlEdit, takesAwayWhatItHasAdded) {
  for (const char* text : {"a: 1\n", "a: 1  # one\nb: [2]\n", "{a: 1}\n", "b: {c: 1}  # x\nz: 3\n"})
    EXPECT_EQ(withoutYamlValue(withYamlValue(text, "new", "{x: [1, 2]}"), "new"), text);
}

void expectEveryValueCanBeChanged(const YamlNode& node, const std::string& text) {
  for (const YamlNode& item : node.items) {
    const YamlNode root = parseYaml(withYamlValue(text, item.path, "changed"), "edited");
    const YamlNode* now = findNode(root, item.path);
    ASSERT_TRUE(now) << item.path;
    EXPECT_EQ(now->scalar, "changed") << item.path;
    expectEveryValueCanBeChanged(item, text);
  }
}

TEST(YamlEdit, reachesEveryValueOfTheShippedCells) {
  for (const char* name : {"mockup.yaml", "bench.yaml", "cobra-arm.yaml"}) {
    const YamlFile file = readYamlFile((shippedCells() / name).string());
    ASSERT_FALSE(file.root.items.empty());
    expectEveryValueCanBeChanged(file.root, file.text);
  }
}

}  // namespace
}  // namespace tubeplan::app
