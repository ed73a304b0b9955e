// Workbench server on its own port, in its own folder, with an HTTP client.
#pragma once

#include <httplib.h>
#undef _res  // macro of the resolver header that clashes with a name in Eigen

#include <chrono>
#include <future>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <utility>

#include "app/workbench/http_server.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {

/// Server in its own thread; the destructor stops the server and joins the thread.
class RunningServer {
 public:
  explicit RunningServer(const WorkbenchOptions& options, const std::string& token = "", const std::string& page = "")
      : workbench_(options), server_(workbench_, {"127.0.0.1", 0, token}, page), serving_([this] { server_.run(); }) {}
  ~RunningServer() {
    server_.stop();
    serving_.join();
  }

  [[nodiscard]] int port() const { return server_.port(); }
  [[nodiscard]] std::string address() const { return server_.address(); }
  [[nodiscard]] Workbench& workbench() { return workbench_; }

  [[nodiscard]] std::unique_ptr<httplib::Client> client() const {
    auto client = std::make_unique<httplib::Client>("127.0.0.1", port());
    client->set_read_timeout(60);
    return client;
  }

 private:
  Workbench workbench_;
  HttpServer server_;
  std::thread serving_;
};

/// Job that runs until it is released. Tests of calls that are refused during a job then have no race.
class HeldJob {
 public:
  explicit HeldJob(Workbench& workbench) {
    begun_ = workbench.jobs().begin("held", "held by a test", [until = released_.get_future().share()](JobContext&) {
      until.wait();
      return std::string();
    });
  }
  ~HeldJob() { release(); }

  [[nodiscard]] int id() const { return begun_.job["id"]; }
  void release() {
    if (!std::exchange(is_released_, true)) released_.set_value();
  }

 private:
  std::promise<void> released_;
  bool is_released_ = false;
  Jobs::Begun begun_;
};

struct Reply {
  int status = -1;
  nlohmann::json body;
  std::string text;
  httplib::Headers headers;
};

inline Reply replyOf(const httplib::Result& result) {
  if (!result) return {};
  return {result->status, nlohmann::json::parse(result->body, nullptr, false), result->body, result->headers};
}

/// Test fixture with the shipped cells and a small sheet, so that all holes are computed quickly.
class WorkbenchTest : public FolderTest {
 protected:
  WorkbenchTest() {
    std::filesystem::create_directories(opened());
    for (const char* name : {"cobra-arm.yaml", "cobra-arm-true.yaml", "bench.yaml"})
      std::filesystem::copy_file(shippedCells() / name, opened() / name);
    for (const char* name : {"mockup.yaml", "mockup-true.yaml"})
      write(std::string("opened/") + name,
            changed(contentOf(shippedCells() / name), "rows: 49, columns: 114", "rows: 8, columns: 12"));
  }

  [[nodiscard]] std::filesystem::path opened() const { return folder / "opened"; }

  void serve(const std::string& cell, const std::string& truth = "", const std::string& token = "") {
    WorkbenchOptions options;
    options.cell = (opened() / cell).string();
    if (!truth.empty()) options.truth = (opened() / truth).string();
    server = std::make_unique<RunningServer>(options, token);
    client = server->client();
  }

  Reply get(const std::string& path) { return replyOf(client->Get(path)); }
  Reply post(const std::string& path, const nlohmann::json& body = nlohmann::json::object()) {
    return replyOf(client->Post(path, body.dump(), "application/json"));
  }

  /// Starts a job, waits for its end and returns its final state.
  nlohmann::json work(const std::string& path, const nlohmann::json& body = nlohmann::json::object()) {
    const Reply begun = post(path, body);
    EXPECT_EQ(begun.status, 202) << path << begun.text;
    return begun.status == 202 ? ended(begun.body["id"]) : nlohmann::json();
  }

  nlohmann::json ended(int id) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::minutes(5);
    while (std::chrono::steady_clock::now() < until) {
      const auto state = get("/api/state").body;
      for (const auto& job : state["jobs"])
        if (job["id"] == id && job["status"] != "running") return job;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    ADD_FAILURE() << "job " << id << " does not end";
    return {};
  }

  nlohmann::json done(const std::string& path, const nlohmann::json& body = nlohmann::json::object()) {
    const auto job = work(path, body);
    EXPECT_EQ(job["status"], "done") << path << job.dump();
    return job;
  }

  /// Simulates measurements of the bench with a joint offset that the bench's model lacks.
  void simulate(int measurements = 30) {
    done("/api/simulate", {{"design", "bench"}, {"readings", measurements}, {"hide", {"joint-offset@theta3:0.3deg"}}});
  }

  std::unique_ptr<RunningServer> server;
  std::unique_ptr<httplib::Client> client;
};

}  // namespace tubeplan::app
