// Triangles from a file as CAD programs write it.
#pragma once

#include <string>

#include "planner/scene/triangle_mesh.hpp"

namespace tubeplan::app {

struct MeshFile {
  planner::TriangleMesh mesh;  ///< in the file's own unit, whichever that is: none of the formats says
  std::string fingerprint;     ///< of the file's bytes
};

/// Reads an STL (text or binary), OBJ or PLY file by the end of its name; plain polygons are cut into triangles, other
/// files that it names (materials) are not opened. Throws InputError for a file that is missing, a folder, of another
/// kind, larger than 256 MB, not what its name says, or whose mesh planner::findMeshProblem refuses.
[[nodiscard]] MeshFile readMeshFile(const std::string& path);

}  // namespace tubeplan::app
