#include "app/files/mesh_reader.hpp"

#include <random>

#include "tests/app/files/mesh_files.hpp"
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

TEST_F(MeshReader, PolygonsAreCutAndOtherFilesAreLeftAlone) {
  const auto square =
      write("square.obj", "mtllib /etc/passwd\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl x\nf 1 2 3 4\n");
  EXPECT_EQ(readMeshFile(square).mesh.triangles.size(), 2u);
}

TEST_F(MeshReader, APolygonThatPointsInwardsIsCutFromACornerThatSeesAllOthersOrRefused) {
  // An arrow head, and a comb that no corner sees all of.
  const auto arrow = readMeshFile(write("arrow.obj", "v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf 1 2 3 4\n")).mesh;
  double area = 0;
  for (const auto& [a, b, c] : arrow.triangles) {
    const auto& v = arrow.vertices;
    area += 0.5 * (v[static_cast<std::size_t>(b)] - v[static_cast<std::size_t>(a)])
                      .cross(v[static_cast<std::size_t>(c)] - v[static_cast<std::size_t>(a)])
                      .norm();
  }
  EXPECT_NEAR(area, 1, 1e-6);
  const auto comb = write("comb.obj",
                          "v 0 0 0\nv 5 0 0\nv 5 3 0\nv 4 3 0\nv 4 1 0\nv 3 1 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\n"
                          "v 1 3 0\nv 0 3 0\nf 1 2 3 4 5 6 7 8 9 10 11 12\n");
  expectSays(messageOf([&] { (void)readMeshFile(comb); }), "triangulated unambiguously");
}

TEST_F(MeshReader, WhatIsNoMeshIsRefused) {
  const auto message = [](const std::string& file) { return messageOf([&] { (void)readMeshFile(file); }); };
  expectSays(message((folder / "none.stl").string()), "no such file");
  expectSays(message(write("part.step", "ISO-10303-21;")), "another kind");
  expectSays(message(write("part", "solid")), "another kind");
  expectSays(message(write("empty.stl", "")), "an empty file");
  std::filesystem::create_directory(folder / "folder.stl");
  expectSays(message((folder / "folder.stl").string()), "not a regular file");
  expectSays(message(write("words.stl", "here is no mesh at all, only words that go on for a while, on and on and on")),
             "words.stl");
  expectSays(message(write("nothing.stl", "solid nothing\nendsolid nothing\n")), "nothing.stl");
  expectSays(message(write("long.obj", "v 0 0 0\nf" + std::string(200000, ' ') + "\n")), "long.obj:2: found a line of");
  std::string carried_on = "f ";
  for (int k = 0; k < 5000; ++k) carried_on += "1 2 3 \\\n";
  expectSays(message(write("carried.obj", carried_on)), "a line of more than");
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
  for (const auto& [name, whole] : files)
    for (int round = 0; round < 150; ++round) {
      std::string spoilt = whole;
      for (int k = 0; k < 1 + round % 5; ++k) spoilt[generator() % spoilt.size()] = static_cast<char>(generator());
      if (round % 3 == 0) spoilt.resize(generator() % spoilt.size());
      const std::string path = write(name, spoilt);
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
