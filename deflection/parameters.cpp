#include "deflection/parameters.hpp"

#include <cassert>
#include <cmath>

#include "deflection/effects/effect.hpp"
#include "deflection/row_numbers.hpp"

namespace tubeplan::deflection {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Returns a row with every kind of value that a row with this placement and joint type can have.
Row<double> fullRow(const std::variant<DenavitHartenberg<double>, Origin<double>>& placement, JointType type) {
  Row<double> row;
  row.placement = placement;
  row.joint.type = type;
  row.beam.emplace();
  row.weight.lumps.resize(1);
  return row;
}

/// Returns the parameter fields of a row, in the order in which arm files list them.
std::vector<ParameterField> rowFields() {
  std::vector<ParameterField> fields;
  const auto add = [&](const RowNumber& about, double&) {
    if (!about.name || !about.is_parameter) return;
    fields.push_back({about.name, about.quantity, about.lower, about.upper, false, about.lump >= 0});
  };
  // A joint's offset replaces theta, so only rows that do not move have a theta.
  Row<double> by_dh = fullRow(DenavitHartenberg<double>{}, JointType::kPassive),
              by_origin = fullRow(Origin<double>{}, JointType::kRevolute);
  visitPlacements(add, by_dh);
  visitNumbers(add, by_origin);
  return fields;
}

/// Returns a pointer to the value of a row that `field` describes (null if the row has none), and the value's quantity
/// in that row.
template <class S>
std::pair<S*, Quantity> findIn(Row<S>& row, const ParameterField& field, int lump) {
  std::pair<S*, Quantity> found{nullptr, field.quantity};
  visitNumbers(
      [&](const RowNumber& about, S& number) {
        if (about.is_parameter && about.name && about.name == field.name && (!field.of_lump || about.lump == lump))
          found = {&number, about.quantity};
      },
      row);
  return found;
}

}  // namespace

const std::vector<ParameterField>& parameterFields() {
  static const std::vector<ParameterField> kFields = [] {
    std::vector<ParameterField> fields = rowFields();
    for (const char* tip : {"tip.x", "tip.y", "tip.z"})
      fields.push_back({tip, Quantity::kLength, -kInfinity, kInfinity, true, false});
    for (const char* turn : {"turn.x", "turn.y", "turn.z"})
      fields.push_back({turn, Quantity::kAngle, -kFullTurn, kFullTurn, true, false});
    return fields;
  }();
  return kFields;
}

double* findNumber(Row<double>& row, const ParameterField& field, int lump) { return findIn(row, field, lump).first; }
Dual* findNumber(Row<Dual>& row, const ParameterField& field, int lump) { return findIn(row, field, lump).first; }

