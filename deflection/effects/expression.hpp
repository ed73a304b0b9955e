// A text like `c*sin(3*theta1)` as a function of the names in it. The one place that knows muParser, whose functions
// and operators are those of the text: sin, cos, exp, sqrt, abs, ^, ? : and the rest of its manual; pi is defined too.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "deflection/scalar.hpp"

namespace tubeplan::deflection {

/// Why a text is no expression.
struct ExpressionProblem {
  std::string found, expected;
  std::size_t position = 0;        ///< in the text, from 0
  std::string word;                ///< the name that is not known, where that is the reason ...
  std::vector<std::string> known;  ///< ... and those that are
};

/// Values may be asked for by many threads at once. Where a text has no value (0/0, log(-1)) it is NaN or infinite.
class Expression {
 public:
  /// Nothing where the text is none; `problem` then says why.
  static std::shared_ptr<const Expression> parse(const std::string& text, ExpressionProblem& problem);

  ~Expression();
  Expression(const Expression&) = delete;
  Expression& operator=(const Expression&) = delete;

  /// The variables, in the order in which the text first names them.
  [[nodiscard]] const std::vector<std::string>& names() const;

  /// `at` has one number for each name.
  [[nodiscard]] double value(const std::vector<double>& at) const;

  /// The derivative by one name: central differences of sixth order, by which smooth functions are good to 1e-11.
  [[nodiscard]] double slope(const std::vector<double>& at, std::size_t name) const;

  /// The value in dual numbers; only names that vary cost a slope.
  [[nodiscard]] Dual value(const std::vector<Dual>& at) const;

 private:
  struct Evaluator;
  struct Pool;
  class Borrowed;

  explicit Expression(std::unique_ptr<Pool> pool);

  std::unique_ptr<Pool> pool_;
};

}  // namespace tubeplan::deflection
