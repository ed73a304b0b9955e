#include "app/report/page.hpp"

#include <fmt/format.h>

#include <array>
#include <cassert>
#include <string_view>

namespace tubeplan::app {
namespace {

constexpr std::string_view kFrame = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>/*TITLE*/</title>
<style>
/*STYLE*/
</style>
</head>
<body>
<div id="page">/*MISSING*/</div>
<p id="origin">/*ORIGIN*/</p>
<noscript><p class="missing">This page draws its figures with the script inside it. Allow scripts for this file to see them;
the same figures are in /*FIGURES*/.</p></noscript>
<script type="application/json" id="report">/*REPORT*/</script>
<script>
"use strict";
/*SCRIPT*/
</script>
</body>
</html>
)";

struct Insertion {
  std::string_view marker;
  std::string text;
};

/// Returns JSON without any character that HTML reads as markup: `<`, `>` and `&`, which occur only within strings, are
/// written as escapes of the same meaning. All characters beyond ASCII (also U+2028 and U+2029) are escaped too.
std::string embeddableJson(const nlohmann::json& report) {
  const std::string plain = report.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  std::string safe;
  safe.reserve(plain.size() + 256);
  for (const char character : plain) {
    switch (character) {
      case '<':
        safe += "\\u003c";
        break;
      case '>':
        safe += "\\u003e";
        break;
      case '&':
        safe += "\\u0026";
        break;
      default:
        safe += character;
    }
  }
  return safe;
}

/// Returns the page with each marker replaced once; the markers occur in the given order. Inserted text is not searched
/// for markers, so data that looks like a marker remains unchanged.
template <std::size_t kCount>
std::string assemble(std::string_view page, const std::array<Insertion, kCount>& insertions) {
  std::string result;
  for (const Insertion& insertion : insertions) {
    const std::size_t place = page.find(insertion.marker);
    assert(place != std::string_view::npos);
    result += page.substr(0, place);
    result += insertion.text;
    page.remove_prefix(place + insertion.marker.size());
  }
  result += page;
  return result;
}

std::string htmlOf(std::string_view text) {
  std::string safe;
  for (const char character : text) {
    switch (character) {
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '&':
        safe += "&amp;";
        break;
      default:
        safe += character;
    }
  }
  return safe;
}

/// Returns HTML with the program's version and the input files of the page; empty for pages with their own list of
/// inputs.
std::string originOf(const nlohmann::json& report) {
  if (!report.is_object() || !report.contains("inputs") || report.contains("commands") || report["inputs"].empty())
    return "";
  std::string text = "tubeplan " + htmlOf(report.value("version", "")) + " of";
  for (const auto& input : report["inputs"])
    text += " " + htmlOf(input.value("name", "")) + " (SHA-256 <code>" + htmlOf(input.value("sha256", "")) + "</code>)";
  return text;
}

/// Returns the HTML shown instead of pictures if the program was built without the report script; otherwise empty.
std::string missingText(const PageKind& kind, const PageSources& sources) {
  if (!sources.script.empty()) return "";
  return fmt::format(
      "<p class=\"missing\">This build of tubeplan has no report pictures: it was built without npm, or with "
      "-DTUBEPLAN_WORKBENCH=OFF. The figures are in {}, and in this file as JSON.</p>",
      kind.figures);
}

}  // namespace

PageSources builtPageSources() {
  PageSources sources;
  for (const auto& [path, content] : embeddedReport()) {
    if (path == "report.css") sources.style = content;
    if (path == "report.js") sources.script = content;
  }
  return sources;
}

std::string renderPage(const PageKind& kind, const nlohmann::json& report, const PageSources& sources) {
  nlohmann::json document = report.is_object() ? report : nlohmann::json::object();
  document["page"] = kind.name;
  const std::array<Insertion, 7> insertions = {{{"/*TITLE*/", std::string(kind.title)},
                                                {"/*STYLE*/", std::string(sources.style)},
                                                {"/*MISSING*/", missingText(kind, sources)},
                                                {"/*ORIGIN*/", originOf(document)},
                                                {"/*FIGURES*/", std::string(kind.figures)},
                                                {"/*REPORT*/", embeddableJson(document)},
                                                {"/*SCRIPT*/", std::string(sources.script)}}};
  return assemble(kFrame, insertions);
}

}  // namespace tubeplan::app
