#include "app/storage/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "app/storage/input_error.hpp"
#include "app/storage/missing_file.hpp"
#include "app/storage/origin.hpp"
#include "app/storage/utf8.hpp"

namespace tubeplan::app {

namespace {

constexpr std::size_t kLargestFile = 64u << 20;
constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

std::string readAtMost(std::ifstream& stream, std::size_t limit) {
  std::string text, block(1u << 16, '\0');
  while (text.size() <= limit &&
         (stream.read(block.data(), static_cast<std::streamsize>(block.size())) || stream.gcount() > 0))
    text.append(block, 0, static_cast<std::size_t>(stream.gcount()));
  return text;
}

/// Returns the bytes of a text file, including a byte order mark. Throws InputError for a file that is missing, a
/// folder, unreadable or larger than 64 MB.
std::string bytesOfText(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw MissingFile(InputError::problem(path, "no such file", "check the name and the folder"));
  if (std::filesystem::is_directory(status)) throw InputError(path, "a folder", "a file", "name a file in this folder");
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw InputError::problem(path, fmt::format("the file cannot be read ({})", std::strerror(errno)),
                              "check the file's permissions");
  std::string text = readAtMost(stream, kLargestFile);
  if (text.size() > kLargestFile)
    throw InputError(path, "more than 64 MB", "a file of at most 64 MB", "check that this is the intended file");
  return text;
}

}  // namespace

void checkText(const std::string& path, std::string_view text) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    throw InputError::problem(path, "the file is empty", "check that it was written");
  if (const auto at = findNonText(text)) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(*at), '\n');
    throw InputError(
        fmt::format("{}:{}", path, line), fmt::format("the byte 0x{:02X}", static_cast<unsigned char>(text[*at])),
        text[*at] == '\r' ? "lines that end with LF or CR LF" : "plain text in UTF-8", "save the file as text");
  }
}

void refuseText(const std::string& path, const tubesheets::Problem& problem) {
  const std::string place = problem.line > 0 ? fmt::format("{}:{}", path, problem.line) : path;
  throw InputError(fmt::format("{} ({})", place, problem.what), problem.found, problem.expected, problem.advice);
}

std::string readTextFile(const std::string& path) {
  std::string text = readTextBytes(path);
  if (text.starts_with(kUtf8Mark)) text.erase(0, kUtf8Mark.size());
  return text;
}

std::string readTextBytes(const std::string& path) {
  std::string text = bytesOfText(path);
  noteInput(path, text);
  std::string_view content = text;
  if (content.starts_with(kUtf8Mark)) content.remove_prefix(kUtf8Mark.size());
  checkText(path, content);
  return text;
}

std::string readKeptFile(const std::string& path) {
  std::string text = bytesOfText(path);
  checkText(path, text);
  return text;
}

}  // namespace tubeplan::app
