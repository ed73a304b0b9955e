#include "app/files/mesh_reader.hpp"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "app/files/checkpoint/plan_key.hpp"
#include "app/files/input_error.hpp"
#include "app/files/lower_case.hpp"
#include "app/files/origin.hpp"

namespace tubeplan::app {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestMesh = 256u << 20;
constexpr std::size_t kMostCorners = 1000;      // of a polygon
constexpr std::size_t kLongestLine = 1u << 15;  // of an OBJ file: a face of the most corners, three numbers each
constexpr std::array<std::string_view, 3> kMeshKinds{"stl", "obj", "ply"};

/// Files that a mesh names beside itself are none of its business.
class NoOtherFiles : public Assimp::IOSystem {
 public:
  bool Exists(const char*) const override { return false; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
  void Close(Assimp::IOStream*) override {}
};

std::string meshKindOf(const std::string& path) {
  std::string kind = lowerCase(fs::path(path).extension().string());
  if (!kind.empty()) kind.erase(0, 1);
  if (std::ranges::find(kMeshKinds, kind) == kMeshKinds.end())
    throw InputError(path, "a file of another kind", "a mesh: .stl, .obj or .ply", "export the part as STL");
  return kind;
}

std::string bytesOf(const std::string& path) {
  std::error_code error;
  const auto status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found)
    throw InputError(path, "no such file", "a mesh, named relative to the cell's folder", "check the name");
  if (!fs::is_regular_file(status)) throw InputError(path, "something that is not a regular file", "a mesh");
  if (fs::file_size(path, error) > kLargestMesh)
    throw InputError(path, "more than 256 MB", "a mesh of at most 256 MB", "export it coarser");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(path, std::strerror(errno), "a file that can be read", "check the file's permissions");
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (bytes.empty()) throw InputError(path, "an empty file", "a mesh", "check that the file was written");
  return bytes;
}

/// The line that the library, which reads a long one in the square of its length, must not see; 0: none. A backslash
/// before its end carries a line on.
std::size_t findLongLine(std::string_view text) {
  std::size_t line = 1, began = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (at - began > kLongestLine) return line;
    if (text[at] != '\n') continue;
    const std::size_t before = at > 0 && text[at - 1] == '\r' ? 2 : 1;
    const bool goes_on = at >= before && text[at - before] == '\\';
    ++line;
    if (!goes_on) began = at + 1;
  }
  return 0;
}

using Triangle = std::array<int, 3>;

/// A polygon's corners joined to one of them; none where that would not stay within it.
std::vector<Triangle> fanOf(const std::vector<Eigen::Vector3d>& vertices, const std::vector<int>& polygon,
                            std::size_t centre) {
  std::vector<Triangle> fan;
  std::vector<Eigen::Vector3d> normals;
  Eigen::Vector3d whole = Eigen::Vector3d::Zero();
  const auto corner = [&](std::size_t k) { return polygon[(centre + k) % polygon.size()]; };
  const auto at = [&](int k) -> const Eigen::Vector3d& { return vertices[static_cast<std::size_t>(k)]; };
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    fan.push_back({corner(0), corner(k), corner(k + 1)});
    normals.push_back((at(corner(k)) - at(corner(0))).cross(at(corner(k + 1)) - at(corner(0))));
    whole += normals.back();
  }
  const bool is_within = std::ranges::none_of(normals, [&](const auto& normal) { return normal.dot(whole) < 0; });
  return is_within ? fan : std::vector<Triangle>{};
}

std::vector<Triangle> trianglesOf(const std::vector<Eigen::Vector3d>& vertices, const std::vector<int>& polygon) {
  if (polygon.size() > kMostCorners) return {};
  for (std::size_t centre = 0; centre < polygon.size(); ++centre)
    if (auto fan = fanOf(vertices, polygon, centre); !fan.empty()) return fan;
  return {};
}

/// Points and lines that a file may hold beside its faces are left out. Polygons are cut here: the library ends the
/// program where a spoilt one defeats it.
void append(const aiMesh& part, const std::string& path, planner::TriangleMesh& mesh) {
  const int first = static_cast<int>(mesh.vertices.size());
  for (unsigned k = 0; k < part.mNumVertices; ++k) {
    const aiVector3D& v = part.mVertices[k];
    mesh.vertices.emplace_back(v.x, v.y, v.z);
  }
  std::vector<int> polygon;
  for (unsigned k = 0; k < part.mNumFaces; ++k) {
    const aiFace& face = part.mFaces[k];
    if (face.mNumIndices < 3) continue;
    polygon.clear();
    for (unsigned corner = 0; corner < face.mNumIndices; ++corner) {
      if (face.mIndices[corner] >= part.mNumVertices)
        throw InputError(path, "a face whose corner does not exist", "a complete mesh", "export the part again");
      polygon.push_back(first + static_cast<int>(face.mIndices[corner]));
    }
    const auto triangles = trianglesOf(mesh.vertices, polygon);
    if (triangles.empty())
      throw InputError(path,
                       fmt::format("a face of {} corners that cannot be triangulated unambiguously", polygon.size()),
                       "triangles", "export the part as triangles");
    mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
  }
}

}  // namespace

MeshFile readMeshFile(const std::string& path) {
  const std::string kind = meshKindOf(path), bytes = bytesOf(path);
  noteInput(path, bytes);
  // Without the end of its header a PLY file keeps the library busy for ever.
  if (kind == "ply" && (!bytes.starts_with("ply") || bytes.find("end_header") == std::string::npos))
    throw InputError(path, "a PLY file without a whole header", "ply ... end_header", "export the part again");
  if (const std::size_t line = kind == "obj" ? findLongLine(bytes) : 0; line > 0)
    throw InputError(fmt::format("{}:{}", path, line), fmt::format("a line of more than {} bytes", kLongestLine),
                     "a vertex or a face to a line", "export the part again");
  MeshFile file;
  file.fingerprint = fingerprintOf(bytes);
  Assimp::Importer importer;
  importer.SetIOHandler(new NoOtherFiles);  // the importer owns it
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, kind.c_str());
  if (!scene)
    throw InputError(path, "what cannot be read (" + std::string(importer.GetErrorString()) + ")",
                     "a mesh of the format that its name states", "export the part again");
  for (unsigned k = 0; k < scene->mNumMeshes; ++k) append(*scene->mMeshes[k], path, file.mesh);
  if (const std::string problem = planner::findMeshProblem(file.mesh); !problem.empty())
    throw InputError(path, problem, "triangles of finite size", "export the part again");
  return file;
}

}  // namespace tubeplan::app
