#include "deflection/effects/formula.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

#include "deflection/effects/formula_sizes.hpp"
#include "deflection/effects/user_formula.hpp"

namespace tubeplan::deflection {

namespace {

constexpr std::size_t kLongest = 1000;  // largest number of characters of a formula
constexpr std::size_t kMostParameters = 12;
constexpr double kPlausible = 0.005;  // plausible magnitude [rad, m], as in the catalogue
constexpr const char* kFrameTargets[] = {"tip.x", "tip.y", "tip.z", "base.x", "base.y", "base.z", "base.yaw"};

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string_view::npos ? "" : std::string(text.substr(first, last - first + 1));
}

/// Returns the symbol by which expressions refer to a part of the arm with this name: letters, digits and _.
std::string symbolNameOf(const std::string& name) {
  std::string symbol = name;
  for (char& c : symbol)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return !symbol.empty() && std::isdigit(static_cast<unsigned char>(symbol[0])) != 0 ? "_" + symbol : symbol;
}

std::optional<FormulaTarget> findTarget(const Arm& arm, const std::string& name) {
  for (int row : activeRows(arm))
    if (name == arm.rows[row].joint.name || name == symbolNameOf(arm.rows[row].joint.name))
      return FormulaTarget{FormulaTarget::Of::kJoint, row, -1};
  for (int k = 0; k < static_cast<int>(std::size(kFrameTargets)); ++k)
    if (name == kFrameTargets[k])
      return FormulaTarget{k < 3 ? FormulaTarget::Of::kTip : FormulaTarget::Of::kBase, -1, k < 3 ? k : k - 3};
  return std::nullopt;
}

bool isAngle(const Arm& arm, const FormulaTarget& target) {
  if (target.of == FormulaTarget::Of::kJoint) return arm.rows[target.row].joint.type == JointType::kRevolute;
  return target.of == FormulaTarget::Of::kBase && target.axis == 3;
}

MadeFormula refused(FormulaStatus status, std::string found, std::string expected = "") {
  MadeFormula made;
  made.status = status;
  made.found = std::move(found);
  made.expected = std::move(expected);
  return made;
}

std::string atCharacter(std::size_t position) { return " at character " + std::to_string(position + 1); }

/// Target, expression and start values of a formula, such as "theta3", "c*sin(3*theta1)" and "c=0.1".
struct Parts {
  std::string target, expression, starts;
  std::size_t expression_at = 0;
};

std::optional<Parts> split(const std::string& text) {
  const std::size_t sign = text.find("+=");
  if (sign == std::string::npos) return std::nullopt;
  Parts parts;
  parts.target = trimmed(text.substr(0, sign));
  const std::size_t end = std::min(text.find(';', sign), text.size());
  parts.expression_at = std::min(text.find_first_not_of(" \t", sign + 2), end);
  parts.expression = trimmed(text.substr(parts.expression_at, end - parts.expression_at));
  if (end < text.size()) parts.starts = text.substr(end + 1);
  return parts;
}

struct Start {
  std::string name;
  double value;
};

/// Reads start values such as "c=0.1, k=3". If one is invalid, returns nothing and sets `wrong` to it.
std::optional<std::vector<Start>> readStarts(const std::string& text, std::string& wrong) {
  std::vector<Start> starts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find_first_of(",;", from), text.size());
    wrong = trimmed(text.substr(from, to - from));
    from = to + 1;
    if (wrong.empty()) continue;
    const std::size_t equals = std::min(wrong.find('='), wrong.size());
    Start start{trimmed(wrong.substr(0, equals)), 0};
    const std::string number = equals < wrong.size() ? trimmed(wrong.substr(equals + 1)) : "";
    const auto read = std::from_chars(number.data(), number.data() + number.size(), start.value);
    const bool is_twice =
        std::any_of(starts.begin(), starts.end(), [&](const Start& s) { return s.name == start.name; });
    if (read.ec != std::errc() || read.ptr != number.data() + number.size() || !std::isfinite(start.value) || is_twice)
      return std::nullopt;
    starts.push_back(std::move(start));
  }
  return starts;
}

/// Binds every name of the expression to a symbol; a name without a symbol becomes a parameter.
std::optional<MadeFormula> bindNames(const Arm& arm, const FormulaUnits& units, Formula& formula) {
  const auto symbols = formulaSymbols(arm, units);
  for (const std::string& name : formula.expression->names()) {
    std::vector<const NamedSymbol*> meant;
    for (const NamedSymbol& symbol : symbols)
      if (symbol.name == name) meant.push_back(&symbol);
    if (meant.size() > 1)
      return refused(FormulaStatus::kBadExpression, "two parts of the arm have the name '" + name +
                                                        "': rename one, so that their letters or digits differ");
    Formula::Input input;
    if (meant.empty()) {
      input.parameter = static_cast<int>(formula.names.size());
      formula.names.push_back(name);
    } else {
      input.symbol = meant.front()->symbol;
    }
    formula.inputs.push_back(input);
  }
  if (formula.names.size() > kMostParameters)
    return refused(FormulaStatus::kBadExpression, std::to_string(formula.names.size()) + " parameters",
                   "at most " + std::to_string(kMostParameters));
  for (const char* taken : {"effect", "at", "formula"})
    if (std::find(formula.names.begin(), formula.names.end(), taken) != formula.names.end())
      return refused(FormulaStatus::kBadExpression, "a parameter cannot have the name '" + std::string(taken) +
                                                        "', which is a key of a cell file: choose another name");
  return std::nullopt;
}

