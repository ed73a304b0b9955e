// Parsers of the three mesh formats, and the polygons that they return before division into triangles. A parser takes
// the bytes of a file and its name for messages. Parsers throw InputError for violations of the format, with the line
// if the file is text.
//
// These parsers replace the available libraries, which do not tolerate damaged files. In assimp 5.2.5 the OBJ reader
// reads beyond the end of its input, the PLY reader does not terminate, and the STL reader overruns a buffer; fuzzing
// found each error within a minute (tests/fuzz).
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace tubeplan::app {

struct PolygonMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<int> corners;      ///< 0-based vertex indices of all faces, not yet validated
  std::vector<std::size_t> end;  ///< index past the last corner of each face in `corners`

  /// Ends a face, which consists of the corners appended since the previous face; returns false if the face has fewer
  /// than three corners.
  [[nodiscard]] bool endFace() {
    const std::size_t begin = end.empty() ? 0 : end.back();
    end.push_back(corners.size());
    return corners.size() - begin >= 3;
  }
};

/// Parses a text or binary STL file.
[[nodiscard]] PolygonMesh parseStl(const std::string& bytes, const std::string& name);
/// Parses vertices and faces of an OBJ file; ignores normals, textures, groups, lines and points.
[[nodiscard]] PolygonMesh parseObj(const std::string& bytes, const std::string& name);
/// Parses the elements "vertex" and "face" of a PLY file in text or in either binary byte order; ignores other
/// elements.
[[nodiscard]] PolygonMesh parsePly(const std::string& bytes, const std::string& name);

}  // namespace tubeplan::app
