#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>

#include "app/formats/mesh/polygon_mesh.hpp"
#include "app/formats/mesh/text_words.hpp"
#include "app/storage/input_error.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

/// Type of numbers in a PLY file, with its two names ("uchar", "uint8").
struct NumberType {
  std::string_view name, sized_name;
  std::size_t size;
  double (*value)(const char* bytes);
};

template <typename Number>
double valueOf(const char* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  return static_cast<double>(number);
}

constexpr std::array<NumberType, 8> kNumberTypes{{{"char", "int8", 1, valueOf<std::int8_t>},
                                                  {"uchar", "uint8", 1, valueOf<std::uint8_t>},
                                                  {"short", "int16", 2, valueOf<std::int16_t>},
                                                  {"ushort", "uint16", 2, valueOf<std::uint16_t>},
                                                  {"int", "int32", 4, valueOf<std::int32_t>},
                                                  {"uint", "uint32", 4, valueOf<std::uint32_t>},
                                                  {"float", "float32", 4, valueOf<float>},
                                                  {"double", "float64", 8, valueOf<double>}}};

struct PlyProperty {
  const NumberType* count = nullptr;  ///< type of the length of a list; null if the property is not a list
  const NumberType* value = nullptr;
  std::string_view name;
};

struct PlyElement {
  std::string_view name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { kText, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kText;
  std::vector<PlyElement> elements;
};

const NumberType* readType(TextWords& words) {
  const std::string_view name = words.nextInLine();
  const auto* type = std::ranges::find_if(
      kNumberTypes, [&](const NumberType& type) { return type.name == name || type.sized_name == name; });
  if (type == kNumberTypes.end()) words.fail(name, "a number type: char to double, or int8 to float64");
  return type;
}

PlyEncoding readEncoding(TextWords& words) {
  constexpr std::array<std::string_view, 3> kNames{"ascii", "binary_little_endian", "binary_big_endian"};
  const std::string_view name = words.nextInLine();
  const auto* found = std::ranges::find(kNames, name);
  if (found == kNames.end()) words.fail(name, "the format ascii, binary_little_endian or binary_big_endian");
  return static_cast<PlyEncoding>(found - kNames.begin());
}

PlyElement readElement(TextWords& words) {
  PlyElement element;
  element.name = words.nextInLine();
  const std::string_view count = words.nextInLine();
  const auto number = tubesheets::parseInteger(count);
  if (!number || *number < 0) words.fail(count, "the number of entries of the element");
  element.count = static_cast<std::size_t>(*number);
  return element;
}

PlyProperty readProperty(TextWords& words) {
  TextWords ahead = words;
  PlyProperty property;
  if (ahead.nextInLine() == "list") {
    words = ahead;
    property.count = readType(words);
  }
  property.value = readType(words);
  property.name = words.nextInLine();
  return property;
}

/// Reads the header, including the line `end_header`.
PlyHeader readHeader(TextWords& words) {
  PlyHeader header;
  if (const auto word = words.next(); word != "ply") words.fail(word, "ply");
  for (std::string_view word; (word = words.next()) != "end_header"; words.skipLine()) {
    if (word == "format") {
      header.encoding = readEncoding(words);
    } else if (word == "element") {
      header.elements.push_back(readElement(words));
    } else if (word == "property") {
      if (header.elements.empty()) words.failWithProblem("the property occurs before any element");
      header.elements.back().properties.push_back(readProperty(words));
    } else if (word != "comment" && word != "obj_info") {
      words.fail(word, "element, property, comment or end_header");
    }
  }
  words.skipLine();
  return header;
}

/// Reader of the numbers after the header.
class PlyNumbers {
 public:
  PlyNumbers(PlyEncoding encoding, TextWords& words, const std::string& bytes, const std::string& name)
      : encoding_(encoding), words_(words), bytes_(bytes), name_(name), at_(words.position()) {}

  double next(const NumberType& type) { return encoding_ == PlyEncoding::kText ? nextWord() : nextBytes(type); }

  /// Returns an integer from 0 to the maximum of int. Throws InputError for other numbers.
  int nextIndex(const NumberType& type) {
    const double number = next(type);
    if (number < 0 || number > std::numeric_limits<int>::max() || number != std::floor(number))
      throw InputError(name_, fmt::format("the number {}", number),
                       "a whole number of 0 or more: a count of corners, or the index of a vertex",
                       "export the part again");
    return static_cast<int>(number);
  }

