// Table of layout types, one row per type. To add a type, write its function and add a row.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tubesheets/layout.hpp"

namespace tubeplan::tubesheets {

/// A value that a layout type needs or accepts, a length [m] or a count, and the member of Layout that stores it.
struct LayoutKey {
  std::string_view name;
  std::variant<double Layout::*, int Layout::*> field;
  /// True if the value must be given and positive; false if it is optional and may be zero.
  bool required = false;
  std::string_view meaning;
};

struct LayoutType {
  std::string_view name;
  std::string_view sentence;
  std::vector<LayoutKey> keys;
  /// True if the layout covers the full sheet; false if it covers the hot leg and is mirrored for the cold leg.
  bool covers_full_sheet = false;
  int columns_modulo_two = -1;  ///< required parity of a given number of columns: 0 for even, 1 for odd, -1 for either
  std::vector<Tube> (*make_tubes)(const Layout&) = nullptr;
};

[[nodiscard]] const std::vector<LayoutType>& layoutTypes();

/// Returns the layout type with that name, or null if there is none.
[[nodiscard]] const LayoutType* findLayoutType(std::string_view name);

/// Returns the names of all layout types for messages: "square, triangular, disc".
[[nodiscard]] std::string layoutTypeNames();

}  // namespace tubeplan::tubesheets
