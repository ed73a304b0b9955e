#include "app/workbench/http_server.hpp"

#include <fmt/format.h>
#include <httplib.h>
#include <sys/socket.h>

#include <atomic>
#include <chrono>
#include <cstring>
#include <thread>

#include "app/storage/input_error.hpp"
#include "app/workbench/connection.hpp"
#include "app/workbench/page_files.hpp"
#include "app/workbench/routes.hpp"
#include "app/workbench/shown_units.hpp"
#include "app/workbench/state_json.hpp"

namespace tubeplan::app {

namespace {

constexpr std::size_t kConnectionsAtOnce = 256;  // one thread per connection; further connections wait
constexpr std::size_t kLargestBody = 8u << 20;
constexpr std::size_t kLongestTarget = 2048;
constexpr auto kHeartbeat = std::chrono::seconds(10);
constexpr auto kGlanceAtListener = std::chrono::seconds(1);  // interval at which closed listeners are detected
constexpr const char* kPolicy =
    "default-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'; object-src 'none'";

/// True if the connection may serve another request: the body of the current request was read completely, so that its
/// remainder cannot be mistaken for the next request.
thread_local bool is_read_whole = false;

bool hasBody(const httplib::Request& request) {
  return request.has_header("Transfer-Encoding") ||
         (request.has_header("Content-Length") && request.get_header_value("Content-Length") != "0");
}

void put(const Answer& answer, httplib::Response& response) {
  response.status = answer.status;
  response.set_content(answer.body, answer.content_type);
  for (const auto& [name, value] : answer.headers) response.set_header(name, value);
}

Answer refused(int status, const httplib::Request& request) {
  switch (status) {
    case 401:
      return refusal(401, InputError::problem("Authorization", "the token is missing or wrong",
                                              "open the address that the program printed"));
    case 403:
      return refusal(403,
                     InputError::problem("Host, Origin", "the request comes from another site, or names another host",
                                         "open the address that the program printed"));
    case 413:
      return refusal(413, InputError("request body", "more than 8 MiB", "at most 8 MiB"));
    case 414:
      return refusal(414, InputError("address", fmt::format("more than {} bytes", kLongestTarget),
                                     fmt::format("at most {} bytes", kLongestTarget)));
    case 415:
      return refusal(415, InputError("Content-Type", inQuotes(request.get_header_value("Content-Type")),
                                     "application/json or text/csv"));
    case 404:
      return refusal(404, InputError::problem(inQuotes(request.path), "there is no such page",
                                              "open the address that the program printed"));
    default:
      return refusal(
          status, InputError::problem("request", fmt::format("the request cannot be answered (HTTP status {})", status),
                                      "send a complete HTTP/1.1 request; docs/workbench_api.md lists the addresses"));
  }
}

bool hasKnownContent(const httplib::Request& request) {
  std::string type = request.get_header_value("Content-Type");
  type = type.substr(0, type.find(';'));
  return type == "application/json" || type == "text/csv" || (type.empty() && !hasBody(request));
}

std::vector<std::string> wordsAfterApi(const std::string& path) {
  std::vector<std::string> words;
  for (std::size_t from = std::strlen("/api/"); from <= path.size();) {
    const std::size_t to = std::min(path.find('/', from), path.size());
    words.push_back(path.substr(from, to - from));
    from = to + 1;
  }
  return words;
}

Request requestOf(const httplib::Request& received, std::string body) {
  Request request;
  request.method = received.method == "HEAD" ? "GET" : received.method;
  request.words = wordsAfterApi(received.path);
  for (const auto& [name, value] : received.params) request.query[name] = value;
  request.content_type = received.get_header_value("Content-Type");
  request.body = std::move(body);
  return request;
}

std::string eventText(const char* name, const std::string& data) {
  return fmt::format("event: {}\ndata: {}\n\n", name, data);
}

}  // namespace

class HttpServer::Implementation : public httplib::Server {
 public:
  Implementation(Workbench& workbench, AccessRules access, const std::string& page_folder)
      : workbench_(workbench), access_rules_(std::move(access)), page_(page_folder) {
    new_task_queue = [] { return new httplib::ThreadPool(kConnectionsAtOnce); };
    set_payload_max_length(kLargestBody);
    // Do not set SO_REUSEPORT, so that no other program can listen on the same port.
    set_socket_options([](socket_t socket) {
      const int yes = 1;
      ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    set_tcp_nodelay(true);
    set_default_headers({{"Content-Security-Policy", kPolicy},
                         {"X-Content-Type-Options", "nosniff"},
                         {"X-Frame-Options", "DENY"},
                         {"Referrer-Policy", "no-referrer"},
                         {"Cross-Origin-Resource-Policy", "same-origin"},
                         {"Cross-Origin-Opener-Policy", "same-origin"}});
    set_pre_routing_handler([this](const auto& request, auto& response) { return checkAccess(request, response); });
    set_exception_handler([](const auto& request, auto& response, std::exception_ptr) {
      fmt::print(stderr, "tubeplan: {} {}: internal error\n", request.method, request.path);
      put(refused(500, request), response);
    });
    Get("/.*", [this](const auto& request, auto& response) { look(request, response); });
    Post("/.*", [this](const auto& request, auto& response, const auto& body) { act(request, response, body); });
    Delete("/.*", [this](const auto& request, auto& response, const auto& body) { act(request, response, body); });
    listenAtPort();
  }

  void runUntilStopped() {
    if (!is_closing_) listen_after_bind();
    has_ended_ = true;
  }

  void stopAll() {
    is_closing_ = true;
    workbench_.events().close();
    // stop() has no effect before the library listens, so wait until it does.
    while (!is_running() && !has_ended_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (is_running()) stop();
  }

  [[nodiscard]] const AccessRules& access() const { return access_rules_; }

 private:
  void listenAtPort() {
    std::string host = access_rules_.host;
    if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
    const bool is_bound = access_rules_.port == 0 ? (access_rules_.port = bind_to_any_port(host)) > 0
                                                  : bind_to_port(host, access_rules_.port);
    if (!is_bound)
      throw InputError::problem(
          "--port", fmt::format("the server cannot listen on port {} of {}", access_rules_.port, access_rules_.host),
          "give a free port of this machine; --port 0 chooses any free port");
    // The library's backlog of five is too small: clients that it refuses retry only after a second or more.
    ::listen(svr_sock_, SOMAXCONN);
  }

  bool process_and_close_socket(socket_t socket) override {
    const ConnectionLimits limits;
    Connection connection(socket, limits, [this] { return is_closing_.load(); });
    const bool ok = answerAll(connection, limits.most_requests);
    connection.close();
    return ok;
  }

  bool answerAll(Connection& connection, int most_requests) {
    bool ok = false;
    for (int k = 0; k < most_requests && connection.waitForRequest(); ++k) {
      is_read_whole = false;
      bool is_closed = false;
      ok = process_request(connection, k + 1 == most_requests, is_closed, [](httplib::Request& request) {
        // Without these headers, the library neither compresses, which would take longer than it saves, nor
        // decompresses a small body, which could expand to a huge one.
        for (const char* header : {"Accept-Encoding", "Content-Encoding", "Range"}) request.headers.erase(header);
        request.ranges.clear();
      });
      if (!ok || is_closed || !is_read_whole) break;
    }
    return ok;
  }

  HandlerResponse checkAccess(const httplib::Request& request, httplib::Response& response) {
    const auto header = [&](const char* name) { return request.get_header_value(name); };
    int status = refuseAccess(access_rules_, {request.method, request.path, header("Host"), header("Origin"),
                                              header("Sec-Fetch-Site"), header("Authorization"), header("Cookie")});
    if (request.get_header_value_count("Host") != 1) status = 403;
    if (status == 401 && request.method == "GET" && showsToken(request)) return acceptToken(response);
    const bool is_read_only = request.method == "GET" || request.method == "HEAD";
    if (status == 0 && request.target.size() > kLongestTarget) status = 414;
    if (status == 0 && !is_read_only && !hasKnownContent(request)) status = 415;
    if (status == 0 && is_read_only && !hasBody(request)) is_read_whole = true;
    if (status == 0) return HandlerResponse::Unhandled;
    put(refused(status, request), response);
    return HandlerResponse::Handled;
  }

  [[nodiscard]] bool showsToken(const httplib::Request& request) const {
    return request.has_param("token") && equalInConstantTime(request.get_param_value("token"), access_rules_.token);
  }

  HandlerResponse acceptToken(httplib::Response& response) const {
    response.set_header("Set-Cookie", tokenCookie(access_rules_.token));
    response.set_redirect("/", 303);
    return HandlerResponse::Handled;
  }

  void look(const httplib::Request& request, httplib::Response& response) {
    if (request.path == "/api/events") return listen(request, response);
    if (request.path.starts_with("/api/")) {
      response.set_header("Cache-Control", "no-store");
      return put(answer(workbench_, requestOf(request, "")), response);
    }
    const auto file = page_.find(request.path);
    if (!file) return put(refused(404, request), response);
    response.set_header("Cache-Control",
                        file->is_named_by_content ? "public, max-age=31536000, immutable" : "no-cache");
    response.set_content(file->content, file->content_type);
  }

  void act(const httplib::Request& request, httplib::Response& response, const httplib::ContentReader& read) {
    std::string body;
    bool is_too_large = false;
    const bool is_whole = !hasBody(request) || read([&](const char* data, std::size_t length) {
      is_too_large = body.size() + length > kLargestBody;
      if (!is_too_large) body.append(data, length);
      return !is_too_large;
    });
    if (is_too_large || response.status == 413) return put(refused(413, request), response);
    if (!is_whole) return put(refused(400, request), response);
    is_read_whole = true;
    if (!request.path.starts_with("/api/")) return put(refused(404, request), response);
    response.set_header("Cache-Control", "no-store");
    put(answer(workbench_, requestOf(request, std::move(body))), response);
  }

  void listen(const httplib::Request& request, httplib::Response& response) {
    Events& events = workbench_.events();
    if (request.method != "GET") return put(refused(405, request), response);
    if (!events.tryEnter())
      return put(refusal(503, InputError::problem("/api/events", "too many pages of this workbench are open",
                                                  "close one of them")),
                 response);
    response.set_header("Cache-Control", "no-store");
    auto seen = std::make_shared<Events::Seen>();
    auto spoken = std::make_shared<std::chrono::steady_clock::time_point>();
    std::optional<ShownUnits> units;
    try {
      units = ShownUnits::of(requestOf(request, ""));
    } catch (const InputError& error) {
      events.leave();
      return put(refusal(422, error), response);
    }
    response.set_chunked_content_provider(
        "text/event-stream",
        [this, seen, spoken, units](std::size_t, httplib::DataSink& sink) {
          return sendNews(*seen, *spoken, units, sink);
        },
        [&events](bool) { events.leave(); });
  }

  /// Sends the events since the last call, or a heartbeat if nothing was sent for a while. Returns false if the
  /// connection ends.
  bool sendNews(Events::Seen& seen, std::chrono::steady_clock::time_point& spoken,
                const std::optional<ShownUnits>& units, httplib::DataSink& sink) {
    const auto news = workbench_.events().wait(seen, kGlanceAtListener);
    if (news.closed || !sink.is_writable()) return false;
    std::string text;
    const auto shown = [&](const nlohmann::json& json) {
      return answerOf(units ? units->shown(json, workbench_.session()) : json).body;
    };
    if (news.state_changed) text += eventText("state", shown(stateJson(workbench_)));
    for (const auto& job : news.jobs) text += eventText("job", job);
    if (!news.live.empty()) text += eventText("live", units ? shown(nlohmann::json::parse(news.live)) : news.live);
    const auto now = std::chrono::steady_clock::now();
    if (text.empty() && now - spoken > kHeartbeat) text = eventText("alive", "{}");
    if (text.empty()) return true;
    spoken = now;
    return sink.write(text.data(), text.size());
  }

  Workbench& workbench_;
  AccessRules access_rules_;
  PageFiles page_;
  std::atomic<bool> is_closing_ = false, has_ended_ = false;
};

HttpServer::HttpServer(Workbench& workbench, AccessRules access, const std::string& page_folder)
    : implementation_(std::make_unique<Implementation>(workbench, std::move(access), page_folder)) {}

HttpServer::~HttpServer() = default;

int HttpServer::port() const { return implementation_->access().port; }

std::string HttpServer::address() const {
  const AccessRules& access = implementation_->access();
  const bool is_bare_v6 = access.host.find(':') != std::string::npos && access.host.front() != '[';
  const std::string host = is_bare_v6 ? "[" + access.host + "]" : access.host;
  return fmt::format("http://{}:{}/{}", host, access.port, access.token.empty() ? "" : "?token=" + access.token);
}

void HttpServer::run() { implementation_->runUntilStopped(); }

void HttpServer::stop() { implementation_->stopAll(); }

}  // namespace tubeplan::app
