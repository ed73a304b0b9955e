// Parser of telescope pointing data in the format of TPOINT and of programs for mounts: a caption, option records (":
// ALTAZ"), one record of latitude, date and weather, then one observation per line, up to END.
//
// The number of fields determines the content of an observation. 4 fields are azimuth and elevation as observed, then
// as read by the mount [deg, from north by east]. 14 fields are right ascension (h m s) and declination (d m s) of the
// star, then as read by the mount, and the sidereal time (h m). Sources: files of RTS2, ACP and the Apache Point
// telescopes, and cosmos-pointing, which reads such files. Other records in TPOINT's manual are rejected.
#pragma once

#include "app/formats/foreign/foreign_table.hpp"

namespace tubeplan::app {

/// Returns true if the text has a caption, followed by option records or by a record of a latitude and observations.
[[nodiscard]] bool isPointingData(std::string_view text);

/// Returns measurements of kind `direction` in degrees: azimuth (from north towards west) and altitude of the target,
/// and the readings of the two joints. For an altazimuth mount the joints are azimuth and elevation with the same
/// senses. For an equatorial mount they are the hour angle towards east and the declination. `remarks` list the
/// assumptions made about data that the file does not state. Throws InputError for unknown content.
[[nodiscard]] ForeignTable parsePointingData(std::string_view text, const std::string& file);

}  // namespace tubeplan::app
