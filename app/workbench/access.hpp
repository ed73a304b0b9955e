// Admission rules on the headers of a request, checked before the request is handled.
#pragma once

#include <string>
#include <vector>

namespace tubeplan::app {

struct AccessRules {
  std::string host = "127.0.0.1";  ///< address at which the server listens
  int port = 0;
  std::string token;  ///< secret that a request must present; if empty, none is required
};

/// Parts of a request that the rules check; a missing header is empty.
struct Visitor {
  std::string method, path;
  std::string host, origin, fetch_site, authorization, cookie;
};

/// Returns 0 for an admitted request, otherwise the HTTP status: 401 for a missing or wrong token; 403 for a wrong
/// Host, a wrong Origin, or a request sent by a page of another site.
[[nodiscard]] int refuseAccess(const AccessRules& rules, const Visitor& visitor);

/// Returns true if `host` is the name or an address of the loopback interface.
[[nodiscard]] bool isLoopback(const std::string& host);

/// Returns the Set-Cookie value for the token.
[[nodiscard]] std::string tokenCookie(const std::string& token);

/// Returns true if the strings are equal, in a time that depends only on their lengths.
[[nodiscard]] bool equalInConstantTime(const std::string& a, const std::string& b);

}  // namespace tubeplan::app