/// Decides which parameters are sizes, in which the formula is linear, and which are shapes; sets the start values.
std::optional<MadeFormula> chooseParameters(const std::vector<Start>& starts, Formula& formula, MadeFormula& made) {
  for (const Start& start : starts)
    if (std::find(formula.names.begin(), formula.names.end(), start.name) == formula.names.end()) {
      MadeFormula wrong =
          refused(FormulaStatus::kBadStart, "there is an initial value of '" + start.name.substr(0, 40) +
                                                "', which is not a parameter of the formula");
      wrong.word = start.name;
      wrong.known = formula.names;
      return wrong;
    }
  const unsigned sizes = findSizes(formula);
  const auto startOf = [&](const std::string& name) {
    return std::find_if(starts.begin(), starts.end(), [&](const Start& s) { return s.name == name; });
  };
  std::copy_if(formula.names.begin(), formula.names.end(), std::back_inserter(made.free),
               [&](const std::string& name) { return startOf(name) == starts.end(); });
  for (std::size_t k = 0; k < formula.names.size(); ++k) {
    const bool is_shape = (sizes >> k & 1U) == 0;
    const auto start = startOf(formula.names[k]);
    if (is_shape && start == starts.end()) {
      MadeFormula wrong =
          refused(FormulaStatus::kNeedsStart, "the formula is not linear in its parameter '" + formula.names[k] +
                                                  "', which needs an initial value: '" + formula.text.substr(0, 200) +
                                                  "; " + formula.names[k] + "=1'");
      wrong.free = made.free;
      return wrong;
    }
    const double unit = is_shape ? 1 : formula.unit;
    const double begin = start == starts.end() ? 0 : start->value * unit;
    const Quantity quantity = is_shape ? Quantity::kNone : formula.quantity;
    const double plausible = is_shape ? std::max(0.1, 0.1 * std::abs(begin)) : kPlausible;
    formula.units.push_back(unit);
    formula.parameters.push_back(
        {formula.names[k].c_str(), quantity, is_shape ? begin : 0, -kUnbounded, kUnbounded, plausible, is_shape});
    made.effect.values.push_back(begin);
  }
  return std::nullopt;
}

/// Returns the formula's place: the one requested or, if none is requested, the first of "theta3", "theta3#2", ... that
/// no other formula of the arm has. Returns std::nullopt if the request is invalid.
std::optional<std::string> placeOf(const Arm& arm, const std::string& target, std::string_view requested_place) {
  if (!requested_place.empty()) {
    const std::string_view suffix = requested_place.substr(std::min(requested_place.size(), target.size()));
    const bool is_number = suffix.size() > 1 && suffix.size() < 5 && suffix[0] == '#' &&
                           suffix.substr(1).find_first_not_of("0123456789") == std::string_view::npos;
    if (!requested_place.starts_with(target) || !(suffix.empty() || is_number)) return std::nullopt;
    return std::string(requested_place);
  }
  for (int number = 1;; ++number) {
    const std::string at = number == 1 ? target : target + "#" + std::to_string(number);
    if (std::none_of(arm.effects.begin(), arm.effects.end(),
                     [&](const Effect& effect) { return effect.formula && effect.formula->at == at; }))
      return at;
  }
}

std::string targetName(const Arm& arm, const FormulaTarget& target) {
  if (target.of == FormulaTarget::Of::kJoint) return arm.rows[target.row].joint.name;
  return kFrameTargets[target.of == FormulaTarget::Of::kTip ? target.axis : target.axis + 3];
}

/// Reads target and expression, and binds the expression's names; chooseParameters() must complete the formula. If
/// something is invalid, returns the refusal.
std::optional<MadeFormula> understand(const Arm& arm, const Parts& parts, const FormulaUnits& units,
                                      std::string_view at, Formula& formula) {
  const auto target = findTarget(arm, parts.target);
  if (!target) {
    MadeFormula wrong = refused(FormulaStatus::kBadTarget, "the target '" + parts.target.substr(0, 40) + "'",
                                "a joint, tip.x to tip.z, base.x to base.z or base.yaw");
    wrong.word = parts.target;
    wrong.known = formulaTargets(arm);
    return wrong;
  }
  formula.target = *target;
  formula.quantity = isAngle(arm, *target) ? Quantity::kAngle : Quantity::kLength;
  formula.unit = formula.quantity == Quantity::kAngle ? units.angle : units.length;
  const auto place = placeOf(arm, targetName(arm, *target), at);
  if (!place)
    return refused(FormulaStatus::kBadTarget, "the place '" + std::string(at.substr(0, 40)) + "'",
                   targetName(arm, *target) + ", on which the formula acts, or " + targetName(arm, *target) + "#2");
  formula.at = *place;
  ExpressionProblem problem;
  formula.expression = Expression::parse(parts.expression, problem);
  if (formula.expression) return bindNames(arm, units, formula);
  MadeFormula wrong = refused(FormulaStatus::kBadExpression,
                              problem.what + atCharacter(parts.expression_at + problem.position) + problem.suffix);
  wrong.word = problem.word;
  wrong.known = problem.known;
  return wrong;
}

