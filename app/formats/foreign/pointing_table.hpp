// Pointing data of telescopes, as TPOINT reads them and mounts' programs write them: a caption, option records
// (": ALTAZ"), one record of latitude, date and weather, then one observation a line, up to END.
//
// What an observation is follows from how many numbers it has: 4 are azimuth and elevation as observed and as the mount
// read them [deg, from north by east]; 14 are right ascension (h m s) and declination (d m s) of the star and as the
// mount read them, and the sidereal time (h m). Sources: what RTS2, ACP and the Apache Point telescopes write, and
// cosmos-pointing, which reads it. TPOINT's manual has more; what is not among these is refused.
#pragma once

#include "app/formats/foreign/foreign_table.hpp"

namespace tubeplan::app {

/// Returns whether a text has a caption, then option records or a record of a latitude with observations behind it.
[[nodiscard]] bool isPointingData(std::string_view text);

/// Returns readings of kind `direction` in degrees: azimuth (north towards west) and altitude, and what the two joints
/// read, turned likewise: azimuth and elevation, or of an equatorial mount the hour angle towards east and the
/// declination. `remarks` say what the file leaves open. Throws InputError for what is not understood.
[[nodiscard]] ForeignTable parsePointingData(std::string_view text, const std::string& file);

}  // namespace tubeplan::app