 private:
  double nextWord() {
    const std::string_view word = words_.next();
    const auto number = tubesheets::parseNumber(word);
    if (!number) words_.fail(word, "a finite number");
    return *number;
  }

  double nextBytes(const NumberType& type) {
    if (bytes_.size() - at_ < type.size)
      throw InputError::problem(name_, "the file ends before the last of the elements that its header announces",
                                "export the part again");
    char number[8];
    std::memcpy(number, bytes_.data() + at_, type.size);
    if ((encoding_ == PlyEncoding::kBigEndian) != (std::endian::native == std::endian::big))
      std::reverse(number, number + type.size);
    at_ += type.size;
    return type.value(number);
  }

  PlyEncoding encoding_;
  TextWords& words_;
  const std::string& bytes_;
  const std::string& name_;
  std::size_t at_;
};

void skip(PlyNumbers& numbers, const PlyProperty& property) {
  const int count = property.count ? numbers.nextIndex(*property.count) : 1;
  for (int k = 0; k < count; ++k) (void)numbers.next(*property.value);
}

constexpr std::string_view kAxes = "xyz";

/// Returns the axis of a vertex property: 0, 1, 2 for x, y, z; std::nullopt for other properties.
std::optional<int> axisOf(const PlyProperty& property) {
  const bool is_one = !property.count && property.name.size() == 1;
  const std::size_t axis = is_one ? kAxes.find(property.name[0]) : std::string_view::npos;
  return axis == std::string_view::npos ? std::nullopt : std::optional<int>(static_cast<int>(axis));
}

bool areCorners(const PlyProperty& property) {
  return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
}

void requireOnce(const PlyElement& element, const std::string& name, std::string_view what, auto is_it) {
  if (const auto times = std::ranges::count_if(element.properties, is_it); times != 1)
    throw InputError::problem(
        name, fmt::format("the element {} has the property {} {} times, not once", element.name, what, times),
        "export the part again");
}

void readVertices(const PlyElement& element, PlyNumbers& numbers, PolygonMesh& mesh) {
  for (std::size_t k = 0; k < element.count; ++k) {
    Eigen::Vector3d& vertex = mesh.vertices.emplace_back(Eigen::Vector3d::Zero());
    for (const PlyProperty& property : element.properties) {
      if (const auto axis = axisOf(property))
        vertex[*axis] = numbers.next(*property.value);
      else
        skip(numbers, property);
    }
  }
}

void readFaces(const PlyElement& element, PlyNumbers& numbers, const std::string& name, PolygonMesh& mesh) {
  for (std::size_t k = 0; k < element.count; ++k) {
    for (const PlyProperty& property : element.properties) {
      if (!areCorners(property)) {
        skip(numbers, property);
        continue;
      }
      for (int left = numbers.nextIndex(*property.count); left > 0; --left)
        mesh.corners.push_back(numbers.nextIndex(*property.value));
    }
    if (!mesh.endFace())
      throw InputError::problem(name, fmt::format("face {} has fewer than three corners", k + 1),
                                "export the part again");
  }
}

/// Reads all elements. Elements without properties contain no numbers and are skipped without a loop over their count.
void readElements(const PlyHeader& header, PlyNumbers& numbers, const std::string& name, PolygonMesh& mesh) {
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      for (int axis = 0; axis < 3; ++axis)
        requireOnce(element, name, kAxes.substr(static_cast<std::size_t>(axis), 1),
                    [&](const PlyProperty& property) { return axisOf(property) == axis; });
      readVertices(element, numbers, mesh);
    } else if (element.name == "face") {
      requireOnce(element, name, "vertex_indices", areCorners);
      readFaces(element, numbers, name, mesh);
    } else if (!element.properties.empty()) {
      for (std::size_t k = 0; k < element.count; ++k)
        for (const PlyProperty& property : element.properties) skip(numbers, property);
    }
  }
}

}  // namespace

PolygonMesh parsePly(const std::string& bytes, const std::string& name) {
  TextWords words(bytes, name);
  const PlyHeader header = readHeader(words);
  PlyNumbers numbers(header.encoding, words, bytes, name);
  PolygonMesh mesh;
  readElements(header, numbers, name, mesh);
  return mesh;
}

}  // namespace tubeplan::app
