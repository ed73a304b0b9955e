#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

#include "app/formats/mesh/polygon_mesh.hpp"
#include "app/formats/mesh/text_words.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/lower_case.hpp"

namespace tubeplan::app {

namespace {

static_assert(std::endian::native == std::endian::little, "binary STL files are read as they are");

// Sizes of a binary STL file [bytes]: header of 80 bytes of any text and a 4-byte triangle count; 50 bytes for each
// triangle, which begin with a normal of 12 bytes.
constexpr std::size_t kHeader = 84, kTriangle = 50, kNormal = 12;

std::size_t triangleCount(const std::string& bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeader - sizeof count, sizeof count);
  return count;
}

/// Returns true for a text file. Binary files often begin with "solid" too, so a file whose size agrees with its
/// triangle count is binary.
bool isText(const std::string& bytes) {
  if (bytes.size() >= kHeader && bytes.size() == kHeader + kTriangle * triangleCount(bytes)) return false;
  TextWords words(bytes, "");
  return lowerCase(words.next()) == "solid";
}

PolygonMesh parseBinary(const std::string& bytes, const std::string& name) {
  const std::size_t count = bytes.size() < kHeader ? 0 : triangleCount(bytes);
  if (bytes.size() < kHeader || (bytes.size() - kHeader) / kTriangle < count)
    throw InputError::problem(
        name,
        fmt::format("this is neither an ASCII STL file (starting with 'solid') nor a complete binary one: it has {} "
                    "bytes, but {} triangles need {} bytes",
                    bytes.size(), count, kHeader + kTriangle * count),
        "export the part again");
  PolygonMesh mesh;
  mesh.vertices.reserve(3 * count);
  for (std::size_t k = 0; k < count; ++k) {
    float corners[9];
    std::memcpy(corners, bytes.data() + kHeader + kTriangle * k + kNormal, sizeof corners);
    for (int corner = 0; corner < 3; ++corner) {
      mesh.corners.push_back(static_cast<int>(mesh.vertices.size()));
      mesh.vertices.emplace_back(corners[3 * corner], corners[3 * corner + 1], corners[3 * corner + 2]);
    }
    (void)mesh.endFace();
  }
  return mesh;
}

void readVertex(TextWords& words, PolygonMesh& mesh) {
  const double x = words.number(), y = words.number(), z = words.number();
  mesh.corners.push_back(static_cast<int>(mesh.vertices.size()));
  mesh.vertices.emplace_back(x, y, z);
}

void endTriangle(const TextWords& words, PolygonMesh& mesh) {
  const bool is_whole = mesh.endFace() && mesh.corners.size() == 3 * mesh.end.size();
  if (!is_whole) words.failWithProblem("this endfacet does not follow three vertices");
}

/// Parses a text file. The name of a solid extends to the end of its line. Each solid must have an `endsolid`, because
/// nothing else reveals missing triangles.
PolygonMesh parseText(const std::string& bytes, const std::string& name) {
  TextWords words(bytes, name);
  PolygonMesh mesh;
  bool is_open = false;
  for (std::string word; !(word = lowerCase(words.next())).empty();) {
    if (word == "solid" || word == "endsolid") {
      is_open = word == "solid";
      words.skipLine();
    } else if (word == "vertex") {
      readVertex(words, mesh);
    } else if (word == "endfacet") {
      endTriangle(words, mesh);
    } else if (word == "facet") {
      if (lowerCase(words.nextInLine()) != "normal")
        words.failWithProblem("this facet is not followed by 'normal' and three numbers");
      for (int k = 0; k < 3; ++k) (void)words.nextInLine();
    } else if (word != "outer" && word != "loop" && word != "endloop") {
      words.fail(word, "facet, outer loop, vertex, endloop, endfacet or endsolid");
    }
  }
  if (is_open || mesh.corners.size() != 3 * mesh.end.size()) words.failWithProblem("the file ends before endsolid");
  return mesh;
}

}  // namespace

PolygonMesh parseStl(const std::string& bytes, const std::string& name) {
  return isText(bytes) ? parseText(bytes, name) : parseBinary(bytes, name);
}

}  // namespace tubeplan::app
