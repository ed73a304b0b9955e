#include "app/formats/sheet/touched_base.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/formats/measurements/measurements_reader.hpp"
#include "app/formats/measurements/measurements_writer.hpp"
#include "app/formats/yaml/yaml_edit.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"

namespace tubeplan::app {

namespace {

constexpr const char* kKey = "touched";

/// Returns several lines of text as a YAML block scalar or, for a flow map, as a quoted string on one line.
std::string linesText(const std::string& text, bool is_flow) {
  std::string lines = is_flow ? "\"" : "|\n    ";
  for (std::size_t k = 0; k + 1 < text.size(); ++k) {
    if (text[k] == '\n')
      lines += is_flow ? "\\n" : "\n    ";
    else if (is_flow && (text[k] == '"' || text[k] == '\\'))
      lines += std::string("\\") + text[k];
    else
      lines += text[k];
  }
  return lines + (is_flow ? "\\n\"" : "");
}

}  // namespace

void readTouched(const YamlNode& node, Cell& cell) {
  node.expectKeys({"readings"}, {"numbers", "values"});
  const std::string table = node.at("readings").text();
  cell.placed_by = PlacedByTouches{
      parseMeasurements(table, node.at("readings").where(), cell.arm, cell.sheet ? &*cell.sheet : nullptr), cell.arm};
  for (const auto& touch : cell.placed_by->touches)
    if (!touchesKnownPoint(touch))
      node.at("readings")
          .failWithProblem(fmt::format("reading {} is not a touch of a known place", inQuotes(touch.id)),
                           "list only touches that placed the base");
  const YamlNode *names = node.find("numbers"), *values = node.find("values");
  if (!names && !values) return;
  const auto& list = node.at("numbers").list();
  const auto& numbers = node.at("values").list(list.size(), fmt::format("{} numbers", list.size()));
  for (std::size_t k = 0; k < list.size(); ++k) {
    const auto parameter = deflection::findParameter(cell.arm, list[k].text());
    if (!parameter)
      list[k].fail("the unknown number '" + list[k].text() + "'", "the path of a number in the arm file",
                   suggestion(list[k].text(), calibration::freeableNames(cell.arm)));
    deflection::locate(cell.arm, parameter->path) =
        cell.units.toInternal(numbers[k].number(), dimensionOf(parameter->quantity));
  }
}

std::string withTouched(const std::string& text, const Cell& cell, const std::vector<calibration::Measurement>& touches,
                        const deflection::Arm& arm) {
  const bool is_flow = cell.source.root.is_flow;
  std::vector<std::string> names, values;
  for (const auto& parameter : deflection::parametersOf(arm)) {
    const auto filed = deflection::findParameter(cell.filedArm(), parameter.name);
    if (!filed || filed->value == parameter.value) continue;
    names.push_back('"' + parameter.name + '"');
    values.push_back(fmt::format("{}", parameter.value / cell.units.factor(dimensionOf(parameter.quantity))));
  }
  const std::string table = linesText(measurementsCsv(touches, arm, cell.units), is_flow);
  const std::string numbers = fmt::format("[{}]", fmt::join(names, ", ")),
                    found = fmt::format("[{}]", fmt::join(values, ", "));
  const std::string value = is_flow
                                ? fmt::format("{{numbers: {}, values: {}, readings: {}}}", numbers, found, table)
                                : fmt::format("\n  numbers: {}\n  values: {}\n  readings: {}", numbers, found, table);
  return withYamlValue(withoutTouched(text), kKey, value);
}

std::string withoutTouched(const std::string& text) {
  const YamlNode root = parseYaml(text, kKey);
  return root.find(kKey) ? withoutYamlValue(text, kKey) : text;
}

void forgetTouches(CellModel& cell) {
  if (!cell.placed_by) return;
  cell.arm = cell.placed_by->filed_arm;
  cell.placed_by.reset();
}

}  // namespace tubeplan::app