namespace {

/// Returns a coordinate of the tip or of the tool's rotation vector.
template <class S>
S& locateInTool(ArmOf<S>& arm, const ParameterField& f) {
  return (f.quantity == Quantity::kLength ? arm.p_LT : arm.tool_turn_L)[f.name.back() - 'x'];
}

/// Returns the rows of the arm (`side_chain` -1) or of a side chain.
template <class S>
std::vector<Row<S>>& rowsOf(ArmOf<S>& arm, int side_chain) {
  return side_chain < 0 ? arm.rows : arm.side_chains.at(side_chain).rows;
}

template <class S>
S& locateIn(ArmOf<S>& arm, const ParameterPath& path) {
  if (path.effect >= 0) return arm.effects.at(path.effect).values.at(path.value);
  const ParameterField& f = parameterFields().at(path.field);
  if (f.of_tool) return locateInTool(arm, f);
  Row<S>& row = rowsOf(arm, path.side_chain).at(path.row);
  S* found = findNumber(row, f, path.lump);
  assert(found);
  return *found;
}

template <class To, class From>
To castScalar(const From& x) {
  return To(valueOf(x));
}
template <class To, class From>
Vector3<To> castVector(const Vector3<From>& v) {
  return valuesOf(v).template cast<To>();
}

template <class To, class From>
TipLoad<To> castTipLoad(const TipLoad<From>& a) {
  return {castVector<To>(a.payload_offset), castScalar<To>(a.contact_force), castVector<To>(a.force),
          castVector<To>(a.moment)};
}

/// Returns a row of the same structure, without copying the numeric values.
template <class To, class From>
Row<To> shapeOf(const Row<From>& row) {
  Row<To> out;
  out.name = row.name;
  out.placed_by = row.placed_by;
  out.is_written = row.is_written;
  if (!dhOf(row)) out.placement = Origin<To>{};
  const auto& j = row.joint;
  out.joint = {j.name,          j.type,       To(0),    j.lower, j.upper, j.max_speed, j.max_acceleration,
               j.encoder_sigma, j.gear_ratio, j.follows};
  if (row.beam) out.beam.emplace().segments = row.beam->segments;
  out.weight.lumps.resize(row.weight.lumps.size());
  if (!row.effect_terms) return out;
  const auto& from = *row.effect_terms;
  auto& terms = out.effect_terms.emplace();
  terms.joint_is_compliant = from.joint_is_compliant;
  terms.member_is_compliant = from.member_is_compliant;
  terms.bends = from.bends;
  terms.has_gap = from.has_gap;
  terms.attached_weights.resize(from.attached_weights.size());
  return out;
}

template <class To, class From>
Row<To> castRow(const Row<From>& row) {
  Row<To> out = shapeOf<To>(row);
  visitNumbers([](const RowNumber&, To& to, const From& from) { to = castScalar<To>(from); }, out, row);
  return out;
}

Parameter makeParameter(Arm& arm, const ParameterPath& path) {
  const ParameterField& f = parameterFields()[path.field];
  Row<double>* row = f.of_tool ? nullptr : &rowsOf(arm, path.side_chain)[path.row];
  std::string name = row ? nameInFile(*row, f.name) : "tool." + std::string(f.name);
  if (f.of_lump) name.append(".").append(std::to_string(path.lump + 1));
  const Quantity quantity = row ? findIn(*row, f, path.lump).second : f.quantity;
  return {name, quantity, path, locateIn(arm, path), f.lower, f.upper};
}

void appendRowParameters(Arm& arm, int side_chain, int index, std::vector<Parameter>& out) {
  const auto& fields = parameterFields();
  Row<double>& row = rowsOf(arm, side_chain)[index];
  for (int f = 0; f < static_cast<int>(fields.size()); ++f) {
    if (fields[f].of_tool || !isInFile(row, fields[f].name)) continue;
    if (fields[f].name == kShiftOfFirstAxis && (index > 0 || side_chain >= 0)) continue;
    const int lumps = static_cast<int>(row.weight.lumps.size());
    for (int lump = fields[f].of_lump ? 0 : -1; lump < (fields[f].of_lump ? lumps : 0); ++lump) {
      const double* number = findNumber(row, fields[f], lump);
      if (number && std::isfinite(*number))
        out.push_back(makeParameter(arm, {.row = index, .field = f, .lump = lump, .side_chain = side_chain}));
    }
  }
}

void appendRowsParameters(Arm& arm, int side_chain, std::vector<Parameter>& out) {
  for (int row = 0; row < static_cast<int>(rowsOf(arm, side_chain).size()); ++row)
    appendRowParameters(arm, side_chain, row, out);
}

template <class To, class From>
EffectOf<To> castEffect(const EffectOf<From>& effect) {
  EffectOf<To> out{effect.kind, effect.place, {}, effect.formula};
  for (const From& value : effect.values) out.values.push_back(castScalar<To>(value));
  return out;
}

void appendEffectParameters(const Arm& arm, int index, std::vector<Parameter>& out) {
  const Effect& effect = arm.effects[index];
  const auto& numbers = numbersOf(effect);
  for (int k = 0; k < static_cast<int>(numbers.size()); ++k) {
    const EffectNumber number = numberOf(arm, effect, k);
    out.push_back({textOf(arm, effect) + "." + numbers[k].name, number.quantity, ParameterPath{-1, -1, -1, index, k},
                   effect.values.at(k), number.lower, number.upper});
  }
}

}  // namespace

template <class To, class From>
ArmOf<To> castArm(const ArmOf<From>& arm) {
  ArmOf<To> out;
  out.name = arm.name;
  out.gravity_W = castVector<To>(arm.gravity_W);
  for (const auto& row : arm.rows) out.rows.push_back(castRow<To>(row));
  out.p_LT = castVector<To>(arm.p_LT);
  out.tool_axis_L = castVector<To>(arm.tool_axis_L);
  out.R_LT = arm.R_LT;
  out.tool_turn_L = castVector<To>(arm.tool_turn_L);
  out.reference = arm.reference;
  for (const auto& effect : arm.effects) out.effects.push_back(castEffect<To>(effect));
  for (const auto& chain : arm.side_chains) {
    out.side_chains.push_back({chain.row, {}});
    for (const auto& row : chain.rows) out.side_chains.back().rows.push_back(castRow<To>(row));
  }
  out.mountings = arm.mountings;
  if (arm.tip_load) out.tip_load = castTipLoad<To>(*arm.tip_load);
  return out;
}

template ArmOf<Dual> castArm<Dual, double>(const ArmOf<double>&);
template ArmOf<double> castArm<double, Dual>(const ArmOf<Dual>&);

double& locate(Arm& arm, const ParameterPath& path) { return locateIn(arm, path); }
Dual& locate(ArmOf<Dual>& arm, const ParameterPath& path) { return locateIn(arm, path); }

std::vector<Parameter> parametersOf(const Arm& arm) {
  Arm copy = arm;
  std::vector<Parameter> parameters;
  appendRowsParameters(copy, -1, parameters);
  for (int b = 0; b < static_cast<int>(copy.side_chains.size()); ++b) appendRowsParameters(copy, b, parameters);
  const auto& fields = parameterFields();
  for (int f = 0; f < static_cast<int>(fields.size()); ++f)
    if (fields[f].of_tool) parameters.push_back(makeParameter(copy, {-1, f, -1}));
  for (int e = 0; e < static_cast<int>(arm.effects.size()); ++e) appendEffectParameters(arm, e, parameters);
  return parameters;
}

std::optional<Parameter> findParameter(const Arm& arm, std::string_view name) {
  for (auto& parameter : parametersOf(arm))
    if (parameter.name == name) return parameter;
  return std::nullopt;
}

}  // namespace tubeplan::deflection
