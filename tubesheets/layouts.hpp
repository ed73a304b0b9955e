// The table of layout types, one row per type. A new pattern needs a function and a row.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tubesheets/layout.hpp"

namespace tubeplan::tubesheets {

/// A value that a layout type takes, a length [m] or a count, and the member of Layout that holds it.
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
  bool covers_full_sheet = false;  ///< true: the full sheet; false: one leg, mirrored for the cold leg
  int columns_modulo_two = -1;     ///< required remainder of a stated number of columns modulo two; -1: any
  std::vector<Tube> (*make_tubes)(const Layout&) = nullptr;
};

[[nodiscard]] const std::vector<LayoutType>& layoutTypes();

/// Returns the layout type with that name, or null if there is none.
[[nodiscard]] const LayoutType* findLayoutType(std::string_view name);

/// Returns the names of all layout types for messages: "square, triangular, disc".
[[nodiscard]] std::string layoutTypeNames();

}  // namespace tubeplan::tubesheets
