// Records in write-protected files and folders: they are read, leave no trace, and take no marks.
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "app/outage/hand_over_json.hpp"
#include "app/outage/job_desk.hpp"
#include "app/outage/job_json.hpp"
#include "tests/app/outage/job_fixture.hpp"

namespace tubeplan::app {
namespace {

using std::filesystem::perms;

constexpr const char* kFree = "  - {name: rows, tubes: R9-11C18-22, tool: bobbin, confirm: none}\n";
constexpr perms kNobodyWrites = perms::owner_write | perms::group_write | perms::others_write;

/// Scope in which the superuser acts as an ordinary user, because protection does not bind the superuser.
class AsOrdinaryUser {
 public:
  AsOrdinaryUser() : user_(::geteuid()) { EXPECT_EQ(::seteuid(user_ == 0 ? 65534 : user_), 0); }
  ~AsOrdinaryUser() { EXPECT_EQ(::seteuid(user_), 0); }

 private:
  uid_t user_;
};

struct Protection {
  bool of_file, of_folder;
};

class ProtectedRecord : public JobTest, public testing::WithParamInterface<Protection> {
 protected:
  ProtectedRecord() : path_(made(kFree)) {
    // others may write what the test does not protect
    std::filesystem::permissions(folder, perms::all);
    std::filesystem::permissions(path_, perms::all);
  }
  ~ProtectedRecord() override { std::filesystem::permissions(folder, perms::all); }

  void protect() const {
    if (GetParam().of_file) std::filesystem::permissions(path_, kNobodyWrites, std::filesystem::perm_options::remove);
    if (GetParam().of_folder)
      std::filesystem::permissions(folder, kNobodyWrites, std::filesystem::perm_options::remove);
  }

  static void mark(JobStore& store, int column) {
    (void)markTube(store, {{"A", tubesheets::Leg::kHot, 9, column}, "", "done", {"Tom", "", ""}, std::nullopt});
  }

  [[nodiscard]] long filesInFolder() const {
    return std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator());
  }

  std::string path_;
};

TEST_P(ProtectedRecord, IsReadAndTakesNoMarks) {
  {
    JobStore writer(path_);
    mark(writer, 18);
  }
  protect();
  const long before = filesInFolder();
  const AsOrdinaryUser ordinary;
  {
    JobStore store(path_, Database::Mode::kRead);
    EXPECT_EQ(totalsOf(store).all.of(ItemStanding::kDone), 1);
    EXPECT_EQ(store.events().size(), 1u);
    EXPECT_TRUE(findNext(store, {}));
    EXPECT_FALSE(handOverText(handOverJson(store, handOverOf(store, {}), {}, presentTime())).empty());
  }
  EXPECT_EQ(filesInFolder(), before);
  expectSays(messageOf([&] {
               JobStore store(path_);
               mark(store, 19);
             }),
             "cannot be opened for writing");
}

TEST_P(ProtectedRecord, ShowsWhatAnotherProgramHasJustWritten) {
  JobStore writer(path_);
  mark(writer, 18);
  ASSERT_GT(std::filesystem::file_size(path_ + "-wal"), 0u);
  protect();
  const AsOrdinaryUser ordinary;
  JobStore store(path_, Database::Mode::kRead);
  EXPECT_EQ(store.events().size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(OfFileAndFolder, ProtectedRecord,
                         testing::Values(Protection{true, false}, Protection{false, true}, Protection{true, true}));

}  // namespace
}  // namespace tubeplan::app
