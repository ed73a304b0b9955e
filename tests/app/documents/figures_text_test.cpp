// A line of text is printed once for each entry of a list, with the values at the stated paths in the stated format and
// unit; it is omitted if a value is missing.
#include "app/documents/figures_text.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/storage/count_text.hpp"

namespace tubeplan::app {
namespace {

const nlohmann::json kDocument = nlohmann::json::parse(R"({
  "units": {"length": "in"}, "unit": "deg", "size": 0.0123456, "large": 1331.2, "fall": -0.5, "nothing": null,
  "count": 3, "none": 0, "zero": 0.0, "share": 0.125, "p": 0.0123, "is_known": true, "is_free": false, "empty": [],
  "list": [1, 2.5], "closed": [1, 2], "from": [1.5, null], "to": [null, 2], "open": [null, null], "name": "a\nb",
  "rms": {"before": 4, "unit": "mm"}, "states": {"open": 4, "plugged": 2},
  "bases": [{"setup": "first", "at": [1, 2], "notes": ["x", "y"]}, {"setup": "", "at": [3, null]}]})");

TEST(DocumentText, fillsInFigures) {
  const struct {
    const char *words, *text;
  } kCases[] = {{"no figure", "no figure"},
                {"{size:.3r unit}", "0.0123 deg"},
                {"{nothing:>8.3r unit}|", "    none|"},
                {"{large:.3r} {large:.3g}", "1331 1.33e+03"},
                {"{size:l}", "0.0123"},
                {"{fall:.2a} {fall:+.1f} {share:+.1f}", "0.5 -0.5 +0.1"},
                {"{share:.1%} %", "12.5 %"},
                {"{p:p}", "p = 0.012"},
                {"{is_known} {is_free}", "yes no"},
                {"{list:.2f}|{list:*6.1f}|{list}", "1.00, 2.50|   1.0   2.5|1, 2.5"},
                {"{list/1} of {#list}, {count}, {none}", "2.5 of 2, 3, 0"},
                {"{closed:.3i}, {from:.3i}, {to:.3i}, {open:.3i}", "1 to 2, 1.5 or more, 2 or less, anything"},
                {"{unit:>5}{unit:<5}|{count:5}|{unit:5}|", "  degdeg  |    3|deg  |"},
                {"{states}", "4 open, 2 plugged"},
                {"{states:*4}|{list:*2.2f}", "   4   2| 1.00 2.50"},
                {"{rms/before} {rms/unit}", "4 mm"}};
  for (const auto& [words, text] : kCases) EXPECT_EQ(textOf(kDocument, words), text);
  EXPECT_EQ(textOf(kDocument, "{name:n}").find('\n'), std::string::npos);
  EXPECT_THROW((void)textOf(kDocument, "{no/such}"), std::logic_error);
}

TEST(DocumentText, agreesWithItsCounts) {
  for (const int count : {0, 1, 2, 11}) {
    const nlohmann::json list(static_cast<std::size_t>(count), "x");
    const nlohmann::json document{{"count", count}, {"list", list}};
    const std::string noun = count == 1 ? "touch is" : "touches are";
    EXPECT_EQ(textOf(document, "{count} touch(|es) (is|are) (here)"), fmt::format("{} {} (here)", count, noun));
    EXPECT_EQ(textOf(document, "{#list:>3} touch(|es) (is|are)"), fmt::format("{:>3} {}", count, noun));
    EXPECT_EQ(countText(static_cast<std::size_t>(count), "step"),
              fmt::format("{} step{}", count, count == 1 ? "" : "s"));
  }
}

TEST(DocumentText, hasALineForEachEntry) {
  static constexpr TextLine kSetup[] = {{"setup", " of {}"}, {"!setup", " of none"}, {"notes", " {}", {}, {}, 1}};
  const struct {
    TextLine line;
    const char* text;
  } kCases[] = {{{"", "always"}, "always"},
                {{"bases", "{setup} {at:.0f};"}, "first 1, 2; 3, none;"},
                {{"bases", "{setup};", {}, {}, 1}, "first;"},
                {{"bases/notes", "{} {setup};"}, "x first;y first;"},
                {{"bases", "base", kSetup}, "base of first xbase of none"},
                {{"rms/before", "{@}: {} {unit}", {}, "before"}, "before: 4 mm"},
                {{"rms", "{before}"}, "4"},
                {{"!rms", "no"}, ""},
                {{"!no/such", "no"}, "no"},
                {{"+fall", "rises"}, ""},
                {{"-fall", "falls"}, "falls"},
                {{"!+fall", "does not rise"}, "does not rise"},
                {{"zero", "{}"}, "0"},
                {{"+zero", "{}"}, ""}};
  for (const auto& [line, text] : kCases) EXPECT_EQ(textOf(kDocument, std::span(&line, 1)), text) << line.words;
  for (const char* nothing : {"nothing", "none", "is_free", "empty", "bases/no", "no"}) {
    const TextLine lines[] = {{nothing, "there"}};
    EXPECT_EQ(textOf(kDocument, lines), "") << nothing;
  }
}

}  // namespace
}  // namespace tubeplan::app
