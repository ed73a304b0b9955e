#include "app/formats/mesh/mesh_reader.hpp"

#include <algorithm>
#include <cstring>
#include <random>

#include "tests/app/formats/mesh/mesh_files.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

using MeshReader = FolderTest;
using planner::testing::ballMesh;

TEST_F(MeshReader, EveryFormatGivesTheSameBall) {
  const auto ball = ballMesh(6, 8);
  const std::string files[] = {write("a.stl", stlText(ball)), write("b.STL", stlBytes(ball)),
                               write("c.obj", objText(ball)), write("d.ply", plyText(ball))};
  for (const auto& file : files) {
    SCOPED_TRACE(file);
    const auto mesh = readMeshFile(file).mesh;
    EXPECT_EQ(mesh.triangles.size(), ball.triangles.size());
    const auto survey = planner::surveyMesh(mesh);
    EXPECT_TRUE(survey.isClosed()) << planner::describe(survey);
    EXPECT_NEAR(survey.bounds.max().z(), 6, 1e-6);
    EXPECT_LT(planner::testing::meshShape(mesh).pointDistance({1, 1, 1}), 0);
  }
  EXPECT_EQ(readMeshFile(files[0]).fingerprint, readMeshFile(write("again.stl", stlText(ball))).fingerprint);
  EXPECT_NE(readMeshFile(files[0]).fingerprint, readMeshFile(write("e.stl", stlText(ballMesh(7, 8)))).fingerprint);
}

const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

double areaOf(const planner::TriangleMesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto corner = [&](int k) { return mesh.vertices[static_cast<std::size_t>(k)]; };
    area += 0.5 * (corner(b) - corner(a)).cross(corner(c) - corner(a)).norm();
  }
  return area;
}

TEST_F(MeshReader, AnObjFileIsReadHoweverItIsWritten) {
  for (const std::string& text :
       {kCorners + "f 1 2 3\n", kCorners + "f -3 -2 -1",
        "\xEF\xBB\xBF# by hand\n" + kCorners + "f 1/9 2/9 3/9 # whole\n",
        kCorners + "vn 0 0 1\ng part\nusemtl steel\nl 1 2\np 1\nf 1//1 2//1 3//1\n", "f 1 2 3\n" + kCorners,
        std::string("v\t0\t0 0 1\r\nv 1 0 0\r\nv 0 +1e0 0\r\nf 1 \\\r\n 2\t\\\r\n3\r\n")}) {
    SCOPED_TRACE(text);
    EXPECT_DOUBLE_EQ(areaOf(readMeshFile(write("a.obj", text)).mesh), 0.5);
  }
}

TEST_F(MeshReader, AnStlFileIsReadHoweverItIsWritten) {
  const auto ball = ballMesh(6, 8);
  std::string bytes = stlBytes(ball);
  bytes.replace(0, 5, "solid");
  EXPECT_EQ(readMeshFile(write("solid.stl", bytes)).mesh.triangles.size(), ball.triangles.size());
  EXPECT_EQ(readMeshFile(write("more.stl", stlBytes(ball) + "more")).mesh.triangles.size(), ball.triangles.size());
  EXPECT_DOUBLE_EQ(
      areaOf(readMeshFile(write("a.stl",
                                "\nSOLID facet of vertex 1\r\nFACET NORMAL nan 0 1 OUTER LOOP VERTEX 0 0 0 "
                                "\nvertex 1 0 0 vertex 0 1 0 endloop endfacet ENDSOLID\n"
                                "solid\nfacet normal\nouter loop\nvertex 0 0 0\nvertex 2 0 0\n"
                                "vertex 0 1e0 0\nendloop\nendfacet\nendsolid"))
                 .mesh),
      1.5);
  const auto message = [&](const std::string& text) {
    return messageOf([&] { (void)readMeshFile(write("b.stl", text)); });
  };
  const std::string text = stlText(ball);
  expectSays(message(text.substr(0, text.rfind("endsolid"))), "the file ends before endsolid");
  expectSays(message("solid\nfacet normal 0 0 1\nvertex 0 0 0\nvertex 1 0 0\nendfacet\n"), "b.stl:5: this endfacet");
  expectSays(message("solid\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nvertex 1 1 0\nendfacet\nendsolid\n"),
             "three vertices");
  expectSays(message("solid\nvertex 0 0 1,5\n"), "b.stl:2: found '1,5', expected a finite number");
  expectSays(message("solid\nfacet normal 0 0 1\nouter ring\n"), "b.stl:3: found 'ring'");
}

