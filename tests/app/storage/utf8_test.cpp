// Only well-formed UTF-8 without control characters is accepted as text; all other bytes are shown as escapes.
#include "app/storage/utf8.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "app/storage/input_error.hpp"
#include "app/storage/text_file.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

TEST(Utf8, KnowsWellFormedSequences) {
  for (const std::string good :
       {"a", "\xC3\xA9", "\xE2\x82\xAC", "\xED\x9F\xBF", "\xEE\x80\x80", "\xF0\x9F\x94\xA7", "\xF4\x8F\xBF\xBF"})
    EXPECT_EQ(sequenceLength(good, 0), good.size()) << good;
  // Not well-formed: overlong forms, surrogates, code points above U+10FFFF, a lone continuation byte, a truncated
  // sequence.
  for (const std::string bad : {"\xC0\xAF", "\xC1\xBF", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xED\xBF\xBF",
                                "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\x80", "\xE2\x82", "\xFF"})
    EXPECT_EQ(sequenceLength(bad, 0), 0U) << bad;
}

TEST(Utf8, TextHoldsNoControlCharactersButLineEndsAndTabs) {
  for (const std::string good : {"", "a\tb\nc\r\nd", "\xC3\xA9\n", "ends with\r"})
    EXPECT_TRUE(isPlainText(good)) << good;
  struct Found {
    std::string text;
    std::size_t at;
  };
  for (const Found& bad : {Found{"ab\x1b[31m", 2}, Found{"a\rb", 1}, Found{std::string("a\0b", 3), 1}, Found{"\x7f", 0},
                           Found{"a\xC2\x9b", 1}, Found{"\xff", 0}, Found{"ab\xC3", 2}})
    EXPECT_EQ(findNonText(bad.text), bad.at) << printable(bad.text, 99);
}

TEST(Utf8, ShowsWhatCannotBeSeen) {
  EXPECT_EQ(printable("tube R10C20 \xC3\xA9", 100), "tube R10C20 \xC3\xA9");
  EXPECT_EQ(printable("a\nb\x01", 100), "a\\x0Ab\\x01");
  EXPECT_EQ(printable("posi\xE2\x80\xAEtion", 100), "posi\\u202Etion");
  EXPECT_EQ(printable("\xC2\x85", 100), "\\x85");
  EXPECT_EQ(printable("\xED\xA0\x80", 100), "\\xED\\xA0\\x80");
  EXPECT_EQ(printable("a\xE2\x82\xAC\xE2\x82\xAC", 3), "a\xE2\x82\xAC...") << "a character is not cut in two";
}

// A message made from arbitrary bytes can be written as JSON and remains one line of bounded length.
TEST(Utf8, AMessageIsTextWhateverCameIn) {
  std::mt19937 random(7);
  for (int n = 0; n < 3000; ++n) {
    std::string bytes(random() % 200, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    const InputError error(bytes, inQuotes(bytes), bytes, bytes);
    EXPECT_NO_THROW((void)nlohmann::json(error.what()).dump());
    EXPECT_NO_THROW((void)nlohmann::json(error.found()).dump());
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
  EXPECT_LT(std::string(InputError("f", std::string(1000000, 'x'), "y").what()).size(), 5000U);
}

using Utf8File = FolderTest;

TEST_F(Utf8File, OfSurrogatesIsNoText) {
  const std::string path = write("s.csv", "id,kind\n\xED\xA0\x80,position\n");
  expectSays(messageOf([&] { (void)readTextFile(path); }), "s.csv:2: found the byte 0xED");
}

}  // namespace
}  // namespace tubeplan::app
