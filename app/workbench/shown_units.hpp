// Units that a browser shows and takes, independent of the units of the cell's file.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "app/documents/converted_figures.hpp"
#include "app/workbench/exchange.hpp"
#include "app/workbench/session.hpp"

namespace tubeplan::app {

/// Units of length and angle of a request, from its query parameter `units`, such as "mm,deg" or ",rad"; an empty name
/// keeps the unit of the file.
class ShownUnits {
 public:
  /// Returns the units of the request; std::nullopt if it names none. Throws InputError for unknown units.
  [[nodiscard]] static std::optional<ShownUnits> of(const Request& request);

  /// Returns a document about the session's cell with all figures, names of units and sentences in these units.
  [[nodiscard]] nlohmann::json shown(nlohmann::json document, const Session& session) const;

  /// Returns an answer with its JSON converted as shown() does; other answers, such as files, stay as they are.
  [[nodiscard]] Answer shown(Answer answer, const Session& session) const;

  /// Returns a request whose figures are in the units of the cell's file.
  [[nodiscard]] Request inFileUnits(Request request, const Session& session) const;

  /// Returns the size of a length of the request [m]; `file` applies if these units name no length.
  [[nodiscard]] double lengthFactor(const Units& file) const;

 private:
  ShownUnits(const Unit* length, const Unit* angle) : length_(length), angle_(angle), target_(length, angle) {}

  const Unit *length_, *angle_;
  TargetUnits target_;
};

}  // namespace tubeplan::app
