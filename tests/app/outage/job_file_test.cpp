// Job files that contradict themselves are refused where the fault is, and no record appears.
#include "app/outage/job_file.hpp"

#include "tests/app/outage/job_fixture.hpp"

namespace tubeplan::app {
namespace {

class JobFiles : public JobTest {
 protected:
  [[nodiscard]] std::string valid() const {
    return jobText("  - {name: rows, tubes: R9-11C18-22, tool: bobbin, confirm: none}\n");
  }
};

struct Fault {
  const char *from, *to, *says;
};

TEST_F(JobFiles, EveryFaultIsRefusedAtItsPlace) {
  (void)write("states.csv", "row,column,state\n10,20,plugged\n");
  const Fault faults[] = {
      {"job: test\n", "", "job"},
      {"name: B", "name: A", "twice"},
      {"name: B", "name: 'B C'", "letters"},
      {"cold: mirrored, states", "full: mirrored, states", "mirror"},
      {"tool: bobbin", "tool: bobin", "did you mean 'bobbin'"},
      {"speed: 40", "speed: -40", "zero or more"},
      {"confirm: none", "confirm: nobody", "read-back"},
      {"from: \"06:00\"", "from: \"6 am\"", "time of day"},
      {"R9-11C18-22", "R90C1", "R90"},
      {"states: states.csv", "states: nothere.csv", "no such file"},
      {"shifts:", "shiftz:", "did you mean 'shifts'"},
      {"job: test\n", "job: test\napart: [[A/hot, C/cold]]\n", "A/hot, A/cold, B/hot or B/cold"},
      {"job: test\n", "job: test\napart: [[A/hot]]\n", "two legs or more"},
      {"job: test\n", "job: test\napart: [[A/hot, A/hot]]\n", "named twice"},
  };
  for (const Fault& fault : faults) {
    SCOPED_TRACE(fault.to);
    const std::string file = write("faulty.yaml", changed(valid(), fault.from, fault.to));
    const std::string record = (folder / "faulty.record").string();
    expectSays(messageOf([&] { JobStore::create(readJobFile(file), record); }), fault.says);
    EXPECT_FALSE(std::filesystem::exists(record));
    EXPECT_FALSE(std::filesystem::exists(record + ".new"));
  }
}

TEST_F(JobFiles, AStateOfATubeThatTheSheetLacksIsRefused) {
  expectSays(messageOf([&] {
               (void)made("  - {name: rows, tubes: R9C18, tool: bobbin}\n", "row,column,state\n49,1,plugged\n");
             }),
             "R49C1");
}

TEST_F(JobFiles, LegsWhoseCellsAreExchangedAreRefused) {
  const std::string cell = (shippedCells() / "mockup.yaml").string();
  const std::string file = write(
      "job.yaml", changed(changed(valid(), "hot: '" + cell, "cold: '" + cell), "cold: mirrored", "hot: mirrored"));
  (void)write("states.csv", "row,column,state\n10,20,plugged\n");
  expectSays(messageOf([&] { JobStore::create(readJobFile(file), (folder / "x.record").string()); }), "exchange");
}

TEST_F(JobFiles, ARecordIsNeverOverwrittenNorTakenForAnotherFile) {
  const std::string path = made("  - {name: rows, tubes: R9C18, tool: bobbin}\n");
  const std::string before = contentOf(path);
  expectSays(messageOf([&] { JobStore::create(readJobFile((folder / "job.yaml").string()), path); }), "exists");
  EXPECT_EQ(contentOf(path), before);
  expectSays(
      messageOf([&] { JobStore other(write("text.record", "not a database, but long enough to be looked at\n")); }),
      "not the record of a job");
  expectSays(messageOf([&] { JobStore other((folder / "none.record").string()); }), "no such file");
  {
    Database empty((folder / "empty.record").string(), Database::Mode::kCreate);
    empty.execute("CREATE TABLE other (x)");
  }
  expectSays(messageOf([&] { JobStore other((folder / "empty.record").string()); }), "not the record of a job");
}

}  // namespace
}  // namespace tubeplan::app
