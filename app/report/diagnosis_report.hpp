// The pages about a model's errors, each one self-contained HTML file made from one JSON document.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tubeplan::app {

/// The whole page of `tubeplan diagnose`, from what its --json writes (diagnosis_json.hpp, diagnosis_views_json.hpp)
/// with title, cell, measurements, seed, version: text (seed: number or text). Safe for hostile text as renderPage().
/// Every part of `report` may be absent or null; the page then says "not recorded" in its place.
[[nodiscard]] std::string renderDiagnosisReport(const nlohmann::json& report);

/// The page of `tubeplan compare`, likewise, from
///   verdict, sentence: text; sentences: [text, ...]; units; rms: {before, after, heldout_before, heldout_after,
///   noise_floor}; chi2_per_dof, p_value; joints: [{name, unit}, ...]   readings: [{id, point, position: [3], before:
///   [3], after: [3], joints, load, senses,
///                                             temperature, time}, ...], errors as measured less predicted
///   patterns: [text or {sentence or name, share or correlation, p_value}, ...]   worst: [id or {id, error, sigmas},
///   ...]
[[nodiscard]] std::string renderComparisonReport(const nlohmann::json& report);

/// The page of `tubeplan ladder`, likewise, from
///   units; noise_floor; models: [{name, rms, heldout_rms, chi2_per_dof, p_value, numbers}, ...], readings as above
[[nodiscard]] std::string renderLadderReport(const nlohmann::json& report);

/// The page of `tubeplan improve`, likewise, from what its --json writes, with models as of a ladder and, of each step,
/// `figures`: what the page of a diagnosis takes.
[[nodiscard]] std::string renderImprovementReport(const nlohmann::json& report);

/// The page of `tubeplan report`, likewise, from what projectReportJson() gives.
[[nodiscard]] std::string renderProjectReport(const nlohmann::json& report);

}  // namespace tubeplan::app
