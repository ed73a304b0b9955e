#include "app/formats/mesh/polygon_mesh.hpp"
#include "app/formats/mesh/text_words.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

/// Reads a corner "7", "7/1", "7//3" or "7/1/3". Its first number is the vertex: counted from 1, or from the last
/// vertex backwards if negative.
void readCorner(const TextWords& words, std::string_view word, PolygonMesh& mesh) {
  const auto number = tubesheets::parseInteger(word.substr(0, word.find('/')));
  const auto count = static_cast<int>(mesh.vertices.size());
  if (!number || *number == 0 || *number < -count) words.fail(word, "the number of a vertex");
  mesh.corners.push_back(*number > 0 ? *number - 1 : count + *number);
}

void readFace(TextWords& words, PolygonMesh& mesh) {
  std::string_view word;
  while (!(word = words.nextInLine()).empty() && !word.starts_with('#')) readCorner(words, word, mesh);
  if (!mesh.endFace()) words.fail(word, "three or more vertices for the face");
}

}  // namespace

PolygonMesh parseObj(const std::string& bytes, const std::string& name) {
  TextWords words(bytes, name);
  PolygonMesh mesh;
  for (std::string_view word; !(word = words.next()).empty(); words.skipLine()) {
    if (word == "v") {
      const double x = words.number(), y = words.number(), z = words.number();
      mesh.vertices.emplace_back(x, y, z);
    } else if (word == "f") {
      readFace(words, mesh);
    } else if (word == "surf") {
      words.failWithProblem("free-form surfaces (surf) are not supported, only faces");
    }
  }
  return mesh;
}

}  // namespace tubeplan::app
