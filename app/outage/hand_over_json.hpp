// The hand-over of a shift as a JSON document, for its page.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/outage/hand_over.hpp"

namespace tubeplan::app {

/// Returns
///   title, job, units, made_at; last_event: number of the latest event, 0 if there is none
///   shift: {date, name, words, from, to} or null; asked: description of the requested shift
///   total: COUNTS as in totalsJson(); totals: [{by, rows: [{name, COUNTS}]}]
///   shifts: [{name, marks, done_in_shift, COUNTS at its end}]
///   people: [{who, marked, marks: {MARK: count}, confirmed, wrong, undone}]; marks: [{name, words, standing}]
///   wrong_tubes, plugged_at_one_end, plugged_in_the_meantime: as in totalsJson()
///   held: [{reason, is_by_plan, tubes: [ADDRESS and package]}], grouped by reason; items marked by
///     people come before tubes that the plan does not reach; larger groups come first
///   retests: [{tube, package, mark, reason, who, at}]
///   wrong: [{tube, package, found, method, who, at, is_resolved}], confirmations of the shift that found another tube
///   legs: as legMapsJson(); letters: as standingLettersJson(); events: as in logJson(), of the shift alone
///   plan: as jobPlanJson() returned it, or null; planned_at: its time, or empty
[[nodiscard]] nlohmann::json handOverJson(JobStore& store, const HandOver& of, const HandOverRequest& request,
                                          const std::string& made_at);

/// Returns a summary of the page in a few lines of text.
[[nodiscard]] std::string handOverText(const nlohmann::json& hand_over);

}  // namespace tubeplan::app
