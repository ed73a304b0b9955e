#include "app/report/page.hpp"

#include <array>
#include <cassert>
#include <string_view>

namespace tubeplan::app {
namespace {

struct Insertion {
  std::string_view marker;
  std::string text;
};

/// JSON in which no character can be read as markup: `<`, `>` and `&` occur inside strings only, where an escape means
/// the same; everything past ASCII (U+2028 and U+2029 too) is escaped by the writer.
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

/// The page with each marker replaced, in the order given and once: inserted text is never searched, so data that looks
/// like a marker stays data.
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

/// The program's version and the files that the page is of, but where the page has a list of them of its own.
std::string originOf(const nlohmann::json& report) {
  if (!report.is_object() || !report.contains("inputs") || report.contains("commands")) return "";
  std::string text = "tubeplan " + htmlOf(report.value("version", "")) + " of";
  for (const auto& input : report["inputs"])
    text += " " + htmlOf(input.value("name", "")) + " (SHA-256 <code>" + htmlOf(input.value("sha256", "")) + "</code>)";
  return text;
}

}  // namespace

std::string renderPage(const PageSources& sources, const nlohmann::json& report) {
  const std::array<Insertion, 4> insertions = {{{"/*STYLE*/", sources.style},
                                                {"/*ORIGIN*/", originOf(report)},
                                                {"/*REPORT*/", embeddableJson(report)},
                                                {"/*SCRIPT*/", sources.script}}};
  return assemble(sources.html, insertions);
}

}  // namespace tubeplan::app
