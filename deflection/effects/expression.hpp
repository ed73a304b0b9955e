// An expression such as `c*sin(3*theta1)`, as a function of the variables that it names. It may use the functions and
// operators of muParser, such as sin, cos, exp, sqrt, abs, ^ and ? :, and the constant pi. muParser is used only in
// expression.cpp.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "deflection/scalar.hpp"

namespace tubeplan::deflection {

/// Error found while parsing an expression. The error message consists of `what`, " at character N" and `suffix`.
struct ExpressionProblem {
  std::string what;                ///< beginning of the message, such as "the formula ends"
  std::string suffix;              ///< end of the message, such as " where an expression should follow"; may be empty
  std::size_t position = 0;        ///< 0-based index of the character in the string
  std::string word;                ///< the unknown name; empty for other errors
  std::vector<std::string> known;  ///< valid names, if a name is unknown
};

/// A parsed expression; evaluation is thread-safe. If the expression has no value (0/0, log(-1)), the result is NaN or
/// infinite.
class Expression {
 public:
  /// Parses a string. If it is not an expression, returns null and sets `problem` to the reason.
  static std::shared_ptr<const Expression> parse(const std::string& text, ExpressionProblem& problem);

  ~Expression();
  Expression(const Expression&) = delete;
  Expression& operator=(const Expression&) = delete;

  /// Returns the names of the variables, in order of first appearance.
  [[nodiscard]] const std::vector<std::string>& names() const;

  /// Returns the value of the expression; `at` has one argument for each name.
  [[nodiscard]] double value(const std::vector<double>& at) const;

  /// Returns the derivative with respect to the variable with index `name`, from central differences of sixth order;
  /// accurate to 1e-11 for smooth functions.
  [[nodiscard]] double slope(const std::vector<double>& at, std::size_t name) const;

  /// Returns the value in dual numbers; slopes are computed only with respect to arguments that have derivatives.
  [[nodiscard]] Dual value(const std::vector<Dual>& at) const;

 private:
  struct Evaluator;
  struct Pool;
  class Borrowed;

  explicit Expression(std::unique_ptr<Pool> pool);

  std::unique_ptr<Pool> pool_;
};

}  // namespace tubeplan::deflection
