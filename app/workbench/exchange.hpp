// Request to the workbench and its answer, independent of any network library.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace tubeplan::app {

class InputError;

/// Received request; the size and the nesting depth of its body are limited.
struct Request {
  std::string method;                        ///< HTTP method: GET, POST or DELETE
  std::vector<std::string> words;            ///< segments of the path after "/api/": {"jobs", "3", "cancel"}
  std::map<std::string, std::string> query;  ///< decoded parameters
  std::string content_type, body;

  /// Returns the value of a query parameter; empty if it is missing.
  [[nodiscard]] std::string parameter(const std::string& name) const {
    const auto found = query.find(name);
    return found == query.end() ? std::string() : found->second;
  }
};

struct Answer {
  int status = 200;
  std::string content_type = "application/json";
  std::string body;
  std::vector<std::pair<std::string, std::string>> headers;
};

/// Returns a document as an answer. Non-finite numbers become null; bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] Answer answerOf(const nlohmann::json& json, int status = 200);

/// Returns {"error": {where, found, expected, advice, message}} as an answer with this status.
[[nodiscard]] Answer refusal(int status, const InputError& error);
[[nodiscard]] nlohmann::json errorJson(const InputError& error);

/// Returns an answer that the browser saves as a file.
[[nodiscard]] Answer downloadOf(const std::string& name, const std::string& content_type, std::string content);

}  // namespace tubeplan::app