/// Returns a PLY file of one triangle, with elements and properties that do not belong to a mesh.
std::string plyBytes(const std::string& format) {
  const bool is_text = format == "ascii";
  std::string bytes = "ply\nformat " + format +
                      " 1.0\ncomment by hand\nobj_info none\nelement camera 1\nproperty list ushort short zooms\n"
                      "element vertex 3\nproperty uchar red\nproperty double y\nproperty float32 x\nproperty int8 z\n"
                      "element nothing 2000000000\nelement face 1\nproperty list uint8 uint vertex_index\n"
                      "property float64 quality\nend_header\n";
  const auto append = [&](auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (format == "binary_big_endian") std::reverse(raw, raw + sizeof value);
    is_text ? void(bytes += fmt::format("{}{}", +value, bytes.size() % 3 ? " " : "\r\n"))
            : void(bytes.append(raw, sizeof value));
  };
  append(std::uint16_t{2}), append(std::int16_t{-300}), append(std::int16_t{7});
  for (const auto& [x, y] : {std::pair{0.F, 0.}, {2.F, 0.}, {0.F, 1.}})
    append(std::uint8_t{10}), append(y), append(x), append(std::int8_t{-3});
  append(std::uint8_t{3}), append(std::uint32_t{0}), append(std::uint32_t{1}), append(std::uint32_t{2}), append(0.5);
  return bytes;
}

TEST_F(MeshReader, APlyFileIsReadAsTextAndInEitherOrderOfBytes) {
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    SCOPED_TRACE(format);
    const std::string bytes = plyBytes(format);
    const auto mesh = readMeshFile(write("a.ply", bytes)).mesh;
    EXPECT_DOUBLE_EQ(areaOf(mesh), 1);
    EXPECT_EQ(mesh.vertices.at(1), Eigen::Vector3d(2, 0, -3));
    expectSays(messageOf([&] { (void)readMeshFile(write("b.ply", bytes.substr(0, bytes.size() - 7))); }),
               format == "ascii" ? "found the end of the file" : "the file ends");
  }
}

TEST_F(MeshReader, APlyFileThatContradictsItselfIsRefused) {
  const std::string complete = plyText(ballMesh(1, 4));
  const auto message = [&](const std::string& from, const std::string& to) {
    std::string text = complete;
    text.replace(text.find(from), from.size(), to);
    return messageOf([&] { (void)readMeshFile(write("a.ply", text)); });
  };
  expectSays(message("ply", "PLYX"), "a.ply:1: found 'PLYX', expected ply");
  expectSays(message("ascii", "utf8"), "binary_little_endian");
  expectSays(message("element vertex", "property float u\nelement vertex"), "before any element");
  expectSays(message("element vertex ", "element vertex -"), "the number of entries");
  expectSays(message("element vertex ", "element vertex 9"), "a.ply");
  expectSays(message("float y", "float x"), "the element vertex has the property x 2 times");
  expectSays(message("float y", "real y"), "a number type");
  expectSays(message("vertex_indices", "texture"), "the element face has the property vertex_indices 0 times");
  expectSays(message("end_header", "the_end"), "comment or end_header");
  expectSays(message("\n3 ", "\n2 "), "face 1 has fewer than three corners");
  expectSays(message("\n3 ", "\n-3 "), "the number -3");
  expectSays(message("\n3 ", "\n4000000000 "), "the number 4000000000");
  expectSays(message("\n3 ", "\n3 0.5 "), "the number 0.5");
}

TEST_F(MeshReader, FilesOnWhichALibraryCrashedAreRefused) {
  const auto message = [&](const std::string& name, const std::string& bytes) {
    return messageOf([&] { (void)readMeshFile(write(name, bytes)); });
  };
  // On these files assimp read past a material name, looped forever in a header, and overran a buffer.
  expectSays(message("a.obj", "dispv 0 0  3 \0\x7f\xff\xff\0mtllib v  " + std::string(10, '\xa1')), "no triangles");
  expectSays(
      message("a.ply",
              "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nelement face 2\nproperty list end_header"),
      "a number type");
  expectSays(message("a.stl", "\xfe\xff" + std::string(23, '\0') + "i"), "26 bytes");
}

