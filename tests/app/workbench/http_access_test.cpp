// Tests over a real socket that a request refused by the access rules stays refused, regardless of the bytes that
// follow on the connection.
#include "tests/app/workbench/raw_connection.hpp"
#include "tests/app/workbench/running_server.hpp"

namespace tubeplan::app {
namespace {

class HttpAccess : public WorkbenchTest {
 protected:
  [[nodiscard]] int connected() const {
    const int socket = connectedTo(server->port());
    EXPECT_GE(socket, 0);
    return socket;
  }

  /// Returns all that the server sends in answer to these bytes until it closes the connection.
  [[nodiscard]] std::string said(const std::string& bytes) const { return saidTo(server->port(), bytes); }
  [[nodiscard]] std::string host() const { return "Host: 127.0.0.1:" + std::to_string(server->port()) + "\r\n"; }
};

TEST_F(HttpAccess, everyAnswerForbidsWhatThePageDoesNotNeed) {
  serve("bench.yaml");
  for (const char* path : {"/", "/api/state", "/missing.js", "/api/missing"}) {
    const auto reply = get(path);
    const auto header = [&](const char* name) { return reply.headers.find(name)->second; };
    EXPECT_EQ(header("X-Content-Type-Options"), "nosniff") << path;
    EXPECT_TRUE(header("Content-Security-Policy").starts_with("default-src 'self'")) << path;
    EXPECT_EQ(reply.headers.count("Access-Control-Allow-Origin"), 0u) << path;
  }
  EXPECT_EQ(get("/").status, 200);
  EXPECT_EQ(get("/missing.js").status, 404);
  EXPECT_EQ(get("/../../etc/passwd.x").status, 404);
  EXPECT_EQ(get("/%2e%2e/%2e%2e/etc/hosts.x").status, 404);
  EXPECT_EQ(get("/api/missing").status, 404);
}

TEST_F(HttpAccess, thePageComesFromItsFolderAlone) {
  std::filesystem::create_directories(folder / "page/assets");
  write("page/index.html", "the page");
  write("page/assets/a.js", "the script");
  write("secret.js", "secret");
  std::filesystem::create_symlink(folder / "secret.js", folder / "page/out.js");
  WorkbenchOptions options;
  options.cell = (opened() / "bench.yaml").string();
  server = std::make_unique<RunningServer>(options, "", (folder / "page").string());
  client = server->client();
  EXPECT_EQ(get("/").text, "the page");
  EXPECT_EQ(get("/sheet").text, "the page");
  EXPECT_EQ(get("/assets/a.js").text, "the script");
  EXPECT_TRUE(get("/assets/a.js").headers.find("Content-Type")->second.starts_with("text/javascript"));
  for (const char* path :
       {"/out.js", "/../secret.js", "/assets/../../secret.js", "/%2e%2e/secret.js", "/assets/b.js", "/."})
    EXPECT_EQ(get(path).status, 404) << path;
}

TEST_F(HttpAccess, canBeShutBeforeItIsOpen) {
  for (int k = 0; k < 20; ++k) serve("bench.yaml");
  EXPECT_EQ(get("/api/state").status, 200);
}

TEST_F(HttpAccess, refusesOtherHosts) {
  serve("bench.yaml");
  EXPECT_TRUE(said("GET /api/state HTTP/1.1\r\nHost: evil.example\r\n\r\n").starts_with("HTTP/1.1 403"));
  EXPECT_TRUE(said("GET /api/state HTTP/1.1\r\n\r\n").starts_with("HTTP/1.1 403"));
  EXPECT_TRUE(said("GET /api/state HTTP/1.1\r\n" + host() + host() + "\r\n").starts_with("HTTP/1.1 403"));
  EXPECT_TRUE(said("GET /api/state HTTP/1.1\r\n" + host() + "\r\n").starts_with("HTTP/1.1 200"));
}

TEST_F(HttpAccess, aRefusedBodyIsNoSecondRequest) {
  serve("bench.yaml");
  const std::string inner = "POST /api/simulate HTTP/1.1\r\n" + host() + "Content-Length: 0\r\n\r\n";
  const std::string outer = "POST /api/undo HTTP/1.1\r\n" + host() +
                            "Origin: http://evil.example\r\nContent-Type: text/plain\r\n" +
                            "Content-Length: " + std::to_string(inner.size()) + "\r\n\r\n" + inner;
  const std::string answer = said(outer);
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 403"));
  EXPECT_EQ(answer.find("HTTP/1.1", 1), std::string::npos) << answer;
  const std::string looking =
      "GET /api/state HTTP/1.1\r\n" + host() + "Content-Length: " + std::to_string(inner.size()) + "\r\n\r\n" + inner;
  EXPECT_EQ(said(looking).find("HTTP/1.1", 1), std::string::npos);
  EXPECT_TRUE(get("/api/state").body["jobs"].empty());
}

TEST_F(HttpAccess, answersTwoRequestsOnOneConnection) {
  serve("bench.yaml");
  const std::string post =
      "POST /api/undo HTTP/1.1\r\n" + host() + "Content-Type: application/json\r\nContent-Length: 2\r\n\r\n{}";
  const std::string answer = said(post + "GET /api/files HTTP/1.1\r\n" + host() + "\r\n");
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 409"));
  EXPECT_NE(answer.find("HTTP/1.1 200"), std::string::npos);
}

TEST_F(HttpAccess, twoHundredRequestsThatAreNotFinishedStallNobody) {
  serve("bench.yaml");
  const std::string body =
      "POST /api/undo HTTP/1.1\r\n" + host() + "Content-Type: application/json\r\nContent-Length: 100\r\n\r\n{";
  for (const std::string& begun : {std::string("GET /api/sta"), body}) {
    const auto start = std::chrono::steady_clock::now();  // includes the time to connect
    std::vector<int> sockets;
    for (int k = 0; k < 200; ++k) {
      sockets.push_back(connected());
      EXPECT_GT(::send(sockets.back(), begun.data(), begun.size(), MSG_NOSIGNAL), 0);
    }
    EXPECT_EQ(replyOf(server->client()->Get("/api/state")).status, 200);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(4)) << begun;
    for (const int socket : sockets) ::close(socket);
  }
}

TEST_F(HttpAccess, boundsWhatIsSent) {
  serve("bench.yaml");
  const std::string large(9u << 20, 'x');
  EXPECT_EQ(replyOf(client->Post("/api/measurements", large, "text/csv")).status, 413);
  EXPECT_EQ(get("/api/state?" + std::string(3000, 'x')).status, 414);
  EXPECT_EQ(replyOf(client->Post("/api/undo", "a=b", "application/x-www-form-urlencoded")).status, 415);
  EXPECT_EQ(replyOf(client->Post("/api/undo", "{}", "text/plain")).status, 415);
  std::string headers;
  for (int k = 0; k < 200000; ++k) headers += "X-Header-" + std::to_string(k) + ": " + std::string(60, 'x') + "\r\n";
  EXPECT_FALSE(said("GET /api/state HTTP/1.1\r\n" + host() + headers + "\r\n").starts_with("HTTP/1.1 200"));
  EXPECT_EQ(get("/api/state").status, 200);
}

TEST_F(HttpAccess, refusesDeepAndBrokenJson) {
  serve("bench.yaml");
  const auto status = [&](const std::string& body) {
    return replyOf(client->Post("/api/pose", body, "application/json")).status;
  };
  EXPECT_EQ(status("{"), 400);
  EXPECT_EQ(status("[]"), 400);
  EXPECT_EQ(status("\"x\""), 400);
  EXPECT_EQ(status("{\"joints\":" + std::string(1000000, '[') + std::string(1000000, ']') + "}"), 400);
  EXPECT_EQ(status("\xff\xfe"), 400);
  EXPECT_EQ(status("{\"joints\": \"1,2,3,4\"}"), 422);
  EXPECT_EQ(status("{\"joints\": [1, 2, 3]}"), 422);
  EXPECT_EQ(status("{\"joints\": [1, 2, 3, 1e999]}"), 400);
  EXPECT_EQ(status("{\"joints\": [0, 30, -60, 20], \"load\": -1}"), 422);
  EXPECT_EQ(status("{\"joints\": [0, 30, -60, 2000]}"), 422);
  EXPECT_EQ(status("{\"joints\": [0, 30, -60, 20]}"), 200);
}

TEST_F(HttpAccess, anOpenDoorAsksForTheToken) {
  serve("bench.yaml", "", "correct-horse-battery");
  EXPECT_EQ(get("/api/state").status, 401);
  EXPECT_EQ(get("/").status, 401);
  EXPECT_EQ(get("/?token=wrong").status, 401);
  EXPECT_NE(server->address().find("?token=correct-horse-battery"), std::string::npos);
  const auto let_in = get("/?token=correct-horse-battery");
  EXPECT_EQ(let_in.status, 303);
  const std::string cookie = let_in.headers.find("Set-Cookie")->second;
  EXPECT_NE(cookie.find("HttpOnly"), std::string::npos);
  EXPECT_NE(cookie.find("SameSite=Strict"), std::string::npos);
  const auto shown = client->Get("/api/state", {{"Cookie", cookie.substr(0, cookie.find(';'))}});
  EXPECT_EQ(shown->status, 200);
  client->set_bearer_token_auth("correct-horse-battery");
  EXPECT_EQ(get("/api/state").status, 200);
}

TEST_F(HttpAccess, listenersAreBoundedAndLeave) {
  serve("bench.yaml");
  const auto listen = [&](std::atomic<bool>& heard, std::atomic<bool>& stop) {
    auto own = server->client();
    (void)own->Get("/api/events", [&](const char*, std::size_t) {
      heard = true;
      return !stop.load();
    });
  };
  std::atomic<bool> stop = false;
  std::vector<std::unique_ptr<std::atomic<bool>>> heard;
  std::vector<std::thread> threads;
  for (int k = 0; k < 16; ++k) {
    heard.push_back(std::make_unique<std::atomic<bool>>(false));
    threads.emplace_back([&listen, &stop, flag = heard.back().get()] { listen(*flag, stop); });
  }
  for (const auto& flag : heard)
    while (!*flag) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(get("/api/events").status, 503);
  EXPECT_EQ(get("/api/state").status, 200);
  stop = true;
  server->workbench().events().stateChanged();
  for (auto& thread : threads) thread.join();
  int status = 503;
  for (int k = 0; k < 500 && status == 503; ++k) {
    auto own = server->client();
    (void)own->Get(
        "/api/events", [&](const httplib::Response& response) { return status = response.status, status != 200; },
        [](const char*, std::size_t) { return false; });
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(status, 200);
}

}  // namespace
}  // namespace tubeplan::app
