// Derivatives with respect to an arm's variables, combined from a kernel's derivatives with respect to joints,
// rotations of gravity and the compliance of each turn.
#pragma once

#include <optional>
#include <vector>

#include "deflection/revolute_chain/revolute_chain.hpp"
#include "deflection/tip_derivatives.hpp"

namespace tubeplan::deflection::simd {

/// Derivative of an element's compliance about its axis with respect to a parameter of the arm [rad/(N m) per unit].
struct ElementSlope {
  std::size_t element;
  double slope;
};

/// Returns the derivatives of the elements' compliances with respect to a stiffness. Returns std::nullopt if the
/// parameter is not a stiffness, or acts about an axis other than the element's.
std::optional<std::vector<ElementSlope>> elementSlopes(const Arm& arm, const ParameterPath& path,
                                                       const Chain<double>& chain, const RevoluteChain& revolute_chain,
                                                       const std::vector<FlexibleElement>& elements);

/// Returns true if `a` and `b` list the same variables in the same order.
bool areSame(const std::vector<Variable>& a, const std::vector<Variable>& b);

class RevoluteVariables {
 public:
  /// Builds the rule for the derivatives with respect to `variables`; std::nullopt if a variable needs a derivative
  /// that the kernels do not compute.
  static std::optional<RevoluteVariables> of(const std::vector<Variable>& variables, const Arm& arm,
                                             const Chain<double>& chain, const RevoluteChain& revolute_chain,
                                             const std::vector<FlexibleElement>& elements);

  /// Returns the number of columns of 6 values that a kernel writes.
  [[nodiscard]] int columns() const { return columns_; }
  /// Sets the derivative pointers of `out` to places in `derivatives`, which holds one kind of derivative after
  /// another, with a stride of `lanes`.
  void place(double* derivatives, long lanes, Shapes& out) const;

  /// Combines a kernel's derivatives into the 6 derivatives with respect to a variable, for the first `count` lanes
  /// side by side; the 6 values in `to` are `stride` apart.
  void gather(std::size_t variable, const double* derivatives, long lanes, long count, double* to, long stride) const;

 private:
  struct Term {
    int column;
    double slope;
  };
  int joints_ = 0, columns_ = 0;
  bool has_gravity_ = false, has_compliances_ = false;
  std::vector<Term> terms_;
  std::vector<std::size_t> ends_;  ///< index after the last term of each variable
};

}  // namespace tubeplan::deflection::simd
