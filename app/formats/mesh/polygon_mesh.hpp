// Polygons of the three mesh formats, before their division into triangles. Each parser takes a file's bytes and its
// name for messages. It throws InputError for violations of its format, with the line in a text.
//
// The parsers are our own because the available libraries do not tolerate damaged files. In assimp 5.2.5 the reader of
// OBJ reads beyond its text, that of PLY does not terminate, and that of STL overruns a buffer; fuzzing found each
// within a minute (tests/fuzz).
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace tubeplan::app {

struct PolygonMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<int> corners;      ///< indices of vertices, from 0, face after face, not yet checked to exist
  std::vector<std::size_t> end;  ///< end of each face in corners

  /// Closes the face of the corners appended since the last one; returns false if they are fewer than three.
  [[nodiscard]] bool endFace() {
    const std::size_t begin = end.empty() ? 0 : end.back();
    end.push_back(corners.size());
    return corners.size() - begin >= 3;
  }
};

/// Parses an STL file, text or binary.
[[nodiscard]] PolygonMesh parseStl(const std::string& bytes, const std::string& name);
/// Parses vertices and faces of an OBJ file; normals, textures, groups, lines and points are ignored.
[[nodiscard]] PolygonMesh parseObj(const std::string& bytes, const std::string& name);
/// Parses the elements "vertex" and "face" of a PLY file, text or either binary encoding; others are ignored.
[[nodiscard]] PolygonMesh parsePly(const std::string& bytes, const std::string& name);

}  // namespace tubeplan::app
