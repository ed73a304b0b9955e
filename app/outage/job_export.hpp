// Export of a job's packages and of its log as tables for other programs.
#pragma once

#include <string>

#include "app/outage/job_store.hpp"

namespace tubeplan::app {

/// Returns the items of one package on one leg as a work list. A package that was read from a list keeps the list byte
/// for byte, with columns `standing`, `mark`, `marked_by`, `marked_at` and `visit` added at the end. Throws InputError
/// if the package has no item there.
[[nodiscard]] std::string packageCsv(JobStore& store, const std::string& package, const std::string& generator,
                                     tubesheets::Leg leg);

/// Returns the log: event,at,who,kind,package,sg,leg,row,column,value,method,reason,undoes.
[[nodiscard]] std::string logCsv(JobStore& store);

}  // namespace tubeplan::app
