// Invalid JSON and values of an unexpected type are refused, and the message gives their position in the document.
#include "app/storage/json_value.hpp"

#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

std::string refusalOfJson(const std::string& text) {
  return messageOf([&] { (void)parseJson(text, "plan.json", "JSON written by tubeplan plan", "plan again"); });
}

TEST(JsonText, WhatIsNoneIsRefusedWithItsPlaceInWordsOfOurOwn) {
  struct Damage {
    std::string text, place;
  };
  for (const Damage& damage :
       {Damage{"", "plan.json:1:1"}, Damage{"{\"a\": 1", "plan.json:1:"}, Damage{"{\n \"a\": ,\n}", "plan.json:2:7"},
        Damage{"{\"a\": 1}}", "plan.json:1:9"}, Damage{"[1, 2,\n\n 3 4]", "plan.json:3:4"},
        Damage{"{\"a\": \"\x1b\"}", "plan.json:1:"}, Damage{"{\"a\": \"\xff\"}", "plan.json:1:"},
        Damage{"{\"a\": 1e999}", "plan.json"}, Damage{std::string(100000, '['), "plan.json"}}) {
    const std::string message = refusalOfJson(damage.text);
    EXPECT_TRUE(message.starts_with(damage.place)) << message;
    expectSays(message, "expected JSON written by tubeplan plan; plan again");
    for (const char* theirs : {"exception", "parse_error", "literal", "syntax", "\n"})
      EXPECT_EQ(message.find(theirs), std::string::npos) << message;
  }
  EXPECT_EQ(parseJson("{\"a\": [1, {\"b\": null}]}", "x", "y")["a"].size(), 2u);
}

TEST(JsonText, ValuesOfAnotherKindAreRefusedWithTheirPlace) {
  const auto json = parseJson(R"({"a": [1, "\u001b[31m"], "b": 2.5, "c": "x"})", "f.json", "a test");
  const JsonValue document(json, "f.json");
  expectSays(messageOf([&] { (void)document.at("a").items()[1].text(); }), "f.json a[1]");
  expectSays(messageOf([&] { (void)document.at("b").integer(0, 9); }), "f.json b: found '2.5'");
  expectSays(messageOf([&] { (void)document.at("c").number(); }), "f.json c");
  expectSays(messageOf([&] { (void)document.at("d"); }), "f.json: the key 'd' is missing");
  EXPECT_EQ(messageOf([&] { (void)document.at("a").items()[1].text(); }).find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace tubeplan::app
