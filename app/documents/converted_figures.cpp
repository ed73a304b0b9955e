#include "app/documents/converted_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/documents/figure_list.hpp"
#include "app/documents/figure_units.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

double factorOf(const std::string& unit, const TargetUnits& target) {
  return convertedUnit(unit, target).value_or(ConvertedUnit{}).factor;
}

/// Key of an object that describes a file of another program, whose unit is that file's.
constexpr std::string_view kForeignFile = "mesh";

class FigureConverter {
 public:
  FigureConverter(const FileFigures& file, const TargetUnits& target)
      : file_(file), target_(target), fallback_{{"units", {{"length", file.length}, {"angle", file.angle}}}} {}

  void convertAll(json& document) {
    length_ = factorOf(nameIn(document, "length"), target_);
    angle_ = factorOf(nameIn(document, "angle"), target_);
    scopes_ = {&document, &fallback_};
    convert(document, "", "");
    rename(document, false, false);
  }

 private:
  [[nodiscard]] std::string nameIn(const json& document, const char* kind) const {
    const json::json_pointer place(fmt::format("/units/{}", kind));
    const json& from = document.contains(place) && document[place].is_string() ? document : fallback_;
    return from[place].get<std::string>();
  }

  /// Converts the figures contained in a value. `path` holds the keys that lead to it, without indices of lists, and
  /// `key` the last of them.
  void convert(json& value, const std::string& path, const std::string& key) {
    if (isPlain(value)) return convertPlain(value, path, key);
    scopes_.push_back(&value);
    for (auto& [name, inner] : value.items())
      value.is_array() ? convert(inner, path, key) : convert(inner, path.empty() ? name : path + "/" + name, name);
    scopes_.pop_back();
  }

  void convertPlain(json& value, const std::string& path, const std::string& key) {
    if (!hasReal(value)) return;
    const std::string unit = units_.at(path, scopes_);
    if (unit.empty()) return;
    if (unit == kOfTheJoint) return convertJoints(value, key);
    if (unit == kOfShiftAndTurn) return convertCovariance(value);
    if (unit == kOfLengthAndFraction) {
      for (auto& point : value) scaleNumbers(point.at(0), length_);
      return;
    }
    if (unit == kOfEachNumber) return convertEach(value);
    scaleNumbers(value, factorOf(unit, target_));
  }

  [[nodiscard]] double factorOfJoint(const JointInFile& joint) const { return joint.is_slide ? length_ : angle_; }

  void convertJoints(json& value, const std::string& key) const {
    if (value.is_array() && !value.empty() && value.front().is_array()) {
      for (json& item : value) convertJoints(item, key);
      return;
    }
    if (value.is_array() && value.size() == file_.joints.size()) {
      for (std::size_t k = 0; k < file_.joints.size(); ++k) scaleNumbers(value[k], factorOfJoint(file_.joints[k]));
      return;
    }
    const auto joint = std::ranges::find(file_.joints, key, &JointInFile::name);
    scaleNumbers(value, joint == file_.joints.end() ? angle_ : factorOfJoint(*joint));
  }

  /// Converts a covariance of shifts along x, y and z, and of turns about them.
  void convertCovariance(json& rows) const {
    const auto factor = [&](std::size_t k) { return k < 3 ? length_ : angle_; };
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < rows[i].size(); ++j) scaleNumbers(rows[i][j], factor(i) * factor(j));
  }

  /// Converts numbers whose units the document lists under `units_of_each`.
  void convertEach(json& numbers) const {
    const json& units = scopes_.front()->at("units_of_each");
    for (std::size_t k = 0; k < std::min(numbers.size(), units.size()); ++k)
      scaleNumbers(numbers[k], factorOf(units[k].get<std::string>(), target_));
  }

  /// Replaces the names of units: values of `unit`, `..._unit` and `units_of_each`, and all that `units` has.
  void rename(json& value, bool is_unit, bool is_map) const {
    if (value.is_string() && is_unit) {
      if (const auto unit = convertedUnit(value.get<std::string>(), target_)) value = unit->name;
      return;
    }
    if (value.is_array())
      for (auto& item : value) rename(item, is_unit, false);
    if (!value.is_object()) return;
    for (auto& [key, inner] : value.items()) {
      const bool names_units = key == "units" || key == "units_of_each" || key == "unit" || key.ends_with("_unit");
      if (key != kForeignFile) rename(inner, is_map || names_units, key == "units");
    }
  }

  const FileFigures& file_;
  const TargetUnits& target_;
  json fallback_;
  double length_ = 1, angle_ = 1;
  FigureUnits units_;
  std::vector<const json*> scopes_;
};

}  // namespace

void scaleNumbers(json& value, double factor) {
  if (value.is_array())
    for (auto& item : value) scaleNumbers(item, factor);
  else if (value.is_number())
    value = value.get<double>() * factor;
}

json inUnits(json document, const FileFigures& file, const TargetUnits& target) {
  if (!document.is_structured()) return document;
  FigureConverter(file, target).convertAll(document);
  return document;
}

}  // namespace tubeplan::app
