#include "deflection/effects/expression.hpp"

#include <muParser.h>

#include <algorithm>
#include <boost/math/differentiation/finite_difference.hpp>
#include <cctype>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>

namespace tubeplan::deflection {

namespace {

// Ratio of the wide to the narrow step of the central differences; the narrow step is used if the wide step may cross a
// kink.
constexpr double kNarrower = 64;
// Largest relative difference between the results of both steps for a smooth function.
constexpr double kSmoothEnough = 1e-10;
constexpr const char* kConstants[] = {"pi", "_pi", "_e"};

bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool isOfName(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

struct Word {
  std::string text;
  std::size_t position;
  bool is_called;  // true if an opening bracket follows the name
};

std::size_t endOfNumber(const std::string& text, std::size_t at) {
  while (at < text.size() && (isDigit(text[at]) || text[at] == '.')) ++at;
  if (at + 1 >= text.size() || std::tolower(static_cast<unsigned char>(text[at])) != 'e') return at;
  const std::size_t digits = at + 1 + (text[at + 1] == '+' || text[at + 1] == '-');
  if (digits >= text.size() || !isDigit(text[digits])) return at;
  at = digits;
  while (at < text.size() && isDigit(text[at])) ++at;
  return at;
}

std::vector<Word> wordsOf(const std::string& text) {
  std::vector<Word> words;
  for (std::size_t at = 0; at < text.size();) {
    if (isDigit(text[at]) || text[at] == '.') {
      at = std::max(at + 1, endOfNumber(text, at));
      continue;
    }
    if (!isOfName(text[at])) {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (end < text.size() && isOfName(text[end])) ++end;
    const std::size_t next = text.find_first_not_of(' ', end);
    words.push_back({text.substr(at, end - at), at, next != std::string::npos && text[next] == '('});
    at = end;
  }
  return words;
}

/// Finds syntax that muParser accepts but formulas must not use: assignments, string literals and non-printable bytes.
std::optional<ExpressionProblem> findForeign(const std::string& text) {
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    const char before = k > 0 ? text[k - 1] : ' ', after = k + 1 < text.size() ? text[k + 1] : ' ';
    const bool is_printable = c >= ' ' && c <= '~';
    const bool assigns = c == '=' && after != '=' && std::string_view("=<>!").find(before) == std::string_view::npos;
    if (is_printable && !assigns && c != '"' && c != '\\') continue;
    const std::string what = is_printable ? std::string("'") + c + "'" : "a byte that cannot be printed";
    return ExpressionProblem{what + " stands",
                             assigns ? ": write == to compare" : ": a formula has only numbers, names and operators",
                             k,
                             "",
                             {}};
  }
  return std::nullopt;
}

ExpressionProblem problemOf(const mu::ParserError& error, const std::string& text) {
  ExpressionProblem problem;
  problem.position = std::min(static_cast<std::size_t>(std::max(0, error.GetPos())), text.size());
  problem.suffix = " where an expression such as c*sin(3*theta1) is expected";
  const std::string token = error.GetToken();
  switch (error.GetCode()) {
    case mu::ecUNEXPECTED_EOF:
    case mu::ecEMPTY_EXPRESSION:
      problem.what = "the formula ends";
      problem.suffix = " where an expression should follow";
      break;
    case mu::ecMISSING_PARENS:
      problem.what = "the formula ends";
      problem.suffix = " where a ')' is missing";
      break;
    case mu::ecTOO_FEW_PARAMS:
    case mu::ecTOO_MANY_PARAMS:
      problem.what = "'" + token + "' has too " +
                     std::string(error.GetCode() == mu::ecTOO_FEW_PARAMS ? "few" : "many") + " arguments";
      problem.suffix = "";
      break;
    default:
      problem.what = token.empty() ? "the formula cannot be read" : "'" + token.substr(0, 40) + "' stands";
      if (token.empty()) problem.suffix = ": write an expression such as c*sin(3*theta1)";
  }
  return problem;
}

}  // namespace

/// A parser bound to its own argument values. Parsers must not be built in several threads at once, because all parsers
/// of muParser share a locale.
struct Expression::Evaluator {
  std::vector<double> at;
  mu::Parser parser;

  Evaluator(const std::string& text, const std::vector<std::string>& names) : at(names.size(), 0.5) {
    parser.DefineConst("pi", std::numbers::pi);
    for (std::size_t k = 0; k < names.size(); ++k) parser.DefineVar(names[k], &at[k]);
    parser.SetExpr(text);
    parser.Eval();
  }

  double valueAt(const std::vector<double>& x) {
    std::copy(x.begin(), x.end(), at.begin());
    return value();
  }

