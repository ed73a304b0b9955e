// The table of layout types, one row per type. To add a pattern, add its function and its row.
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
  bool required = false;  ///< true: must be stated and above zero; false: may be left out, and must be zero or more
  std::string_view meaning;
};

struct LayoutType {
  std::string_view name;
  std::string_view sentence;
  std::vector<LayoutKey> keys;
  bool covers_full_sheet = false;  ///< true: holes of the full sheet; false: of the hot leg, mirrored for the cold leg
  int columns_modulo_two = -1;     ///< 0: a stated number of columns must be even; 1: odd; -1: either
  std::vector<Tube> (*make_tubes)(const Layout&) = nullptr;
};

[[nodiscard]] const std::vector<LayoutType>& layoutTypes();

/// Returns the layout type with that name, or null if there is none.
[[nodiscard]] const LayoutType* findLayoutType(std::string_view name);

/// Returns the names of all layout types for messages: "square, triangular, disc".
[[nodiscard]] std::string layoutTypeNames();

}  // namespace tubeplan::tubesheets
