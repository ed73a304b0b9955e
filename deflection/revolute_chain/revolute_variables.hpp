// Derivatives by an arm's variables, put together from those that a kernel gives: by joints, by turns of gravity and by
// the compliance of each turn.
#pragma once

#include <optional>
#include <vector>

#include "deflection/revolute_chain/revolute_chain.hpp"
#include "deflection/tip_derivatives.hpp"

namespace tubeplan::deflection::simd {

/// The compliance of an element by a number of the arm, along the element's axis [rad/(N m) per unit].
struct ElementSlope {
  std::size_t element;
  double slope;
};

/// How a stiffness's number acts on the elements of a chain; nothing where it is no stiffness, or acts about an axis
/// that is not the element's.
std::optional<std::vector<ElementSlope>> elementSlopes(const Arm& arm, const ParameterPath& path,
                                                       const Chain<double>& chain, const RevoluteChain& revolute_chain,
                                                       const std::vector<FlexibleElement>& elements);

/// Whether these are the same variables in the same order.
bool areSame(const std::vector<Variable>& a, const std::vector<Variable>& b);

class RevoluteVariables {
 public:
  /// Nothing where a kernel does not give what one of the variables needs.
  static std::optional<RevoluteVariables> of(const std::vector<Variable>& variables, const Arm& arm,
                                             const Chain<double>& chain, const RevoluteChain& revolute_chain,
                                             const std::vector<FlexibleElement>& elements);

  /// How many columns a kernel writes, of 6 numbers each.
  [[nodiscard]] int columns() const { return columns_; }
  /// Where in `derivatives` it is to write them, one kind after the other, `lanes` apart.
  void place(double* derivatives, long lanes, Shapes& out) const;

  /// The 6 numbers of a variable, of the first `count` lanes side by side; the 6 in `to` stand `stride` apart.
  void gather(std::size_t variable, const double* derivatives, long lanes, long count, double* to, long stride) const;

 private:
  struct Term {
    int column;
    double slope;
  };
  int joints_ = 0, columns_ = 0;
  bool has_gravity_ = false, has_compliances_ = false;
  std::vector<Term> terms_;
  std::vector<std::size_t> ends_;  ///< of each variable's terms
};

}  // namespace tubeplan::deflection::simd
