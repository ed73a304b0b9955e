// Pointing data of telescopes, in the format of TPOINT and of mounts' programs: a caption, option records (": ALTAZ"),
// one record of latitude, date and weather, then one observation a line, up to END.
//
// The number of fields determines the content of an observation. 4 fields are azimuth and elevation as observed and as
// the mount read them [deg, from north by east]. 14 fields are right ascension (h m s) and declination (d m s) of the
// star and as the mount read them, and the sidereal time (h m). Sources: files of RTS2, ACP and the Apache Point
// telescopes, and cosmos-pointing, which reads such files. Other records of TPOINT's manual are refused.
#pragma once

#include "app/formats/foreign/foreign_table.hpp"

namespace tubeplan::app {

/// Returns true if a text has a caption, then option records or a record of a latitude with observations after it.
[[nodiscard]] bool isPointingData(std::string_view text);

/// Returns readings of kind `direction` in degrees: azimuth (north towards west) and altitude, and the readings of the
/// two joints. These are azimuth and elevation with the same senses, or for an equatorial mount the hour angle towards
/// east and the declination. `remarks` name the assumptions that the file leaves open. Throws InputError for unknown
/// content.
[[nodiscard]] ForeignTable parsePointingData(std::string_view text, const std::string& file);

}  // namespace tubeplan::app
