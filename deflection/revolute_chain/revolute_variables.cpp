#include "deflection/revolute_chain/revolute_variables.hpp"

#include <algorithm>

namespace tubeplan::deflection::simd {

namespace {

bool isStiffnessAt(const ParameterPath& path) {
  return path.effect < 0 && path.row >= 0 &&
         deflection::isStiffness(parameterFields()[static_cast<std::size_t>(path.field)].quantity);
}

/// Returns the derivative of an element's compliance with respect to a stiffness `value`; std::nullopt if the stiffness
/// acts about another axis. The compliance's terms due to the stiffness are inversely proportional to it. They vanish
/// in the row `without`, where the stiffness is infinite.
std::optional<double> slopeOf(const FlexibleElement& element, const RevoluteElement& hinge, const Row<double>& without,
                              double value) {
  const Eigen::Matrix3d of_number =
      element.flexibility.compliance - element.kind->flexibilityOf(without, element.flexibility.member).compliance;
  const double size = hinge.axis.dot(of_number * hinge.axis);
  const Eigen::Matrix3d aside = of_number - size * hinge.axis * hinge.axis.transpose();
  if (!(aside.cwiseAbs().maxCoeff() <= 1e-12 * std::abs(size))) return std::nullopt;
  return -size / value;
}

}  // namespace

std::optional<std::vector<ElementSlope>> elementSlopes(const Arm& arm, const ParameterPath& path,
                                                       const Chain<double>& chain, const RevoluteChain& revolute_chain,
                                                       const std::vector<FlexibleElement>& elements) {
  if (!isStiffnessAt(path)) return std::nullopt;
  Row<double> without = arm.rows[static_cast<std::size_t>(path.row)];
  double* number = findNumber(without, parameterFields()[static_cast<std::size_t>(path.field)], path.lump);
  const double value = *number;
  *number = kRigid;
  std::vector<ElementSlope> slopes;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    if (chain.components[e].row != path.row) continue;
    const auto slope = slopeOf(elements[e], revolute_chain.elements()[e], without, value);
    if (!slope) return std::nullopt;
    if (*slope != 0) slopes.push_back({e, *slope});
  }
  return slopes;
}

bool areSame(const std::vector<Variable>& a, const std::vector<Variable>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Variable& x, const Variable& y) {
    return x.type == y.type && x.index == y.index && x.parameter == y.parameter;
  });
}

std::optional<RevoluteVariables> RevoluteVariables::of(const std::vector<Variable>& variables, const Arm& arm,
                                                       const Chain<double>& chain, const RevoluteChain& revolute_chain,
                                                       const std::vector<FlexibleElement>& elements) {
  if (!revolute_chain.hasJacobian()) return std::nullopt;
  RevoluteVariables out;
  out.joints_ = revolute_chain.numbers().joints;
  const int first_compliance = out.joints_ + kGravityTurns;
  for (const Variable& variable : variables) {
    switch (variable.type) {
      case Variable::Type::kJoint:
        out.terms_.push_back({variable.index, 1});
        break;
      case Variable::Type::kGravityTurn:
        out.terms_.push_back({out.joints_ + variable.index, 1});
        out.has_gravity_ = true;
        break;
      case Variable::Type::kLoad:
        return std::nullopt;
      case Variable::Type::kParameter: {
        const auto slopes = elementSlopes(arm, variable.parameter, chain, revolute_chain, elements);
        if (!slopes) return std::nullopt;
        for (const auto& [element, slope] : *slopes) {
          const RevoluteElement& hinge = revolute_chain.elements()[element];
          out.terms_.push_back({first_compliance + 2 * hinge.turn + hinge.is_beam, slope});
        }
        out.has_compliances_ = true;
      }
    }
    out.ends_.push_back(out.terms_.size());
  }
  // Each kind of derivative has a fixed first column; columns after the last requested kind are omitted.
  out.columns_ = out.has_compliances_ ? first_compliance + 2 * revolute_chain.numbers().count
                 : out.has_gravity_   ? first_compliance
                                      : out.joints_;
  return out;
}

void RevoluteVariables::place(double* derivatives, long lanes, Shapes& out) const {
  out.jacobian = derivatives;
  out.by_gravity = has_gravity_ ? derivatives + 6L * joints_ * lanes : nullptr;
  out.by_compliance = has_compliances_ ? derivatives + 6L * (joints_ + kGravityTurns) * lanes : nullptr;
  out.derivative_stride = lanes;
}

void RevoluteVariables::gather(std::size_t variable, const double* derivatives, long lanes, long count, double* to,
                               long stride) const {
  const std::size_t first = variable == 0 ? 0 : ends_[variable - 1], end = ends_[variable];
  for (int k = 0; k < 6; ++k, to += stride) {
    for (long l = 0; l < count; ++l) to[l] = 0;
    for (std::size_t i = first; i < end; ++i) {
      const double* from = derivatives + (6L * terms_[i].column + k) * lanes;
      for (long l = 0; l < count; ++l) to[l] += terms_[i].slope * from[l];
    }
  }
}

}  // namespace tubeplan::deflection::simd
