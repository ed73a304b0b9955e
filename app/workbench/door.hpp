// Who may come in: rules on the headers of a request, looked at before anything else.
#pragma once

#include <string>
#include <vector>

namespace tubeplan::app {

struct DoorRules {
  std::string host = "127.0.0.1";  ///< the address that is listened at
  int port = 0;
  std::string token;  ///< empty: none is asked for
};

/// The headers that the rules look at; empty where the request has none.
struct Visitor {
  std::string method, path;
  std::string host, origin, fetch_site, authorization, cookie;
};

/// 0 for one who may come in, else the HTTP status: 401 for a missing or wrong token, 403 for another Host, another
/// Origin, or a request that another site's page has sent.
[[nodiscard]] int refuseAtDoor(const DoorRules& rules, const Visitor& visitor);

/// Whether that is a name or address of this machine alone.
[[nodiscard]] bool isLoopback(const std::string& host);

/// The Set-Cookie value that stands for the token.
[[nodiscard]] std::string tokenCookie(const std::string& token);

/// Takes as long for a right guess as for a wrong one of the same length.
[[nodiscard]] bool equalInConstantTime(const std::string& a, const std::string& b);

}  // namespace tubeplan::app
