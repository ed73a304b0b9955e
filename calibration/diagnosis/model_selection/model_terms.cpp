#include "calibration/diagnosis/model_selection/model_terms.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tubeplan::calibration {

namespace {

constexpr double kLeastVisible = 1;  // smallest visibility of a cause at its largest usual size [noise sigmas]
constexpr int kMostNumbers = 8;      // if a cause has more parameters than this, no subsets are tried

/// Returns the subsets of a cause's parameters to try. For up to four parameters: all subsets. For more: each parameter
/// alone, and all together. For a cause of several effects, or with more than kMostNumbers parameters: only all
/// together.
std::vector<std::vector<int>> choicesOf(const Cause& cause, int numbers) {
  std::vector<int> all(static_cast<std::size_t>(numbers));
  std::iota(all.begin(), all.end(), 0);
  if (cause.effects.size() > 1 || numbers > kMostNumbers) return {all};
  std::vector<std::vector<int>> choices;
  for (unsigned mask = 1; mask < (1U << numbers); ++mask) {
    std::vector<int> choice;
    for (const int k : all)
      if (mask & (1U << k)) choice.push_back(k);
    if (numbers <= 4 || choice.size() == 1 || static_cast<int>(choice.size()) == numbers) choices.push_back(choice);
  }
  return choices;
}

double logShare(const Cause& cause, std::size_t choices) {
  return -std::log(static_cast<double>(cause.levels.size() * choices));
}

int countNumbers(const DiagnosisWork& work, int cause, int level) {
  return static_cast<int>(work.signatures->columnsOf(cause, level).size());
}

double logShareOf(const DiagnosisWork& work, const ModelTerm& term) {
  const Cause& cause = work.cause(term.cause);
  return logShare(cause, choicesOf(cause, countNumbers(work, term.cause, term.level)).size());
}

}  // namespace

std::vector<WeighedTerm> termsOf(const DiagnosisWork& work, int index) {
  const Cause& cause = work.cause(index);
  std::vector<WeighedTerm> terms;
  for (int level = 0; level < static_cast<int>(cause.levels.size()); ++level) {
    const auto choices = choicesOf(cause, countNumbers(work, index, level));
    for (const auto& choice : choices) terms.push_back({{index, level, choice}, logShare(cause, choices.size())});
  }
  return terms;
}

std::vector<WeighedTerm> someTermsOf(const DiagnosisWork& work, int index) {
  auto terms = termsOf(work, index);
  if (terms.size() < kManyTerms) return terms;
  std::size_t most = 0;
  for (const WeighedTerm& t : terms) most = std::max(most, t.term.numbers.size());
  std::erase_if(terms, [&](const WeighedTerm& t) {
    return t.term.level % 4 != 0 || (t.term.numbers.size() != 1 && t.term.numbers.size() != most);
  });
  return terms;
}

double logShareOf(const DiagnosisWork& work, const std::vector<ModelTerm>& terms) {
  double log_share = 0;
  for (const ModelTerm& term : terms) log_share += logShareOf(work, term);
  return log_share;
}

std::vector<ModelTerm> fullTerms(const DiagnosisWork& work, std::vector<ModelTerm> terms) {
  for (ModelTerm& term : terms) {
    term.numbers.resize(static_cast<std::size_t>(countNumbers(work, term.cause, term.level)));
    std::iota(term.numbers.begin(), term.numbers.end(), 0);
  }
  return terms;
}

std::vector<PriorSize> sizesOf(const DiagnosisWork& work, const std::vector<ModelTerm>& terms, double scale) {
  std::vector<PriorSize> sizes;
  for (const ModelTerm& term : terms)
    for (const int c : picked(work.signatures->columnsOf(term.cause, term.level), term.numbers)) {
      const SignatureColumn& column = work.signatures->columns()[static_cast<std::size_t>(c)];
      sizes.push_back(
          {c, column.prior_sigma * (column.is_of_effect ? scale : 1), signWithin(column.lower, column.upper)});
    }
  return sizes;
}

bool hasEffects(const DiagnosisWork& work, const std::vector<ModelTerm>& terms) {
  return std::ranges::any_of(terms, [&](const ModelTerm& t) { return work.cause(t.cause).frees.empty(); });
}

bool isVisible(const DiagnosisWork& work, int cause) {
  const auto shows = [&](int column) {
    const double usual = work.signatures->columns()[static_cast<std::size_t>(column)].prior_sigma;
    return work.noise.back().evidence->visibility(column) * usual > kLeastVisible;
  };
  for (int level = 0; level < static_cast<int>(work.cause(cause).levels.size()); ++level) {
    const auto& columns = work.signatures->columnsOf(cause, level);
    if (std::ranges::any_of(columns, shows)) return true;
  }
  return false;
}

bool areCombinable(const DiagnosisWork& work, const std::vector<ModelTerm>& terms, int cause) {
  const Cause& added = work.cause(cause);
  auto present = work.basis.fitted.arm.effects;
  for (const ModelTerm& term : terms) {
    const Cause& other = work.cause(term.cause);
    if (term.cause == cause || overlap(other, added)) return false;
    present.insert(present.end(), other.effects.begin(), other.effects.end());
  }
  return mayActBeside(added, present);
}

bool representsSeveralCauses(const DiagnosisWork& work, const std::vector<ModelTerm>& terms) {
  return std::ranges::any_of(terms, [&](const ModelTerm& term) {
    const Cause& cause = work.cause(term.cause);
    return cause.effects.size() > 1 || cause.frees.size() > 1;
  });
}

}  // namespace tubeplan::calibration
