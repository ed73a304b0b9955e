#include "app/workbench/access.hpp"

#include <arpa/inet.h>

#include <algorithm>

#include "app/storage/lower_case.hpp"

namespace tubeplan::app {

namespace {

constexpr const char* kCookie = "tubeplan_token";

std::string inBrackets(const std::string& host) {
  return host.find(':') != std::string::npos && host.front() != '[' ? "[" + host + "]" : host;
}

bool isAnyAddress(const std::string& host) { return host == "0.0.0.0" || host == "::" || host == "[::]"; }

bool isNumericAddress(std::string host) {
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
  unsigned char address[sizeof(in6_addr)];
  return ::inet_pton(AF_INET, host.c_str(), address) == 1 || ::inet_pton(AF_INET6, host.c_str(), address) == 1;
}

/// Returns true if the value "name:port" of a Host header is allowed; a missing port means 80.
bool hostAllowed(const AccessRules& rules, const std::string& header) {
  const std::string text = lowerCase(header);
  const std::size_t bracket = text.rfind(']'), colon = text.rfind(':');
  const bool has_port = colon != std::string::npos && (bracket == std::string::npos || colon > bracket);
  const std::string name = text.substr(0, has_port ? colon : std::string::npos);
  if ((has_port ? text.substr(colon + 1) : "80") != std::to_string(rules.port)) return false;
  if (name == "localhost" || name == "127.0.0.1" || name == "[::1]" || name == lowerCase(inBrackets(rules.host)))
    return true;
  // A server that listens on all addresses accepts only numeric hosts, because anyone can register a name that points
  // to this machine.
  return isAnyAddress(rules.host) && isNumericAddress(name);
}

bool originAllowed(const AccessRules& rules, const Visitor& visitor) {
  if (!visitor.origin.empty()) {
    const std::string scheme = "http://";
    return visitor.origin.starts_with(scheme) && hostAllowed(rules, visitor.origin.substr(scheme.size())) &&
           lowerCase(visitor.origin.substr(scheme.size())) == lowerCase(visitor.host);
  }
  return visitor.fetch_site.empty() || visitor.fetch_site == "same-origin" || visitor.fetch_site == "none";
}

/// Returns the token in the Cookie header; empty if there is none.
std::string cookieOf(const std::string& header) {
  for (std::size_t from = 0; from < header.size();) {
    const std::size_t to = std::min(header.find(';', from), header.size());
    std::size_t start = from;
    while (start < to && header[start] == ' ') ++start;
    const std::string part = header.substr(start, to - start), name = std::string(kCookie) + "=";
    if (part.starts_with(name)) return part.substr(name.size());
    from = to + 1;
  }
  return "";
}

bool tokenShown(const AccessRules& rules, const Visitor& visitor) {
  const std::string bearer = "Bearer ";
  if (visitor.authorization.starts_with(bearer))
    return equalInConstantTime(visitor.authorization.substr(bearer.size()), rules.token);
  return equalInConstantTime(cookieOf(visitor.cookie), rules.token);
}

}  // namespace

bool equalInConstantTime(const std::string& a, const std::string& b) {
  unsigned difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t k = 0; k < b.size(); ++k)
    difference |= static_cast<unsigned char>(k < a.size() ? a[k] : 0) ^ static_cast<unsigned char>(b[k]);
  return difference == 0;
}

std::string tokenCookie(const std::string& token) {
  return std::string(kCookie) + "=" + token + "; Path=/; HttpOnly; SameSite=Strict";
}

bool isLoopback(const std::string& host) {
  const std::string name = lowerCase(host);
  return name == "localhost" || name == "127.0.0.1" || name == "::1" || name == "[::1]";
}

int refuseAccess(const AccessRules& rules, const Visitor& visitor) {
  if (!hostAllowed(rules, visitor.host)) return 403;
  const bool is_read_only = visitor.method == "GET" || visitor.method == "HEAD";
  const bool is_api = visitor.path.starts_with("/api");
  if ((!is_read_only || is_api) && !originAllowed(rules, visitor)) return 403;
  if (!rules.token.empty() && !tokenShown(rules, visitor)) return 401;
  return 0;
}

}  // namespace tubeplan::app
