#include "deflection/parameters.hpp"

#include <cassert>
#include <cmath>

#include "deflection/effects/effect.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::deflection {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTiny = 1e-12;

/// Both scalar versions of one accessor, a generic lambda from (row, lump) to a pointer.
template <class Find>
ParameterField field(const char* name, Quantity quantity, double lower, double upper, Find, bool of_lump = false) {
  return {name,
          quantity,
          lower,
          upper,
          false,
          of_lump,
          [](Row<double>& row, int lump) { return Find{}(row, lump); },
          [](Row<Dual>& row, int lump) { return Find{}(row, lump); }};
}

ParameterField toolField(const char* name) {
  return {name, Quantity::kLength, -kInfinity, kInfinity, true, false, nullptr, nullptr};
}

template <class S>
DenavitHartenberg<S>* dhOf(Row<S>& row) {
  return std::get_if<DenavitHartenberg<S>>(&row.placement);
}
template <class S>
Origin<S>* originOf(Row<S>& row) {
  return std::get_if<Origin<S>>(&row.placement);
}
template <class S>
bool moves(const Row<S>& row) {
  return row.joint.type != JointType::kPassive || !row.joint.follows.empty();
}

/// A number of what places a row, of rows that are placed so.
template <class Find, class Of>
ParameterField placementField(const char* name, Quantity quantity, Find, Of) {
  const double most = quantity == Quantity::kAngle ? kFullTurn : kInfinity;
  return field(name, quantity, -most, most, [](auto& r, int) {
    auto* placement = Find{}(r);
    return placement ? Of{}(*placement) : nullptr;
  });
}

template <class Of>
ParameterField dhField(const char* name, Quantity quantity, Of of) {
  return placementField(
      name, quantity, [](auto& r) { return dhOf(r); }, of);
}
template <class Of>
ParameterField originField(const char* name, Quantity quantity, Of of) {
  return placementField(
      name, quantity, [](auto& r) { return originOf(r); }, of);
}

}  // namespace

const std::vector<ParameterField>& parameterFields() {
  using Q = Quantity;
  static const std::vector<ParameterField> kFields{
      dhField("dh.alpha", Q::kAngle, [](auto& dh) { return &dh.alpha; }),
      dhField("dh.a", Q::kLength, [](auto& dh) { return &dh.a; }),
      dhField("dh.d", Q::kLength, [](auto& dh) { return &dh.d; }),
      field("dh.theta", Q::kAngle, -kFullTurn, kFullTurn,
            [](auto& r, int) {
              auto* dh = dhOf(r);
              return dh && !moves(r) ? &dh->theta : nullptr;
            }),
      originField("origin.position.x", Q::kLength, [](auto& origin) { return &origin.position[0]; }),
      originField("origin.position.y", Q::kLength, [](auto& origin) { return &origin.position[1]; }),
      originField("origin.position.z", Q::kLength, [](auto& origin) { return &origin.position[2]; }),
      originField("origin.rpy.r", Q::kAngle, [](auto& origin) { return &origin.rpy[0]; }),
      originField("origin.rpy.p", Q::kAngle, [](auto& origin) { return &origin.rpy[1]; }),
      originField("origin.rpy.y", Q::kAngle, [](auto& origin) { return &origin.rpy[2]; }),
      field("joint.offset", Q::kAngle, -kFullTurn, kFullTurn,
            [](auto& r, int) { return moves(r) ? &r.joint.offset : nullptr; }),
      field("joint_stiffness.x", Q::kTorquePerAngle, kTiny, kInfinity,
            [](auto& r, int) { return &r.joint_stiffness[0]; }),
      field("joint_stiffness.y", Q::kTorquePerAngle, kTiny, kInfinity,
            [](auto& r, int) { return &r.joint_stiffness[1]; }),
      field("joint_stiffness.z", Q::kTorquePerAngle, kTiny, kInfinity,
            [](auto& r, int) { return &r.joint_stiffness[2]; }),
      field("beam.E", Q::kPressure, kTiny, kInfinity, [](auto& r, int) { return r.beam ? &r.beam->E : nullptr; }),
      field("beam.Ix", Q::kLengthToTheFourth, 0, kInfinity,
            [](auto& r, int) { return r.beam ? &r.beam->I[0] : nullptr; }),
      field("beam.Iy", Q::kLengthToTheFourth, 0, kInfinity,
            [](auto& r, int) { return r.beam ? &r.beam->I[1] : nullptr; }),
      field("beam.Iz", Q::kLengthToTheFourth, 0, kInfinity,
            [](auto& r, int) { return r.beam ? &r.beam->I[2] : nullptr; }),
      field("beam.G", Q::kPressure, kTiny, kInfinity, [](auto& r, int) { return r.beam ? &r.beam->G : nullptr; }),
      field("beam.J", Q::kLengthToTheFourth, 0, kInfinity, [](auto& r, int) { return r.beam ? &r.beam->J : nullptr; }),
      field("weight.distributed", Q::kForcePerLength, 0, kInfinity, [](auto& r, int) { return &r.weight.distributed; }),
      field("weight.end", Q::kForce, 0, kInfinity, [](auto& r, int) { return &r.weight.end; }),
      field(
          "weight.lumps", Q::kForce, 0, kInfinity, [](auto& r, int lump) { return &r.weight.lumps[lump].weight; },
          true),
      toolField("tip.x"),
      toolField("tip.y"),
      toolField("tip.z"),
  };
  return kFields;
}

