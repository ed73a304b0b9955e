// Rules on the headers of a request that decide on its admission, checked before anything else.
#pragma once

#include <string>
#include <vector>

namespace tubeplan::app {

struct DoorRules {
  std::string host = "127.0.0.1";  ///< address of the server
  int port = 0;
  std::string token;  ///< empty: no token is required
};

/// Headers that the rules check; empty if the request has none.
struct Visitor {
  std::string method, path;
  std::string host, origin, fetch_site, authorization, cookie;
};

/// Returns 0 for an admitted request, else the HTTP status: 401 for a missing or wrong token, 403 for another Host,
/// another Origin, or a request sent by a page of another site.
[[nodiscard]] int refuseAtDoor(const DoorRules& rules, const Visitor& visitor);

/// Returns true if that is a name or address of this machine alone.
[[nodiscard]] bool isLoopback(const std::string& host);

/// Returns the Set-Cookie value for the token.
[[nodiscard]] std::string tokenCookie(const std::string& token);

/// Returns true if the texts are equal, in a time that depends on their lengths alone.
[[nodiscard]] bool equalInConstantTime(const std::string& a, const std::string& b);

}  // namespace tubeplan::app
