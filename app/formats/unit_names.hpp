// Names of units such as "lbf*in/deg", expressed in other units.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "app/formats/units.hpp"

namespace tubeplan::app {

/// Unit in terms of another: 1 of the converted unit is `factor` of `name`.
struct ConvertedUnit {
  std::string name;
  double factor = 1;
};

/// Units into which values are converted, one for each kind of unit.
class TargetUnits {
 public:
  /// Returns the units of the SI. Temperatures alone keep their unit, because a value may be a difference.
  [[nodiscard]] static TargetUnits si();

  /// Replaces only lengths and angles; null keeps the unit as well.
  TargetUnits(const Unit* length, const Unit* angle);

  [[nodiscard]] ConvertedUnit of(const Unit& unit) const;

 private:
  struct Target {
    std::string_view name = {};  ///< empty if units of this kind stay
    double size = 1;             ///< size of the target unit [internal units]
  };
  std::array<Target, 6> targets_{};  ///< in the order of UnitKind
};

/// Returns the conversion of a unit of files, such as "lbf*in/deg" or "1/(lbf*in)": in units of the SI it is N*m/rad,
/// with the factor. std::nullopt for names that are not products of units, such as "percent".
[[nodiscard]] std::optional<ConvertedUnit> convertedUnit(std::string_view name, const TargetUnits& target);

}  // namespace tubeplan::app
