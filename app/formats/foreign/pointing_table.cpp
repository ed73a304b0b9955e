#include "app/formats/foreign/pointing_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/formats/foreign/pointing_head.hpp"
#include "app/formats/foreign/sexagesimal.hpp"
#include "app/formats/foreign/sky_directions.hpp"
#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

constexpr std::size_t kAltazNumbers = 4, kStarNumbers = 14, kMeanNumbers = 17, kMostAuxiliary = 3;
constexpr std::size_t kSiderealMinutesAt = 13;
constexpr std::size_t kEquinoxAt = 8;  // index of the equinox in rows of mean places; other rows have seconds there

class PointingParser {
 public:
  PointingParser(std::string_view text, const std::string& file) : file_(file), lines_(pointingLines(text)) {
    table_.file = file;
    table_.has_heading = true;
    table_.separator = ' ';
    table_.columns = {"kind", "azimuth [deg]", "altitude [deg]", "joint 1 [deg]", "joint 2 [deg]"};
  }

  ForeignTable read() {
    head_ = readPointingHead(lines_, file_);
    if (head_.rows_from >= lines_.size())
      throw InputError::problem(file_, "there are no observations",
                                "add lines of 4 or 14 numbers below the record of the latitude");
    width_ = lines_[head_.rows_from].fields.size();
    checkKind(lines_[head_.rows_from]);
    for (std::size_t row = head_.rows_from; row < lines_.size(); ++row) addObservation(lines_[row]);
    remark();
    return std::move(table_);
  }

 private:
  void checkKind(const PointingLine& line) {
    const auto isOf = [&](std::size_t numbers) { return width_ >= numbers && width_ <= numbers + kMostAuxiliary; };
    if (width_ >= kMeanNumbers && signedNumber(line.fields[kEquinoxAt]).value_or(0) > 1000)
      throw InputError(lineOf(file_, line), fmt::format("a mean place of the equinox {}", line.fields[kEquinoxAt]),
                       "the apparent place of date (14 numbers), or azimuth and elevation (4 numbers)",
                       "convert the mean places first; precession, nutation and aberration are not applied here");
    if (!isOf(kAltazNumbers) && !isOf(kStarNumbers))
      throw InputError(lineOf(file_, line), fmt::format("{} numbers", width_),
                       "4 (azimuth, elevation, both as read) or 14 (right ascension, declination, both as read, "
                       "sidereal time), followed by up to 3 auxiliary readings");
    is_stars_ = isOf(kStarNumbers);
    if (!is_stars_ && !head_.is_altaz.value_or(false))
      throw InputError::problem(lineOf(file_, line), "the observation has 4 angles, but no option says ALTAZ",
                                "write the mount (`: ALTAZ`) above the latitude, or give stars (14 numbers)");
    refuseSidereal(line);
  }

  /// Throws InputError for a sidereal time with a separate number of seconds, which would be read as an auxiliary
  /// measurement.
  void refuseSidereal(const PointingLine& line) const {
    if (!is_stars_ || width_ == kStarNumbers) return;
    for (std::size_t row = head_.rows_from; row < lines_.size(); ++row)
      if (const auto& fields = lines_[row].fields; fields.size() > kSiderealMinutesAt)
        if (fields[kSiderealMinutesAt].find('.') != std::string::npos) return;
    throw InputError(lineOf(file_, line), "a sidereal time in whole minutes followed by more numbers",
                     "hours and decimal minutes, such as 16 23.130",
                     "write the seconds as a decimal fraction of the minutes");
  }

  /// Returns a right ascension or sidereal time, stated in hours, as an angle [deg].
  [[nodiscard]] double hours(const PointingLine& line, std::size_t from, std::size_t count) const {
    const double value = sixtiethsIn(file_, line, from, count, 24);
    if (value < 0) throw InputError(lineOf(file_, line), inQuotes(line.fields[from]) + " hours", "0 to 24");
    return kDegreesPerHour * value;
  }

  void addObservation(const PointingLine& line) {
    if (line.fields.size() != width_)
      throw InputError(lineOf(file_, line), fmt::format("{} numbers", line.fields.size()),
                       fmt::format("{}, as in line {}", width_, lines_[head_.rows_from].number));
    for (const auto& field : line.fields)
      if (!signedNumber(field)) throw InputError(lineOf(file_, line), inQuotes(field), "a number with a decimal point");
    if (is_stars_)
      addStar(line);
    else
      addAngles(line);
  }

