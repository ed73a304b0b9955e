// Descriptions of all numeric values of a row: name in files, messages and fits, quantity and bounds. Casts between
// scalar types, derivatives, parameters, the arm reader and the arm writer all use this list.
#pragma once

#include <array>
#include <cassert>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

#include "deflection/arm.hpp"
#include "deflection/quantity.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::deflection {

/// Part of a row that a value belongs to: the placement; the flexibility, at the origin or along the member; or the
/// loads (including the joint's offset).
enum class RowPart { kPlacement, kFlexibility, kLoad };

struct RowNumber {
  /// Name within the row, such as "joint_stiffness.z"; null for values that effects add, which arm files do not
  /// contain.
  const char* name = nullptr;
  Quantity quantity = Quantity::kNone;
  double lower = -std::numeric_limits<double>::infinity();  ///< physical bounds in internal units
  double upper = std::numeric_limits<double>::infinity();
  RowPart part = RowPart::kLoad;
  int lump = -1;  ///< index of the lump that has the value; -1 if none
  /// Default, which files may omit; NaN if there is no default.
  double left_out = std::numeric_limits<double>::quiet_NaN();
  /// True if fits can estimate the value, and it is not redundant with the joint's reading or offset.
  bool is_parameter = false;
};

/// Returns a value's key in a map of the row's file entry ("beam" or "dh"); empty if the value is not in that map.
inline std::string_view keyIn(std::string_view map, const RowNumber& about) {
  const std::string_view name = about.name ? about.name : "";
  const bool is_there = about.lump < 0 && name.size() > map.size() && name.starts_with(map) && name[map.size()] == '.';
  return is_there ? name.substr(map.size() + 1) : std::string_view();
}

/// Name of the parameter b, which is redundant except in an arm's first row.
inline constexpr std::string_view kShiftOfFirstAxis = "dh.b";

/// Returns true if the parameter named `number` places the row's axis relative to the previous row.
inline bool leadsToAxis(std::string_view number) {
  return number == "dh.alpha" || number == "dh.a" || number == "dh.beta" || number == kShiftOfFirstAxis;
}

/// Returns true if the arm file contains the row's value named `number`.
template <class S>
bool isInFile(const Row<S>& row, std::string_view number) {
  return row.placed_by && leadsToAxis(number) ? !row.placed_by->empty() : row.is_written;
}

/// Returns the name of a row's value in the arm file and in fits, such as "forearm.dh.a"; empty if the file has none.
template <class S>
std::string nameInFile(const Row<S>& row, std::string_view number) {
  if (!isInFile(row, number)) return "";
  if (row.placed_by && leadsToAxis(number))
    return *row.placed_by + std::string(number.substr(std::string_view("dh").size()));
  return row.name + "." + std::string(number);
}

template <class R>
using ScalarOf = std::remove_cvref_t<decltype(std::declval<R&>().joint.offset)>;

/// Return a row's Denavit-Hartenberg parameters or its origin; null if the row is placed by the other notation.
template <class R>
auto* dhOf(R& row) {
  return std::get_if<DenavitHartenberg<ScalarOf<R>>>(&row.placement);
}
template <class R>
auto* originOf(R& row) {
  return std::get_if<Origin<ScalarOf<R>>>(&row.placement);
}

/// For each axis, calls `visit(about, components...)` with that component of all given vectors.
template <class Visit, class... V>
void visitVectors(const RowNumber& about, const std::array<const char*, 3>& names, Visit&& visit, V&... vectors) {
  for (int k = 0; k < 3; ++k) {
    RowNumber component = about;
    component.name = names[static_cast<std::size_t>(k)];
    visit(component, vectors[k]...);
  }
}

template <class Visit, class R, class... Rest>
void visitPlacements(Visit&& visit, R& row, Rest&... rest) {
  assert(((row.placement.index() == rest.placement.index()) && ...));
  const RowNumber length{.quantity = Quantity::kLength, .part = RowPart::kPlacement, .is_parameter = true};
  const RowNumber angle{.quantity = Quantity::kAngle,
                        .lower = -kFullTurn,
                        .upper = kFullTurn,
                        .part = RowPart::kPlacement,
                        .is_parameter = true};
  const auto named = [](RowNumber about, const char* name) { return about.name = name, about; };
  RowNumber lean = angle;
  lean.left_out = 0;
  if (auto* dh = dhOf(row)) {
    visit(named(angle, "dh.alpha"), dh->alpha, dhOf(rest)->alpha...);
    visit(named(length, "dh.a"), dh->a, dhOf(rest)->a...);
    visit(named(length, "dh.d"), dh->d, dhOf(rest)->d...);
    RowNumber theta = named(angle, "dh.theta");
    theta.is_parameter = !turns(row.joint);
    visit(theta, dh->theta, dhOf(rest)->theta...);
    visit(named(lean, "dh.beta"), dh->beta, dhOf(rest)->beta...);
    RowNumber shift = named(length, "dh.b");
    shift.left_out = 0;
    return visit(shift, dh->b, dhOf(rest)->b...);
  }
  visitVectors(length, {"origin.position.x", "origin.position.y", "origin.position.z"}, visit, originOf(row)->position,
               originOf(rest)->position...);
  visitVectors(angle, {"origin.rpy.r", "origin.rpy.p", "origin.rpy.y"}, visit, originOf(row)->rpy,
               originOf(rest)->rpy...);
  visit(named(lean, "origin.beta"), originOf(row)->beta, originOf(rest)->beta...);
}

