// Derivatives by an arm's variables, combined from those of a kernel: by joints, by rotations of gravity and by the
// compliance of each turn.
#pragma once

#include <optional>
#include <vector>

#include "deflection/revolute_chain/revolute_chain.hpp"
#include "deflection/tip_derivatives.hpp"

namespace tubeplan::deflection::simd {

/// Slope of an element's compliance about its axis by a number of the arm [rad/(N m) per unit].
struct ElementSlope {
  std::size_t element;
  double slope;
};

/// Returns the slopes of the chain's elements by a stiffness's number; nothing if it is no stiffness, or acts about
/// another axis than the element's.
std::optional<std::vector<ElementSlope>> elementSlopes(const Arm& arm, const ParameterPath& path,
                                                       const Chain<double>& chain, const RevoluteChain& revolute_chain,
                                                       const std::vector<FlexibleElement>& elements);

/// Returns true if both are the same variables in the same order.
bool areSame(const std::vector<Variable>& a, const std::vector<Variable>& b);

class RevoluteVariables {
 public:
  /// Combines the derivatives by `variables`; nothing if a kernel does not give what one of them needs.
  static std::optional<RevoluteVariables> of(const std::vector<Variable>& variables, const Arm& arm,
                                             const Chain<double>& chain, const RevoluteChain& revolute_chain,
                                             const std::vector<FlexibleElement>& elements);

  /// Returns the number of columns that a kernel writes, of 6 numbers each.
  [[nodiscard]] int columns() const { return columns_; }
  /// Sets the pointers of `out` into `derivatives`, one kind after the other, `lanes` apart.
  void place(double* derivatives, long lanes, Shapes& out) const;

  /// Copies the 6 numbers of a variable for the first `count` lanes, side by side; the 6 in `to` are `stride` apart.
  void gather(std::size_t variable, const double* derivatives, long lanes, long count, double* to, long stride) const;

 private:
  struct Term {
    int column;
    double slope;
  };
  int joints_ = 0, columns_ = 0;
  bool has_gravity_ = false, has_compliances_ = false;
  std::vector<Term> terms_;
  std::vector<std::size_t> ends_;  ///< end of each variable's terms
};

}  // namespace tubeplan::deflection::simd
