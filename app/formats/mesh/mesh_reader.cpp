#include "app/formats/mesh/mesh_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <utility>
#include <vector>

#include "app/formats/checkpoint/plan_key.hpp"
#include "app/formats/mesh/polygon_mesh.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/lower_case.hpp"
#include "app/storage/missing_file.hpp"
#include "app/storage/origin.hpp"

namespace tubeplan::app {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestMesh = 256u << 20;
constexpr std::size_t kMostCorners = 1000;  // maximum number of corners in a polygon

struct MeshKind {
  std::string_view ending;
  PolygonMesh (*parse)(const std::string& bytes, const std::string& name);
};

constexpr std::array<MeshKind, 3> kMeshKinds{{{".stl", parseStl}, {".obj", parseObj}, {".ply", parsePly}}};

const MeshKind& meshKindOf(const std::string& path) {
  const std::string ending = lowerCase(fs::path(path).extension().string());
  const auto* kind = std::ranges::find(kMeshKinds, ending, &MeshKind::ending);
  if (kind == kMeshKinds.end())
    throw InputError(path, ending.empty() ? "no file extension" : "the file extension " + inQuotes(ending),
                     "the extension of a mesh: .stl, .obj or .ply", "export the part as STL");
  return *kind;
}

std::string bytesOf(const std::string& path) {
  std::error_code error;
  const auto status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found)
    throw MissingFile(
        InputError::problem(path, "no such file", "check the name, which is relative to the cell's folder"));
  if (!fs::is_regular_file(status))
    throw InputError::problem(path, "this is not a regular file", "give the file of a mesh");
  if (fs::file_size(path, error) > kLargestMesh)
    throw InputError(path, "more than 256 MB", "a mesh of at most 256 MB", "export a coarser mesh");
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw InputError::problem(path, fmt::format("the file cannot be read ({})", std::strerror(errno)),
                              "check its permissions");
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (bytes.empty()) throw InputError::problem(path, "the file is empty", "check that it was written");
  return bytes;
}

using Triangle = std::array<int, 3>;

/// Returns the triangle fan of a polygon about one of its corners; empty if a triangle would extend beyond the polygon.
std::vector<Triangle> fanOf(const std::vector<Eigen::Vector3d>& vertices, std::span<const int> polygon,
                            std::size_t centre) {
  std::vector<Triangle> fan;
  std::vector<Eigen::Vector3d> normals;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const auto corner = [&](std::size_t k) { return polygon[(centre + k) % polygon.size()]; };
  const auto at = [&](int k) -> const Eigen::Vector3d& { return vertices[static_cast<std::size_t>(k)]; };
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    fan.push_back({corner(0), corner(k), corner(k + 1)});
    normals.push_back((at(corner(k)) - at(corner(0))).cross(at(corner(k + 1)) - at(corner(0))));
    sum += normals.back();
  }
  const bool is_within = std::ranges::none_of(normals, [&](const auto& normal) { return normal.dot(sum) < 0; });
  return is_within ? fan : std::vector<Triangle>{};
}

std::vector<Triangle> trianglesOf(const std::vector<Eigen::Vector3d>& vertices, std::span<const int> polygon) {
  if (polygon.size() == 3) return {{polygon[0], polygon[1], polygon[2]}};
  if (polygon.size() > kMostCorners) return {};
  for (std::size_t centre = 0; centre < polygon.size(); ++centre)
    if (auto fan = fanOf(vertices, polygon, centre); !fan.empty()) return fan;
  return {};
}

planner::TriangleMesh trianglesOf(PolygonMesh&& polygons, const std::string& path) {
  planner::TriangleMesh mesh{std::move(polygons.vertices), {}};
  std::size_t begin = 0;
  for (std::size_t face = 0; face < polygons.end.size(); ++face) {
    const std::span corners(polygons.corners.data() + begin, polygons.corners.data() + polygons.end[face]);
    begin = polygons.end[face];
    if (std::ranges::any_of(corners, [&](int k) { return k >= std::ssize(mesh.vertices); }))
      throw InputError::problem(
          path, fmt::format("a corner of face {} is not one of the {} vertices", face + 1, mesh.vertices.size()),
          "export the part again");
    const auto triangles = trianglesOf(mesh.vertices, corners);
    if (triangles.empty())
      throw InputError::problem(
          path, fmt::format("a face of {} corners cannot be divided into triangles unambiguously", corners.size()),
          "export the part as triangles");
    mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
  }
  return mesh;
}

}  // namespace

MeshFile readMeshFile(const std::string& path) {
  const MeshKind& kind = meshKindOf(path);
  const std::string bytes = bytesOf(path);
  noteInput(path, bytes);
  MeshFile file{trianglesOf(kind.parse(bytes, path), path), fingerprintOf(bytes)};
  if (const std::string problem = planner::findMeshProblem(file.mesh); !problem.empty())
    throw InputError::problem(path, problem, "export the part again, as triangles of finite size");
  return file;
}

}  // namespace tubeplan::app
