#include "app/outage/identity.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "app/storage/count_text.hpp"

namespace tubeplan::app {

namespace {

constexpr double kNearHole = 0.4;  // largest distance from a hole's centre at which a position is at the hole [pitches]

/// Returns a description of the difference between the addresses of a tube and of the intended tube.
std::string differenceOf(const TubeAddress& meant, const TubeAddress& found) {
  if (found.generator != meant.generator) return "it is in another steam generator";
  if (found.leg != meant.leg) return "it is in the other leg";
  const auto distance = [](int one, int other) { return static_cast<std::size_t>(std::abs(one - other)); };
  const std::string rows = countText(distance(found.row, meant.row), "row");
  const std::string columns = countText(distance(found.column, meant.column), "column");
  if (found.column == meant.column) return fmt::format("it is {} off", rows);
  if (found.row == meant.row) return fmt::format("it is {} off", columns);
  return fmt::format("it is {} and {} off", rows, columns);
}

const TubeEnd* findEnd(const std::vector<TubeEnd>& ends, const TubeAddress& tube) {
  for (const TubeEnd& end : ends)
    if (end.tube == tube) return &end;
  return nullptr;
}

/// Returns true if the found hole is the mirror image of the intended hole in the plane x = 0.
bool isMirrorImage(const std::vector<TubeEnd>& ends, const TubeAddress& meant, const TubeEnd& found, double near) {
  const TubeEnd* of_meant = findEnd(ends, meant);
  return of_meant && std::hypot(found.x + of_meant->x, found.y - of_meant->y) < near;
}

}  // namespace

IdentityFinding compareRead(const TubeAddress& meant, const TubeAddress& read) {
  if (meant == read) return {true, addressText(read), ""};
  return {false, addressText(read), differenceOf(meant, read)};
}

IdentityFinding comparePosition(const TubeAddress& meant, double x, double y, const std::vector<TubeEnd>& ends,
                                double pitch) {
  const TubeEnd* nearest = nullptr;
  double least = kNearHole * pitch;
  for (const TubeEnd& end : ends)
    if (const double distance = std::hypot(end.x - x, end.y - y); distance < least) {
      least = distance;
      nearest = &end;
    }
  if (!nearest) return {false, "", "the position is not at a hole of this steam generator"};
  if (nearest->tube == meant) return {true, addressText(meant), ""};
  std::string reason = differenceOf(meant, nearest->tube);
  if (isMirrorImage(ends, meant, *nearest, kNearHole * pitch)) reason += ", its mirror image: check the map's columns";
  return {false, addressText(nearest->tube), reason};
}

std::string findWrongMethod(const WorkPackage& package, std::string_view method) {
  const auto required_method = confirmationName(package.confirm);
  if (package.confirm == ConfirmationMethod::kNone || method == required_method) return "";
  return fmt::format("the package {} asks for a confirmation by {}, not by {}", package.name, required_method, method);
}

std::string findMissingConfirmation(const WorkPackage& package, const std::vector<JobEvent>& events_of_item,
                                    const std::string& person) {
  if (package.confirm == ConfirmationMethod::kNone) return "";
  const JobEvent* latest = nullptr;
  for (const JobEvent& event : events_of_item) {
    if (event.kind == "mark" || event.kind == "undo") latest = nullptr;
    if (event.kind == "confirm") latest = &event;
  }
  if (!latest) return "the identity of the tube is not confirmed";
  if (const std::string wrong = findWrongMethod(package, latest->method); !wrong.empty()) return wrong;
  if (latest->value != "same") return fmt::format("the last confirmation found {}", latest->value);
  if (package.confirm == ConfirmationMethod::kReadBack && isSamePerson(latest->person, person))
    return fmt::format("the tube was read back by {}, who also marks it; another person must read it", latest->person);
  return "";
}

}  // namespace tubeplan::app