/// Returns a string such as " at theta1 = 0, c = 0.1", for the message that the formula has no value there.
std::string namedValues(const Formula& formula, const std::vector<double>& at) {
  std::ostringstream text;
  const char* between = " at ";
  for (std::size_t k = 0; k < at.size(); ++k) {
    text << between << formula.expression->names()[k] << " = " << at[k];
    between = ", ";
  }
  return text.str();
}

}  // namespace

std::vector<NamedSymbol> formulaSymbols(const Arm& arm, const FormulaUnits& units) {
  using Of = FormulaSymbol::Of;
  std::vector<NamedSymbol> symbols;
  for (int row : activeRows(arm)) {
    const auto& joint = arm.rows[row].joint;
    const double unit = joint.type == JointType::kPrismatic ? units.length : 1;
    symbols.push_back({symbolNameOf(joint.name), {Of::kJoint, row, -1, unit, 0}});
    symbols.push_back({symbolNameOf(joint.name) + "_dir", {Of::kApproachDirection, row, -1, 1, 0}});
  }
  for (int row = 0; row < static_cast<int>(arm.rows.size()); ++row)
    for (int axis = 0; axis < 3; ++axis)
      symbols.push_back({"moment_" + symbolNameOf(arm.rows[row].name) + "_" + "xyz" [axis],
                         { Of::kMoment, row, axis, units.force *units.length, 0 }});
  symbols.push_back({"load", {Of::kLoad, -1, -1, units.force, 0}});
  for (const ConditionKind& kind : kConditionKinds) {
    const auto& [unit, zero] = units.conditions[kind.condition];
    symbols.push_back({kind.name, {Of::kCondition, -1, -1, unit, zero, kind.condition}});
  }
  return symbols;
}

std::vector<std::string> formulaTargets(const Arm& arm) {
  std::vector<std::string> targets = jointNames(arm);
  targets.insert(targets.end(), std::begin(kFrameTargets), std::end(kFrameTargets));
  return targets;
}

MadeFormula makeFormula(const Arm& arm, std::string_view text, const FormulaUnits& units, std::string_view at) {
  if (text.size() > kLongest)
    return refused(FormulaStatus::kBadExpression, "a formula of " + std::to_string(text.size()) + " characters",
                   "at most " + std::to_string(kLongest));
  const auto formula = std::make_shared<Formula>();
  formula->text = trimmed(text);
  const auto parts = split(formula->text);
  if (!parts)
    return refused(FormulaStatus::kBadTarget, formula->text.empty() ? "nothing" : "no '+='",
                   "TARGET += EXPRESSION, such as 'theta3 += c*sin(3*theta1)'");
  if (auto wrong = understand(arm, *parts, units, at, *formula)) return *wrong;
  std::string wrong_start;
  const auto starts = readStarts(parts->starts, wrong_start);
  if (!starts)
    return refused(FormulaStatus::kBadStart, "'" + wrong_start.substr(0, 40) + "'",
                   "initial values such as 'c=0.1, k=3', each given once");
  MadeFormula made;
  if (auto wrong = chooseParameters(*starts, *formula, made)) return *wrong;
  made.status = FormulaStatus::kMade;
  made.effect.kind = *findEffectKind(user_formula::kName);
  made.effect.place.row = formula->target.row;
  made.effect.formula = formula;
  return made;
}

std::string findUndefinedFormula(const Arm& arm, const Posture& posture) {
  EffectContext<double> context(arm, posture);
  for (const Effect& effect : arm.effects) {
    if (!effect.formula) continue;
    const Formula& formula = *effect.formula;
    const auto at = user_formula::inputsOf(effect, context);
    if (!std::isfinite(formula.expression->value(at))) return user_formula::undefinedText(formula, at);
    for (std::size_t k = 0; k < at.size(); ++k)
      if (!std::isfinite(formula.expression->slope(at, k)))
        return "'" + formula.text + "' has no finite derivative with respect to " + formula.expression->names()[k] +
               namedValues(formula, at);
  }
  return "";
}

std::string user_formula::undefinedText(const Formula& formula, const std::vector<double>& at) {
  return "'" + formula.text + "' has no finite value" + namedValues(formula, at);
}

}  // namespace tubeplan::deflection
