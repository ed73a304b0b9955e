// What the three formats of meshes say, before it is cut into triangles. Each reader takes a file's bytes and its name
// for messages, and throws InputError, with the line where it is a text, for what its format does not allow.
//
// They are our own because the libraries at hand do not bear damaged files: of assimp 5.2.5 the reader of OBJ reads
// beyond its text, that of PLY never ends, that of STL overruns a buffer, each found within a minute (tests/fuzz).
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace tubeplan::app {

struct PolygonMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<int> corners;      ///< numbers of vertices, from 0, face after face; not yet known to exist
  std::vector<std::size_t> end;  ///< of each face in corners

  /// Closes the face whose corners were appended since the last one; false where they are fewer than three.
  [[nodiscard]] bool endFace() {
    const std::size_t begin = end.empty() ? 0 : end.back();
    end.push_back(corners.size());
    return corners.size() - begin >= 3;
  }
};

/// Text or binary, whichever it is.
[[nodiscard]] PolygonMesh parseStl(const std::string& bytes, const std::string& name);
/// Vertices and faces; normals, textures, groups, lines and points are left out.
[[nodiscard]] PolygonMesh parseObj(const std::string& bytes, const std::string& name);
/// The elements "vertex" and "face" of a text or of either binary kind; others are left out.
[[nodiscard]] PolygonMesh parsePly(const std::string& bytes, const std::string& name);

}  // namespace tubeplan::app
