// Random requests to the workbench: valid requests, damaged requests, and bytes that form no request.
#pragma once

#include <unistd.h>

#include <fstream>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "tests/app/workbench/raw_connection.hpp"

namespace tubeplan::app {

/// Number of requests for each HTTP status of the answer; status 0: the connection was closed without an answer.
using CallCounts = std::map<int, int>;

/// Draws random requests and sends them to a server on loopback.
class RandomCalls {
 public:
  RandomCalls(int port, std::uint64_t seed) : port_(port), random_(seed) {}

  CallCounts make(int count) {
    CallCounts counts;
    for (int k = 0; k < count; ++k) ++counts[statusOf(saidTo(port_, draw() % 12 == 0 ? noise() : call()))];
    return counts;
  }

 private:
  std::uint64_t draw() { return random_(); }

  template <std::size_t N>
  std::string one(const char* const (&words)[N]) {
    return words[draw() % N];
  }

  std::string value(int depth) {
    static constexpr const char* kValues[] = {"null",
                                              "true",
                                              "false",
                                              "0",
                                              "-1",
                                              "1",
                                              "3.5",
                                              "1e9",
                                              "-1e300",
                                              "1e999",
                                              "18446744073709551616",
                                              "\"\"",
                                              "\"R1C1\"",
                                              "\"all\"",
                                              "\"spread:5\"",
                                              "\"../../etc/passwd\"",
                                              "\"bench.yaml\"",
                                              "\"mockup.yaml\"",
                                              "\"link.yaml\"",
                                              "\"mockup-true.yaml\"",
                                              "\"backlash\"",
                                              "\"tool.z\"",
                                              "\"joint-offset\"",
                                              "\"theta3\"",
                                              "\"theta3 += c*sin(theta1)\"",
                                              "\"theta3 += 1/0\"",
                                              "\"base\"",
                                              "\"sag\"",
                                              "\"bench\"",
                                              "\"\\u0000\"",
                                              "\"\\ud800\"",
                                              "[0,30,-60,20]",
                                              "[10,45,-70,10]",
                                              "[0,1,2]",
                                              "[\"joint-offset@theta3\"]",
                                              "[\"coordinates=mm\"]",
                                              "[]",
                                              "{}",
                                              "NaN",
                                              "\xff"};
    if (depth > 3 || draw() % 4) return one(kValues);
    if (draw() % 2) return object(depth + 1);
    std::string list = "[";
    for (std::uint64_t k = draw() % 4; k > 0; --k) list += value(depth + 1) + (k > 1 ? "," : "");
    return list + "]";
  }

  std::string object(int depth) {
    static constexpr const char* kKeys[] = {
        "joints", "load",     "hole",         "text",      "tubes", "file",   "effects", "effect",   "at",    "formula",
        "seed",   "of",       "goal",         "count",     "free",  "hide",   "design",  "readings", "folds", "next",
        "branch", "simulate", "compensation", "overwrite", "steps", "causes", "model",   "assume"};
    std::string text = "{";
    for (std::uint64_t k = draw() % 5; k > 0; --k)
      text += "\"" + one(kKeys) + "\":" + value(depth) + (k > 1 ? "," : "");
    return text + "}";
  }

  std::string measurements() {
    std::string text =
        "id,kind,point,load_lbf,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,sigma_in\n"
        "1,position,,0,0,30,-60,20,70,1,20,0.005\n2,position,,20,10,40,-50,10,60,12,22,0.005\n"
        "3,position,,0,-20,35,-55,0,62,-22,25,0.005\n4,position,,20,30,50,-80,30,55,31,18,0.005\n";
    return damaged(text);
  }

  std::string damaged(std::string text) {
    static constexpr const char* kPieces[] = {"",   "{",  "}",     "[",   "\"",   ",",    ":",
                                              "\n", "-1", "1e999", "nan", "\xC3", "\x01", "\\"};
    for (std::uint64_t hits = draw() % 4; hits > 0 && !text.empty(); --hits) {
      const std::size_t at = draw() % text.size();
      text.replace(at, std::min<std::size_t>(draw() % 5, text.size() - at), one(kPieces));
    }
    return text;
  }