  void addAngles(const PointingLine& line) {
    std::array<double, kAltazNumbers> numbers{};
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      numbers[k] = *signedNumber(line.fields[k]);
      const double most = k % 2 == 0 ? 720 : 180;
      if (std::abs(numbers[k]) > most)
        throw InputError(
            lineOf(file_, line), line.fields[k],
            k % 2 == 0 ? "an azimuth in degrees, within 720 of zero" : "an elevation in degrees, within 180 of zero");
    }
    addRow(line, {nearestTurn(-numbers[0]), numbers[1]}, nearestTurn(-numbers[2]), numbers[3]);
  }

  void addStar(const PointingLine& line) {
    const double time = hours(line, 12, 2);
    SkyDirection star = fromHourAngle(time - hours(line, 0, 3), sixtiethsIn(file_, line, 3, 3, 90), head_.latitude);
    const double hour_angle = time - hours(line, 6, 3), declination = sixtiethsIn(file_, line, 9, 3, 180);
    SkyDirection read{nearestTurn(-hour_angle), declination};
    if (head_.is_altaz.value_or(false)) read = fromHourAngle(hour_angle, declination, head_.latitude);
    const double refraction = refractionAt(star.altitude, head_.pressure.value_or(0), head_.temperature.value_or(0));
    greatest_refraction_ = std::max(greatest_refraction_, refraction);
    star.altitude += refraction;
    addRow(line, star, read.azimuth, read.altitude);
  }

  void addRow(const PointingLine& line, const SkyDirection& seen, double first, double second) {
    if (seen.altitude < 0)
      throw InputError::problem(lineOf(file_, line),
                                fmt::format("the direction is {:.2f} deg below the horizon", -seen.altitude),
                                "check the latitude's sign, the sidereal time and the order of the numbers");
    const auto text = [](double degrees) { return fmt::format("{:.7f}", degrees); };
    table_.rows.push_back(
        {line.number, {"direction", text(seen.azimuth), text(seen.altitude), text(first), text(second)}});
  }

  void remark() {
    auto& remarks = table_.remarks;
    const bool is_altaz = head_.is_altaz.value_or(false);
    remarks.emplace_back(
        "the world is x north, y west, z up: azimuths are counted from north by west, with the opposite sign of the "
        "file");
    remarks.emplace_back(is_altaz ? "joint 1 is the azimuth as read, counted likewise, joint 2 the elevation"
                                  : fmt::format("joint 1 is the hour angle as read, counted to the east, joint 2 the "
                                                "declination: an equatorial base is at rpy 0, {:.6f}, 180",
                                                head_.latitude - 90));
    if (!head_.is_altaz) remarks.emplace_back("no option states the mount: an equatorial mount is assumed");
    if (is_stars_) remarkOnStars();
    const std::size_t auxiliary = width_ - (is_stars_ ? kStarNumbers : kAltazNumbers);
    if (auxiliary > 0) remarks.push_back(fmt::format("the last {} of each row are left out", auxiliary));
  }

  void remarkOnStars() {
    auto& remarks = table_.remarks;
    remarks.emplace_back(
        "places are assumed to be apparent places of date; catalogue places would be wrong by minutes of arc");
    if (!head_.pressure)
      remarks.emplace_back("no pressure is stated: places are assumed to include refraction, and none is added");
    else
      remarks.push_back(fmt::format("refraction at {} hPa is added, up to {:.2f} minutes of arc, good to 0.1",
                                    *head_.pressure, greatest_refraction_ * 60));
    if (!head_.is_without_diurnal)
      remarks.emplace_back("no NODA: diurnal aberration, of 0.3 seconds of arc at most, is not added");
  }

  std::string file_;
  std::vector<PointingLine> lines_;
  PointingHead head_;
  ForeignTable table_;
  std::size_t width_ = 0;  ///< number of fields in each observation
  bool is_stars_ = false;
  double greatest_refraction_ = 0;  ///< largest refraction among the observations [deg]
};

}  // namespace

bool isPointingData(std::string_view text) {
  constexpr std::size_t kPlace = 1, kFirst = 2;
  const auto lines = pointingLines(text);
  if (lines.size() < 2 || areAllNumbers(lines[0].fields) || lines[0].text.starts_with(':')) return false;
  if (isPointingOption(lines[1])) return true;
  return lines.size() > kFirst && areAllNumbers(lines[kPlace].fields) && lines[kPlace].fields.size() >= 3 &&
         lines[kPlace].fields.size() <= 12 && areAllNumbers(lines[kFirst].fields) &&
         lines[kFirst].fields.size() >= kStarNumbers && lines[kFirst].fields.size() != lines[kPlace].fields.size();
}

ForeignTable parsePointingData(std::string_view text, const std::string& file) {
  return PointingParser(text, file).read();
}

}  // namespace tubeplan::app