/// Visits the values that effects add to flexibilities; skips them unless all rows have effect terms.
template <class Visit, class... R>
void visitEffectFlexibilities(Visit&& visit, R&... rows) {
  if (!(rows.effect_terms && ...)) return;
  const RowNumber about{.part = RowPart::kFlexibility};
  visitVectors(about, {}, visit, rows.effect_terms->compliance...);
  visitVectors(about, {}, visit, rows.effect_terms->softness...);
  visitVectors(about, {}, visit, rows.effect_terms->soft_compliance...);
  visitVectors(about, {}, visit, rows.effect_terms->knee...);
  visitVectors(about, {}, visit, rows.effect_terms->gap...);
  visitVectors(about, {}, visit, rows.effect_terms->bending_compliance...);
  visit(about, rows.effect_terms->torsion_compliance...);
}

template <class Visit, class R, class... Rest>
void visitFlexibilities(Visit&& visit, R& row, Rest&... rest) {
  constexpr double kTiny = 1e-12;
  const auto number = [](Quantity quantity, double lower, const char* name = nullptr) {
    return RowNumber{
        .name = name, .quantity = quantity, .lower = lower, .part = RowPart::kFlexibility, .is_parameter = true};
  };
  visitVectors(number(Quantity::kTorquePerAngle, kTiny),
               {"joint_stiffness.x", "joint_stiffness.y", "joint_stiffness.z"}, visit, row.joint_stiffness,
               rest.joint_stiffness...);
  assert(((row.beam.has_value() == rest.beam.has_value()) && ...));
  if (row.beam) {
    visit(number(Quantity::kPressure, kTiny, "beam.E"), row.beam->E, rest.beam->E...);
    visitVectors(number(Quantity::kLengthToTheFourth, 0), {"beam.Ix", "beam.Iy", "beam.Iz"}, visit, row.beam->I,
                 rest.beam->I...);
    visit(number(Quantity::kPressure, kTiny, "beam.G"), row.beam->G, rest.beam->G...);
    visit(number(Quantity::kLengthToTheFourth, 0, "beam.J"), row.beam->J, rest.beam->J...);
  }
  visitEffectFlexibilities(visit, row, rest...);
}

/// Visits corresponding lumps of all rows; `weight_of` describes their weights.
template <class Visit, class L, class... Rest>
void visitLumps(const RowNumber& weight_of, Visit&& visit, L& lumps, Rest&... rest) {
  assert(((lumps.size() == rest.size()) && ...));
  for (std::size_t k = 0; k < lumps.size(); ++k) {
    RowNumber weight = weight_of;
    weight.lump = static_cast<int>(k);
    visit(weight, lumps[k].weight, rest[k].weight...);
    visitVectors({.quantity = Quantity::kLength, .lump = weight.lump}, {}, visit, lumps[k].at, rest[k].at...);
  }
}

template <class Visit, class R, class... Rest>
void visitOffsets(Visit&& visit, R& row, Rest&... rest) {
  visit(RowNumber{.name = "joint.offset",
                  .quantity = row.joint.type == JointType::kPrismatic ? Quantity::kLength : Quantity::kAngle,
                  .lower = -kFullTurn,
                  .upper = kFullTurn,
                  .is_parameter = moves(row.joint)},
        row.joint.offset, rest.joint.offset...);
}

template <class Visit, class R, class... Rest>
void visitLoads(Visit&& visit, R& row, Rest&... rest) {
  const RowNumber along{
      .name = "weight.distributed", .quantity = Quantity::kForcePerLength, .lower = 0, .is_parameter = true};
  const RowNumber weight{.name = "weight.end", .quantity = Quantity::kForce, .lower = 0, .is_parameter = true};
  visit(along, row.weight.distributed, rest.weight.distributed...);
  visit(weight, row.weight.end, rest.weight.end...);
  RowNumber lump = weight;
  lump.name = "weight.lumps";
  visitLumps(lump, visit, row.weight.lumps, rest.weight.lumps...);
  if (!(row.effect_terms && ... && rest.effect_terms.has_value())) return;
  visitVectors({}, {}, visit, row.effect_terms->end_force, rest.effect_terms->end_force...);
  visitLumps({}, visit, row.effect_terms->attached_weights, rest.effect_terms->attached_weights...);
}

/// Calls `visit(about, numbers...)` for every number of the rows, in the order in which arm files list the numbers. All
/// rows must have the same structure.
template <class Visit, class... R>
void visitNumbers(Visit&& visit, R&... rows) {
  visitPlacements(visit, rows...);
  visitOffsets(visit, rows...);
  visitFlexibilities(visit, rows...);
  visitLoads(visit, rows...);
}

}  // namespace tubeplan::deflection
