// An expression such as `c*sin(3*theta1)`, as a function of the names in it. This is the only user of muParser, whose
// functions and operators apply: sin, cos, exp, sqrt, abs, ^, ? : and the rest of its manual; pi is defined too.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "deflection/scalar.hpp"

namespace tubeplan::deflection {

/// Reason why a text is no expression: the sentence is `what`, " at character N", `rest`.
struct ExpressionProblem {
  std::string what;                ///< begin of the sentence: "the formula ends"
  std::string rest;                ///< end of the sentence: " where an expression should follow"; may be empty
  std::size_t position = 0;        ///< index in the text, from 0
  std::string word;                ///< the unknown name, if that is the reason
  std::vector<std::string> known;  ///< the known names, if one is unknown
};

/// A parsed expression. Many threads may evaluate it at once. Where it has no value (0/0, log(-1)) it is NaN or
/// infinite.
class Expression {
 public:
  /// Parses a text. Returns null if it is no expression, with the reason in `problem`.
  static std::shared_ptr<const Expression> parse(const std::string& text, ExpressionProblem& problem);

  ~Expression();
  Expression(const Expression&) = delete;
  Expression& operator=(const Expression&) = delete;

  /// Returns the variables, in the order in which the text first names them.
  [[nodiscard]] const std::vector<std::string>& names() const;

  /// Returns the value; `at` has one number for each name.
  [[nodiscard]] double value(const std::vector<double>& at) const;

  /// Returns the derivative by one name, from central differences of sixth order; accurate to 1e-11 for smooth
  /// functions.
  [[nodiscard]] double slope(const std::vector<double>& at, std::size_t name) const;

  /// Returns the value in dual numbers; only names that vary need a slope.
  [[nodiscard]] Dual value(const std::vector<Dual>& at) const;

 private:
  struct Evaluator;
  struct Pool;
  class Borrowed;

  explicit Expression(std::unique_ptr<Pool> pool);

  std::unique_ptr<Pool> pool_;
};

}  // namespace tubeplan::deflection