namespace {

int toolAxis(const ParameterField& f) { return f.name[4] - 'x'; }

/// Those of the arm, or of a side chain.
template <class S>
std::vector<Row<S>>& rowsOf(ArmOf<S>& arm, int side_chain) {
  return side_chain < 0 ? arm.rows : arm.side_chains.at(side_chain).rows;
}

template <class S>
S& locateIn(ArmOf<S>& arm, const ParameterPath& path) {
  if (path.effect >= 0) return arm.effects.at(path.effect).values.at(path.value);
  const ParameterField& f = parameterFields().at(path.field);
  if (f.of_tool) return arm.p_LT[toolAxis(f)];
  Row<S>& row = rowsOf(arm, path.side_chain).at(path.row);
  S* found = nullptr;
  if constexpr (std::is_same_v<S, double>)
    found = f.find(row, path.lump);
  else
    found = f.findDual(row, path.lump);
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
std::vector<Lump<To>> castLumps(const std::vector<Lump<From>>& lumps) {
  std::vector<Lump<To>> out;
  for (const auto& lump : lumps) out.push_back({castScalar<To>(lump.weight), castVector<To>(lump.at)});
  return out;
}

template <class To, class From>
EffectTerms<To> castEffectTerms(const EffectTerms<From>& a) {
  return {a.joint_is_compliant,
          a.member_is_compliant,
          a.bends,
          a.has_gap,
          castVector<To>(a.compliance),
          castVector<To>(a.softness),
          castVector<To>(a.knee),
          castVector<To>(a.gap),
          castVector<To>(a.bending_compliance),
          castScalar<To>(a.torsion_compliance),
          castVector<To>(a.pull),
          castLumps<To>(a.hung)};
}

template <class To, class From>
TipLoad<To> castTipLoad(const TipLoad<From>& a) {
  return {castVector<To>(a.payload_offset), castScalar<To>(a.contact_force), castVector<To>(a.force),
          castVector<To>(a.moment)};
}

template <class To, class From>
Row<To> castRow(const Row<From>& row) {
  Row<To> out;
  out.name = row.name;
  if (const auto* dh = std::get_if<DenavitHartenberg<From>>(&row.placement))
    out.placement = DenavitHartenberg<To>{castScalar<To>(dh->alpha), castScalar<To>(dh->a), castScalar<To>(dh->d),
                                          castScalar<To>(dh->theta)};
  else {
    const auto& origin = std::get<Origin<From>>(row.placement);
    out.placement = Origin<To>{castVector<To>(origin.position), castVector<To>(origin.rpy)};
  }
  const auto& j = row.joint;
  out.joint = {j.name,       j.type,      castScalar<To>(j.offset), j.lower,
               j.upper,      j.max_speed, j.max_acceleration,       j.encoder_sigma,
               j.gear_ratio, j.follows};
  out.joint_stiffness = castVector<To>(row.joint_stiffness);
  if (row.beam)
    out.beam = Beam<To>{castScalar<To>(row.beam->E), castVector<To>(row.beam->I), castScalar<To>(row.beam->G),
                        castScalar<To>(row.beam->J), row.beam->segments};
  out.weight.distributed = castScalar<To>(row.weight.distributed);
  out.weight.end = castScalar<To>(row.weight.end);
  out.weight.lumps = castLumps<To>(row.weight.lumps);
  if (row.effect_terms) out.effect_terms = castEffectTerms<To>(*row.effect_terms);
  return out;
}

Parameter makeParameter(Arm& arm, const ParameterPath& path) {
  const ParameterField& f = parameterFields()[path.field];
  const Row<double>* row = f.of_tool ? nullptr : &rowsOf(arm, path.side_chain)[path.row];
  std::string name = (row ? row->name : "tool") + "." + f.name;
  if (f.of_lump) name.append(".").append(std::to_string(path.lump + 1));
  const bool slides = row && row->joint.type == JointType::kPrismatic && std::string_view(f.name) == "joint.offset";
  return {name, slides ? Quantity::kLength : f.quantity, path, locateIn(arm, path), f.lower, f.upper};
}

void appendRowParameters(Arm& arm, int side_chain, int index, std::vector<Parameter>& out) {
  const auto& fields = parameterFields();
  Row<double>& row = rowsOf(arm, side_chain)[index];
  for (int f = 0; f < static_cast<int>(fields.size()); ++f) {
    if (fields[f].of_tool) continue;
    const int lumps = static_cast<int>(row.weight.lumps.size());
    for (int lump = fields[f].of_lump ? 0 : -1; lump < (fields[f].of_lump ? lumps : 0); ++lump) {
      const double* number = fields[f].find(row, lump);
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
  out.reference_temperature = arm.reference_temperature;
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

bool isStiffness(Quantity quantity) {
  return quantity == Quantity::kTorquePerAngle || quantity == Quantity::kPressure ||
         quantity == Quantity::kLengthToTheFourth;
}

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
