// Job files that contradict themselves are refused where the fault is, and no record appears.
#include "app/outage/job_file.hpp"

#include "app/outage/job_shifts.hpp"
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
      {"from: \"06:00\"", "from: \"05:00\"", "day and night overlap at 05:00"},
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

TEST_F(JobFiles, EveryTimeOfDayIsInOneShift) {
  (void)write("states.csv", "row,column,state\n10,20,plugged\n");
  const JobFile job = readJobFile(write("gap.yaml", changed(valid(), "from: \"18:00\"", "from: \"20:00\"")));
  ASSERT_EQ(job.shifts.size(), 3u);
  EXPECT_EQ(job.shifts[2].name, "18:00-20:00");
  EXPECT_EQ(shiftAt("2025-04-02T19:00:00Z", job.shifts), (ShiftOfDay{"2025-04-02", "18:00-20:00"}));
  EXPECT_EQ(endOf({"2025-04-02", "18:00-20:00"}, job.shifts), "2025-04-02T20:00:00Z");
}

TEST_F(JobFiles, ARecordWhoseShiftsOverlapIsStillRead) {
  const std::string text = changed(valid(), "from: \"06:00\"", "from: \"05:00\"");
  EXPECT_NE(messageOf([&] { (void)readJobFile(write("overlap.yaml", text)); }), "");
  const JobFile job = parseJobFile(text, "overlap.yaml");
  EXPECT_EQ(shiftAt("2025-04-02T05:30:00Z", job.shifts).name, "day");
}

TEST_F(JobFiles, ATableOfStatesMustStateThemForItsOwnSteamGenerator) {
  const char* package = "  - {name: rows, tubes: R9C18, tool: bobbin}\n";
  const std::pair<const char*, const char*> faults[] = {
      {"Row,Col,Zustand\n10,20,plugged\n", "no state of any tube"},
      {"row,column\n10,20\n", "no state of any tube"},
      {"row,column,code\n10,20,XYZ\n", "no state of any tube"},
      {"sg,row,column,state\nB,10,20,plugged\n", "steam generator B"}};
  for (const auto& [states, says] : faults) {
    SCOPED_TRACE(states);
    expectSays(messageOf([&] { (void)made(package, states); }), says);
  }
}

TEST_F(JobFiles, AListMustNotOpenATubeThatIsPlugged) {
  (void)write("list.csv", "row,column,state\n9,18,open\n10,20,open\n");
  expectSays(messageOf([&] { (void)made("  - {name: rows, tubes: list.csv, tool: bobbin}\n"); }),
             "R10C20 is open according to the list, but plugged before the job");
}

TEST_F(JobFiles, APackageWithHalfOfItsTimeIsNamed) {
  (void)write("states.csv", "row,column,state\n10,20,plugged\n");
  const auto notesOf = [&](const std::string& text, const char* record) {
    return JobStore::create(readJobFile(write("job.yaml", text)), (folder / record).string());
  };
  const std::string long_enough = changed(valid(), "confirm: none", "confirm: none, length: 720");
  EXPECT_EQ(notesOf(valid(), "a.record").size(), 1u);
  EXPECT_TRUE(notesOf(long_enough, "b.record").empty());
  EXPECT_EQ(notesOf(changed(long_enough, "speed: 40, ", ""), "c.record").size(), 1u);
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