  double value() {
    try {
      return parser.Eval();
    } catch (const mu::ParserError&) {
      return std::numeric_limits<double>::quiet_NaN();
    }
  }
};

struct Expression::Pool {
  std::string text;
  std::vector<std::string> names;
  std::mutex mutex;
  std::vector<std::unique_ptr<Evaluator>> idle;
};

namespace {

std::mutex& buildMutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

/// An evaluator borrowed from a pool for as long as this object lives; all evaluators of a pool are interchangeable.
class Expression::Borrowed {
 public:
  explicit Borrowed(Pool& pool) : pool_(pool) {
    {
      const std::lock_guard lock(pool.mutex);
      if (!pool.idle.empty()) {
        evaluator_ = std::move(pool.idle.back());
        pool.idle.pop_back();
      }
    }
    if (evaluator_) return;
    const std::lock_guard lock(buildMutex());
    evaluator_ = std::make_unique<Evaluator>(pool.text, pool.names);
  }
  ~Borrowed() {
    const std::lock_guard lock(pool_.mutex);
    pool_.idle.push_back(std::move(evaluator_));
  }
  Borrowed(const Borrowed&) = delete;
  Borrowed& operator=(const Borrowed&) = delete;

  Evaluator* operator->() { return evaluator_.get(); }

 private:
  Pool& pool_;
  std::unique_ptr<Evaluator> evaluator_;
};

Expression::Expression(std::unique_ptr<Pool> pool) : pool_(std::move(pool)) {}
Expression::~Expression() = default;

namespace {

/// Returns the names of the functions that an expression may call.
const std::vector<std::string>& expressionFunctions() {
  static const std::vector<std::string> kFunctions = [] {
    const std::lock_guard lock(buildMutex());
    std::vector<std::string> names;
    const mu::Parser parser;
    for (const auto& [name, callback] : parser.GetFunDef()) names.push_back(name);
    return names;
  }();
  return kFunctions;
}

}  // namespace

std::shared_ptr<const Expression> Expression::parse(const std::string& text, ExpressionProblem& problem) {
  if (const auto foreign = findForeign(text)) {
    problem = *foreign;
    return nullptr;
  }
  auto pool = std::make_unique<Pool>();
  pool->text = text;
  const auto& functions = expressionFunctions();
  for (const Word& word : wordsOf(text)) {
    const bool is_function = std::find(functions.begin(), functions.end(), word.text) != functions.end();
    if (word.is_called && !is_function) {
      problem = {"the unknown function '" + word.text.substr(0, 40) + "' is called", "", word.position, word.text,
                 functions};
      return nullptr;
    }
    const bool is_new = std::find(pool->names.begin(), pool->names.end(), word.text) == pool->names.end();
    const bool is_constant = std::find(std::begin(kConstants), std::end(kConstants), word.text) != std::end(kConstants);
    if (is_new && !is_function && !is_constant) pool->names.push_back(word.text);
  }
  try {
    const std::lock_guard lock(buildMutex());
    pool->idle.push_back(std::make_unique<Evaluator>(text, pool->names));
  } catch (const mu::ParserError& error) {
    problem = problemOf(error, text);
    return nullptr;
  }
  if (pool->idle.front()->parser.GetNumResults() != 1) {
    problem = {
        "a second expression follows", ", but a formula has only one", std::min(text.find(','), text.size()), "", {}};
    return nullptr;
  }
  return std::shared_ptr<const Expression>(new Expression(std::move(pool)));
}

const std::vector<std::string>& Expression::names() const { return pool_->names; }

double Expression::value(const std::vector<double>& at) const { return Borrowed(*pool_)->valueAt(at); }

double Expression::slope(const std::vector<double>& at, std::size_t name) const {
  Borrowed evaluator(*pool_);
  const double value = evaluator->valueAt(at), scale = std::max(1., std::abs(at[name]));
  const auto slopeBy = [&](double unit) {
    const auto along = [&](double t) {
      evaluator->at[name] = at[name] + t * unit;
      return evaluator->value();
    };
    return boost::math::differentiation::finite_difference_derivative<decltype(along), double, 6>(along, 0.) / unit;
  };
  const double wide = slopeBy(scale), narrow = slopeBy(scale / kNarrower);
  const bool agree = std::abs(wide - narrow) <= kSmoothEnough * (std::abs(wide) + std::abs(value) / scale);
  return agree ? wide : narrow;
}

Dual Expression::value(const std::vector<Dual>& at) const {
  std::vector<double> values;
  for (const Dual& x : at) values.push_back(x.value());
  Dual result(value(values));
  for (std::size_t k = 0; k < at.size(); ++k) {
    const auto& by = at[k].derivatives();
    if (std::all_of(by.begin(), by.end(), [](double d) { return d == 0; })) continue;
    const double s = slope(values, k);
    for (int d = 0; d < kDualSize; ++d) result.derivatives()[d] += s * by[d];
  }
  return result;
}

}  // namespace tubeplan::deflection
