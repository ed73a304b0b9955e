// Reader of triangle meshes in file formats of CAD programs.
#pragma once

#include <string>

#include "planner/scene/triangle_mesh.hpp"

namespace tubeplan::app {

struct MeshFile {
  planner::TriangleMesh mesh;  ///< mesh in the file's unit of length, which none of the formats states
  std::string fingerprint;     ///< fingerprint of the file's bytes
};

/// Reads an STL (text or binary), OBJ or PLY file; the extension of `path` selects the format. Polygons are divided
/// into fans of triangles; files to which a mesh refers (materials) are ignored. Throws InputError for a missing or
/// damaged file, a folder, another format, more than 256 MB, or a mesh that planner::findMeshProblem rejects.
[[nodiscard]] MeshFile readMeshFile(const std::string& path);

}  // namespace tubeplan::app
