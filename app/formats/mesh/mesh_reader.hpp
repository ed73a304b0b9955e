// Reader of triangle meshes in the file formats of CAD programs.
#pragma once

#include <string>

#include "planner/scene/triangle_mesh.hpp"

namespace tubeplan::app {

struct MeshFile {
  planner::TriangleMesh mesh;  ///< mesh in the file's own unit, which none of the formats states
  std::string fingerprint;     ///< fingerprint of the file's bytes
};

/// Reads an STL (text or binary), OBJ or PLY file, chosen by the end of its name. Plain polygons are divided into
/// triangles; other files named in it (materials) are ignored. Throws InputError for a file that is missing, a folder,
/// of another format, larger than 256 MB or damaged, or whose mesh planner::findMeshProblem refuses.
[[nodiscard]] MeshFile readMeshFile(const std::string& path);

}  // namespace tubeplan::app
