#include "app/readers/mesh_reader.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "app/input_error.hpp"
#include "app/plan_question.hpp"

namespace tubeplan::app {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFile = 256u << 20;
constexpr std::array<std::string_view, 3> kKinds{"stl", "obj", "ply"};

/// Files that a mesh names beside itself are none of its business.
class NoOtherFiles : public Assimp::IOSystem {
 public:
  bool Exists(const char*) const override { return false; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
  void Close(Assimp::IOStream*) override {}
};

std::string kindOf(const std::string& path) {
  std::string kind = fs::path(path).extension().string();
  std::ranges::transform(kind, kind.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (!kind.empty()) kind.erase(0, 1);
  if (std::ranges::find(kKinds, kind) == kKinds.end())
    throw InputError(path, "a file of another kind", "a mesh: .stl, .obj or .ply", "export the part as STL");
  return kind;
}

std::string bytesOf(const std::string& path) {
  std::error_code error;
  const auto status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found)
    throw InputError(path, "no such file", "a mesh, named relative to the cell's folder", "check the name");
  if (!fs::is_regular_file(status)) throw InputError(path, "something that is no plain file", "a mesh");
  if (fs::file_size(path, error) > kLargestFile)
    throw InputError(path, "more than 256 MB", "a mesh of at most 256 MB", "export it coarser");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(path, std::strerror(errno), "a file that can be read", "check the file's permissions");
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (bytes.empty()) throw InputError(path, "an empty file", "a mesh", "check that the file was written");
  return bytes;
}

/// Points and lines that a file may hold beside its faces are left out.
void append(const aiMesh& part, planner::TriangleMesh& mesh) {
  const int first = static_cast<int>(mesh.vertices.size());
  for (unsigned k = 0; k < part.mNumVertices; ++k) {
    const aiVector3D& v = part.mVertices[k];
    mesh.vertices.emplace_back(v.x, v.y, v.z);
  }
  for (unsigned k = 0; k < part.mNumFaces; ++k) {
    const aiFace& face = part.mFaces[k];
    if (face.mNumIndices != 3) continue;
    std::array<int, 3> triangle{};
    for (std::size_t corner = 0; corner < 3; ++corner)
      triangle[corner] = first + static_cast<int>(face.mIndices[corner]);
    mesh.triangles.push_back(triangle);
  }
}

}  // namespace

MeshFile readMeshFile(const std::string& path) {
  const std::string kind = kindOf(path), bytes = bytesOf(path);
  MeshFile file;
  file.fingerprint = fingerprintOf(bytes);
  Assimp::Importer importer;
  importer.SetIOHandler(new NoOtherFiles);  // the importer owns it
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), aiProcess_Triangulate, kind.c_str());
  if (!scene)
    throw InputError(path, "what cannot be read (" + std::string(importer.GetErrorString()) + ")",
                     "a mesh as its name says", "export the part again");
  for (unsigned k = 0; k < scene->mNumMeshes; ++k) append(*scene->mMeshes[k], file.mesh);
  if (const std::string problem = planner::findMeshProblem(file.mesh); !problem.empty())
    throw InputError(path, problem, "triangles of finite size", "export the part again");
  return file;
}

}  // namespace tubeplan::app