  static constexpr const char* kGets[] = {"/api/state",
                                          "/api/sheet",
                                          "/api/scene",
                                          "/api/catalogue",
                                          "/api/files",
                                          "/api/measurements",
                                          "/api/leverage?at=theta3,forearm.z",
                                          "/api/leverage?at=%00",
                                          "/api/confounding",
                                          "/api/touches",
                                          "/api/results/compare",
                                          "/api/results/compare?model=-1e999",
                                          "/api/export/project.tubeplan",
                                          "/api/plan/path",
                                          "/api/export/cell.yaml",
                                          "/api/export/plan.json",
                                          "/api/export/measurements.csv",
                                          "/api/export/run-sheet.csv",
                                          "/api/export/compare.html",
                                          "/",
                                          "/index.html"};
  static constexpr const char* kPosts[] = {"/api/pose",
                                           "/api/pose",
                                           "/api/inverse",
                                           "/api/select",
                                           "/api/measurements",
                                           "/api/measurements?name=%2e%2e%2fx",
                                           "/api/measurements/open",
                                           "/api/measurements/set-aside",
                                           "/api/measurements/hold-out",
                                           "/api/measurements/assume",
                                           "/api/measurements/part",
                                           "/api/live/encoders",
                                           "/api/live/readings",
                                           "/api/project/open",
                                           "/api/project/save",
                                           "/api/cell/open",
                                           "/api/cell/save",
                                           "/api/undo",
                                           "/api/redo",
                                           "/api/models/go",
                                           "/api/remove",
                                           "/api/compare",
                                           "/api/identify",
                                           "/api/ladder",
                                           "/api/add",
                                           "/api/simulate",
                                           "/api/touches",
                                           "/api/touch",
                                           "/api/calibrate",
                                           "/api/reach",
                                           "/api/field",
                                           "/api/plan"};
  static constexpr const char* kOthers[] = {"/api/results/%00",
                                            "/api/touch/0",
                                            "/api/export/../cell.yaml",
                                            "/../../../etc/passwd",
                                            "/%2e%2e/%2e%2e/etc/hosts",
                                            "/api",
                                            "/api/",
                                            "//",
                                            "/api//state",
                                            "*"};

  std::string path(const std::string& method) {
    if (draw() % 8 == 0) return draw() % 2 ? one(kOthers) : draw() % 2 ? one(kGets) : one(kPosts);
    if (method == "POST" && draw() % 12 == 0) return "/api/jobs/" + std::to_string(draw() % 60) + "/cancel";
    return method == "POST" ? one(kPosts) : one(kGets);
  }

  std::string call() {
    static constexpr const char* kMethods[] = {"GET",  "POST", "POST",    "POST", "DELETE",
                                               "HEAD", "PUT",  "OPTIONS", "TRACE"};
    static constexpr const char* kTypes[] = {"application/json",
                                             "application/json",
                                             "application/json",
                                             "application/json",
                                             "application/json",
                                             "application/json",
                                             "application/json",
                                             "application/json",
                                             "text/csv",
                                             "multipart/form-data; boundary=x",
                                             "application/x-www-form-urlencoded",
                                             ""};
    const std::string method = draw() % 10 == 0 ? one(kMethods) : draw() % 4 == 0 ? "GET" : "POST";
    const std::string where = path(method);
    const std::string type = where.find("measurements?") != std::string::npos ? "text/csv" : one(kTypes);
    std::string body = method == "GET" ? "" : type == "text/csv" ? measurements() : object(0);
    if (draw() % 5 == 0) body = damaged(body);
    const std::size_t length = draw() % 20 ? body.size() : draw() % 200;
    std::string text = method + " " + where + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) + "\r\n";
    if (!type.empty()) text += "Content-Type: " + type + "\r\n";
    if (draw() % 25 == 0) text += "Origin: http://evil.example\r\n";
    if (draw() % 25 == 0) text += "Content-Encoding: gzip\r\n";
    if (draw() % 25 == 0) text += "Range: bytes=0-0,1-1,5-2,-1\r\n";
    if (draw() % 25 == 0) text += "Expect: 100-continue\r\n";
    if (draw() % 25 == 0)
      return text + "Transfer-Encoding: chunked\r\n\r\n" + damaged("5\r\n{\"a\":\r\n3\r\n 1}\r\n0\r\n\r\n");
    return text + "Content-Length: " + std::to_string(length) + "\r\n\r\n" + body;
  }

  std::string noise() {
    std::string bytes;
    for (std::uint64_t k = draw() % 400; k > 0; --k) bytes += static_cast<char>(draw());
    return draw() % 2 ? bytes : "GET / HTTP/1.1\r\n" + bytes + "\r\n\r\n";
  }

  static int statusOf(const std::string& answer) {
    return answer.starts_with("HTTP/1.1 ") ? std::atoi(answer.c_str() + 9) : 0;
  }

  int port_;
  std::mt19937_64 random_;
};

/// Returns the resident memory of this process [bytes].
inline std::size_t residentMemory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmRSS:")) return std::stoul(line.substr(6)) << 10;
  return 0;
}

}  // namespace tubeplan::app
