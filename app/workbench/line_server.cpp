#include "app/workbench/line_server.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/asio.hpp>
#include <chrono>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "app/formats/cell/command_inputs.hpp"
#include "app/storage/input_error.hpp"
#include "app/workbench/live.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using boost::asio::ip::tcp;
using Failure = boost::system::error_code;

constexpr std::size_t kLongestLine = 4096;
constexpr int kMostConnections = 16;

/// Returns the words of a line, separated by blanks, commas or semicolons.
std::vector<std::string> wordsOf(std::string line) {
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
  std::istringstream text(line);
  return {std::istream_iterator<std::string>(text), {}};
}

double loadOf(const std::string& word, const Units& units) {
  const auto load = tubesheets::parseNumber(word);
  if (!load) throw InputError("line (load)", inQuotes(word), "a number");
  return parseLoad(*load, units, "line (load)");
}

std::string tipText(const nlohmann::json& shown) {
  std::string text;
  for (const auto& coordinate : shown.at("tip"))
    text += (text.empty() ? "" : " ") + formatNumber(coordinate.get<double>());
  return text;
}

std::string answerTo(Workbench& workbench, const std::string& line) {
  try {
    const Session session = workbench.session();
    const Cell& cell = currentModel(session).cell;
    auto words = wordsOf(line);
    double load = 0;
    if (std::ssize(words) == cell.arm.jointCount() + 1) {
      load = loadOf(words.back(), cell.units);
      words.pop_back();
    }
    const auto q = parseJoints(fmt::format("{}", fmt::join(words, ",")), cell.arm, cell.units, "line");
    return tipText(showEncoders(workbench, q, load, "TCP"));
  } catch (const InputError& error) {
    return fmt::format("error: {}", error.what());
  }
}

/// Connection of one client. The next line is read only after the previous line is answered, so that a slow client
/// delays only itself.
class LineClient : public std::enable_shared_from_this<LineClient> {
 public:
  LineClient(tcp::socket socket, Workbench& workbench, int& open)
      : socket_(std::move(socket)), workbench_(workbench), open_(open) {
    ++open_;
  }
  ~LineClient() { --open_; }

  void readLine() {
    boost::asio::async_read_until(socket_, boost::asio::dynamic_buffer(text_, kLongestLine), '\n',
                                  [self = shared_from_this()](Failure failure, std::size_t size) {
                                    if (!failure) self->answer(size);
                                  });
  }

 private:
  void answer(std::size_t size) {
    const std::string line = text_.substr(0, size);
    text_.erase(0, size);
    answer_ = answerTo(workbench_, line) + "\n";
    boost::asio::async_write(socket_, boost::asio::buffer(answer_),
                             [self = shared_from_this()](Failure failure, std::size_t) {
                               if (!failure) self->readLine();
                             });
  }

  tcp::socket socket_;
  Workbench& workbench_;
  int& open_;
  std::string text_, answer_;
};

}  // namespace

class LineServer::Implementation {
 public:
  Implementation(Workbench& workbench, int port) : workbench_(workbench), acceptor_(context_) {
    try {
      const tcp::endpoint local(boost::asio::ip::address_v4::loopback(), static_cast<unsigned short>(port));
      acceptor_.open(local.protocol());
      acceptor_.set_option(tcp::acceptor::reuse_address(true));
      acceptor_.bind(local);
      acceptor_.listen();
    } catch (const boost::system::system_error& failure) {
      throw InputError::problem("--lines",
                                fmt::format("the server cannot listen on port {}: {}", port, failure.code().message()),
                                "give a free port");
    }
    accept();
    thread_ = std::thread([this] { context_.run(); });
  }

  ~Implementation() {
    context_.stop();
    thread_.join();
  }

  [[nodiscard]] int port() const { return acceptor_.local_endpoint().port(); }

 private:
  void accept() {
    acceptor_.async_accept([this](Failure failure, tcp::socket socket) {
      if (failure) return acceptLater();
      if (open_ < kMostConnections) std::make_shared<LineClient>(std::move(socket), workbench_, open_)->readLine();
      accept();
    });
  }

  /// Accepts again after a pause, because a failure such as a lack of file descriptors may persist.
  void acceptLater() {
    pause_.expires_after(std::chrono::milliseconds(100));
    pause_.async_wait([this](Failure failure) {
      if (!failure) accept();
    });
  }

  Workbench& workbench_;
  int open_ = 0;  ///< used only by the thread of the context; outlives all connections
  boost::asio::io_context context_;
  tcp::acceptor acceptor_;
  boost::asio::steady_timer pause_{context_};
  std::thread thread_;
};

LineServer::LineServer(Workbench& workbench, int port)
    : implementation_(std::make_unique<Implementation>(workbench, port)) {}

LineServer::~LineServer() = default;

int LineServer::port() const { return implementation_->port(); }

}  // namespace tubeplan::app
