// Triangle meshes written in the mesh formats, for tests.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <string>

#include "tests/planner/scene/meshes.hpp"

namespace tubeplan::app {

inline std::string stlText(const planner::TriangleMesh& mesh) {
  std::string text = "solid made\n";
  for (const auto& triangle : mesh.triangles) {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (const int k : triangle) {
      const Eigen::Vector3d& v = mesh.vertices[static_cast<std::size_t>(k)];
      text += fmt::format("   vertex {} {} {}\n", v.x(), v.y(), v.z());
    }
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid made\n";
}

inline std::string stlBytes(const planner::TriangleMesh& mesh) {
  std::string bytes(80, ' ');
  const auto append = [&bytes](const auto& value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
  };
  append(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) append(0.0F);
    for (const int k : triangle)
      for (const double x : mesh.vertices[static_cast<std::size_t>(k)]) append(static_cast<float>(x));
    append(std::uint16_t{0});
  }
  return bytes;
}

/// Returns the mesh as text in OBJ format, after the lines `extra`.
inline std::string objText(const planner::TriangleMesh& mesh, const std::string& extra = "") {
  std::string text = extra;
  for (const auto& v : mesh.vertices) text += fmt::format("v {} {} {}\n", v.x(), v.y(), v.z());
  for (const auto& [a, b, c] : mesh.triangles) text += fmt::format("f {} {} {}\n", a + 1, b + 1, c + 1);
  return text;
}

inline std::string plyText(const planner::TriangleMesh& mesh) {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.vertices.size(), mesh.triangles.size());
  for (const auto& v : mesh.vertices) text += fmt::format("{} {} {}\n", v.x(), v.y(), v.z());
  for (const auto& [a, b, c] : mesh.triangles) text += fmt::format("3 {} {} {}\n", a, b, c);
  return text;
}

}  // namespace tubeplan::app
