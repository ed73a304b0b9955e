#include "app/documents/si_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/figure_list.hpp"
#include "app/documents/figure_units.hpp"
#include "app/formats/units.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

/// SI units in the order of UnitKind.
constexpr std::array<std::string_view, 6> kSiNames{"m", "rad", "N", "N*m", "K", "s"};

const Unit* unitNamed(std::string_view name) {
  const auto unit = std::ranges::find(unitTable(), name, &Unit::name);
  return unit == unitTable().end() ? nullptr : &*unit;
}

/// Returns the SI unit of one factor of a product, such as "in^4".
std::optional<SiUnit> siPower(std::string_view text) {
  const auto caret = text.find('^');
  const auto exponent = caret == text.npos ? std::optional(1) : tubesheets::parseInteger(text.substr(caret + 1));
  const Unit* unit = unitNamed(text.substr(0, caret));
  if (!unit || !exponent) return std::nullopt;
  SiUnit si{std::string(kSiNames.at(static_cast<std::size_t>(unit->kind))), std::pow(unit->factor, *exponent)};
  if (caret != text.npos) si.si += text.substr(caret);
  return si;
}

/// Returns the SI unit of a product, such as "lbf*in" or "(lbf*in)".
std::optional<SiUnit> siProduct(std::string_view text) {
  const bool is_enclosed = text.starts_with('(') && text.ends_with(')');
  std::string_view rest = is_enclosed ? text.substr(1, text.size() - 2) : text;
  SiUnit product{is_enclosed ? "(" : "", 1};
  while (true) {
    const auto star = rest.find('*');
    const auto one = siPower(rest.substr(0, star));
    if (!one) return std::nullopt;
    product.si += one->si;
    product.factor *= one->factor;
    if (star == rest.npos) break;
    product.si += "*";
    rest.remove_prefix(star + 1);
  }
  if (is_enclosed) product.si += ")";
  return product;
}

void scale(json& value, double factor) {
  if (value.is_array())
    for (auto& one : value) scale(one, factor);
  else if (value.is_number())
    value = value.get<double>() * factor;
}

class SiDocument {
 public:
  SiDocument(const json& document, std::span<const JointInFile> joints) : joints_(joints), document_(document) {
    const json units = document.value("units", json::object());
    angle_ = siUnitOf(units.value("angle", "rad")).value_or(SiUnit{});
    length_ = siUnitOf(units.value("length", "m")).value_or(SiUnit{});
    for (const Figure& figure : figuresOf(document)) convert(figure);
    rename(document_, false);
  }

  [[nodiscard]] const json& document() const { return document_; }

 private:
  void convert(const Figure& figure) {
    const json::json_pointer place("/" + figure.key());
    if (figure.unit.empty() || !document_.contains(place)) return;
    json& value = document_[place];
    if (figure.unit == kOfTheJoint) return convertJoints(value, place.back());
    if (figure.unit == kOfShiftAndTurn) return convertCovariance(value);
    if (figure.unit == kOfLengthAndFraction) {
      for (auto& point : value) scale(point.at(0), length_.factor);
      return;
    }
    if (const auto unit = siUnitOf(figure.unit)) scale(value, unit->factor);
  }

  void convertJoints(json& value, const std::string& key) const {
    const auto factorOf = [&](const JointInFile& joint) { return joint.is_slide ? length_.factor : angle_.factor; };
    if (value.is_array() && value.size() == joints_.size()) {
      for (std::size_t k = 0; k < joints_.size(); ++k) scale(value[k], factorOf(joints_[k]));
      return;
    }
    const auto joint = std::ranges::find(joints_, key, &JointInFile::name);
    scale(value, joint == joints_.end() ? angle_.factor : factorOf(*joint));
  }

  /// Converts a covariance of shifts along x, y and z, and of turns about them.
  void convertCovariance(json& rows) const {
    const auto factorOf = [&](std::size_t k) { return k < 3 ? length_.factor : angle_.factor; };
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < rows[i].size(); ++j) scale(rows[i][j], factorOf(i) * factorOf(j));
  }

  /// Replaces the names of units: values of `unit` and `..._unit`, and all that `units` has.
  static void rename(json& value, bool is_unit) {
    if (value.is_string() && is_unit) {
      if (const auto unit = siUnitOf(value.get<std::string>())) value = unit->si;
      return;
    }
    if (value.is_array())
      for (auto& one : value) rename(one, false);
    if (!value.is_object()) return;
    for (auto& [key, inner] : value.items()) {
      if (key == "units" && inner.is_object())
        for (auto& [name, unit] : inner.items()) rename(unit, true);
      else
        rename(inner, key == "unit" || key.ends_with("_unit"));
    }
  }

  std::span<const JointInFile> joints_;
  json document_;
  SiUnit angle_, length_;
};

}  // namespace

std::optional<SiUnit> siUnitOf(std::string_view name) {
  if (const Unit* unit = unitNamed(name); unit && unit->kind == UnitKind::kTemperature)
    return SiUnit{std::string(name), 1};
  const auto slash = name.find('/');
  const std::string_view over = name.substr(0, slash);
  auto unit = over == "1" && slash != name.npos ? std::optional(SiUnit{"1", 1}) : siProduct(over);
  if (!unit || slash == name.npos) return unit;
  const auto under = siProduct(name.substr(slash + 1));
  if (!under) return std::nullopt;
  return SiUnit{unit->si + "/" + under->si, unit->factor / under->factor};
}

nlohmann::json inSiUnits(const nlohmann::json& document, std::span<const JointInFile> joints) {
  return SiDocument(document, joints).document();
}

}  // namespace tubeplan::app