TEST_F(MeshReader, PolygonsAreCutAndOtherFilesAreLeftAlone) {
  const auto square =
      write("square.obj", "mtllib /etc/passwd\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl x\nf 1 2 3 4\n");
  EXPECT_EQ(readMeshFile(square).mesh.triangles.size(), 2u);
}

TEST_F(MeshReader, APolygonThatPointsInwardsIsCutFromACornerThatSeesAllOthersOrRefused) {
  // An arrowhead must be divided into triangles from the corner from which all others are visible. A comb has no such
  // corner and must be refused.
  const auto arrow = readMeshFile(write("arrow.obj", "v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf 1 2 3 4\n")).mesh;
  EXPECT_NEAR(areaOf(arrow), 1, 1e-6);
  const auto comb = write("comb.obj",
                          "v 0 0 0\nv 5 0 0\nv 5 3 0\nv 4 3 0\nv 4 1 0\nv 3 1 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\n"
                          "v 1 3 0\nv 0 3 0\nf 1 2 3 4 5 6 7 8 9 10 11 12\n");
  expectSays(messageOf([&] { (void)readMeshFile(comb); }), "a face of 12 corners");
}

TEST_F(MeshReader, WhatIsNoMeshIsRefused) {
  const auto message = [](const std::string& file) { return messageOf([&] { (void)readMeshFile(file); }); };
  expectSays(message((folder / "none.stl").string()), "no such file");
  expectSays(message(write("part.step", "ISO-10303-21;")), "the file extension '.step'");
  expectSays(message(write("part", "solid")), "no file extension");
  expectSays(message(write("empty.stl", "")), "the file is empty");
  std::filesystem::create_directory(folder / "folder.stl");
  expectSays(message((folder / "folder.stl").string()), "not a regular file");
  expectSays(message(write("words.stl", "here is no mesh at all, only words that go on for a while, on and on and on")),
             "words.stl");
  expectSays(message(write("nothing.stl", "solid nothing\nendsolid nothing\n")), "nothing.stl");
  expectSays(message(write("long.obj", "v 0 0 0\nf" + std::string(2'000'000, ' ') + "\n")), "long.obj:2: found");
  expectSays(message(write("corner.obj", kCorners + "f 1 2 4\n")), "face 1 is not one of the 3 vertices");
  expectSays(message(write("word.obj", kCorners + "f 1 2 x\n")), "word.obj:4: found 'x'");
  expectSays(message(write("before.obj", kCorners + "f 1 2 -4\n")), "before.obj:4: found '-4'");
  expectSays(message(write("none.obj", kCorners + "f 1 2 0\n")), "the number of a vertex");
  expectSays(message(write("two.obj", kCorners + "f 1 2 # 3\n")), "three or more vertices");
  expectSays(message(write("flat.obj", "v 0 0\nv 1 0 0\n")), "flat.obj:1: found the end of the line");
  expectSays(message(write("free.obj", kCorners + "surf 0 1 0 1 1 2 3\n")), "free-form surfaces");
  expectSays(message(write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n")), "points.obj");
  expectSays(message(write("cut.stl", stlBytes(ballMesh(1, 8)).substr(0, 700))), "cut.stl");
  auto ball = ballMesh(1, 4);
  ball.vertices[3].x() = std::nan("");
  expectSays(message(write("nan.stl", stlBytes(ball))), "finite");
  const planner::TriangleMesh line{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
  expectSays(message(write("line.stl", stlText(line))), "degenerate");
}

TEST_F(MeshReader, ASpoiltFileIsReadOrRefused) {
  std::mt19937_64 generator(1);
  const auto ball = ballMesh(2, 5);
  const std::pair<const char*, std::string> files[] = {
      {"a.stl", stlText(ball)}, {"b.stl", stlBytes(ball)}, {"c.obj", objText(ball)}, {"d.ply", plyText(ball)}};
  int refused = 0;
  for (const auto& [name, complete] : files)
    for (int round = 0; round < 150; ++round) {
      std::string damaged = complete;
      for (int k = 0; k < 1 + round % 5; ++k) damaged[generator() % damaged.size()] = static_cast<char>(generator());
      if (round % 3 == 0) damaged.resize(generator() % damaged.size());
      const std::string path = write(name, damaged);
      try {
        EXPECT_EQ(planner::findMeshProblem(readMeshFile(path).mesh), "");
      } catch (const InputError&) {
        ++refused;
      }
    }
  EXPECT_GT(refused, 50);
}

}  // namespace
}  // namespace tubeplan::app
