// A session keeps all small result documents, and as many of the large ones as its limit allows.
#include "app/workbench/session.hpp"

#include <gtest/gtest.h>

#include "app/workbench/project.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

json listing(std::size_t measurements) { return {{"readings", std::vector<int>(measurements)}}; }

TEST(Session, OldDocumentsOfOtherModelsGiveWayToNewOnes) {
  Session session;
  const Cell cell = readCell((shippedCells() / "bench.yaml").string());
  for (int k = 0; k < 8; ++k) {
    const int id = pushModel(session, std::to_string(k), "fit", cell);
    ++session.revision;
    putResult(session, "compare", id, listing(10000));
    putResult(session, "identify", id, {{"parameters", json::array()}});
  }
  EXPECT_EQ(session.results["identify"].size(), 8u) << "those without readings are small";
  EXPECT_EQ(session.results["compare"].size(), 4u);
  const int last = currentModel(session).id;
  for (int id = last - 3; id <= last; ++id) EXPECT_TRUE(findResult(session, "compare", id)) << id;

  session.current = 0;  // after going back, the results of the current model are kept, those of others discarded
  ++session.revision;
  putResult(session, "compare", currentModel(session).id, listing(10000));
  ++session.revision;
  putResult(session, "diagnose", currentModel(session).id, listing(40000));
  EXPECT_TRUE(findResult(session, "compare", currentModel(session).id));
  EXPECT_TRUE(findResult(session, "diagnose", currentModel(session).id));
  EXPECT_EQ(session.results["compare"].size(), 1u);
}

class KeptSession : public FolderTest {};

/// Results in a project of an earlier version are converted to the current names of their keys and the current sign of
/// errors.
TEST_F(KeptSession, ResultsOfAnEarlierProgramAreReadFromItsProjects) {
  Session session;
  const int id = pushModel(session, "as given", "given", readCell((shippedCells() / "bench.yaml").string()));
  putResult(session, "ladder", id, {{"rungs", {{{"name", "as given"}, {"rms", 1}}}}});
  putResult(session, "diagnose", id, {{"pairs", {{{"probability_told", 0.5}}}}});
  putResult(session, "compare", id, {{"readings", {{{"error_before", {1, -2, nullptr}}, {"error_after", {0, 0, 3}}}}}});
  const Session read = readProject(write("before.tubeplan", projectText(session)));
  const json compared = findResult(read, "compare", id)->document;
  EXPECT_EQ(compared["readings"][0]["error_before"], json({-1, 2, nullptr}));
  EXPECT_EQ(compared["errors"], "measured less predicted");
  EXPECT_EQ(findResult(read, "ladder", id)->document, json({{"models", {{{"name", "as given"}, {"rms", 1}}}}}));
  EXPECT_EQ(findResult(read, "diagnose", id)->document, json({{"pairs", {{{"probability_distinguished", 0.5}}}}}));
}

}  // namespace
}  // namespace tubeplan::app
