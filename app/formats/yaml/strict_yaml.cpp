#include "app/formats/yaml/strict_yaml.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <sstream>

#include "app/formats/yaml/yaml_scan.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/text_file.hpp"
#include "app/storage/utf8.hpp"

namespace tubeplan::app {

namespace {

// Builder of the node tree from events of yaml-cpp's parser, because YAML::Node silently accepts duplicate keys.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(const std::string& text, const std::string& file)
      : text_(text), file_(std::make_shared<std::string>(file)) {}

  YamlNode takeRoot() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    refuseAnchor(mark, anchor);
    refuseTag(mark, "");
    YamlNode node = makeNode(mark, YamlNode::Kind::kNull);
    if (expectsKey()) node.failWithProblem("there is no key before the colon", "write a key before the colon");
    finish(std::move(node));
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    makeNode(mark, YamlNode::Kind::kNull).failWithProblem("aliases (*) are not supported", "write the value itself");
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    refuseAnchor(mark, anchor);
    refuseTag(mark, tag);
    if (tag == "!") refuseOpenQuote(mark);
    if (!isPlainText(value))
      makeNode(mark, YamlNode::Kind::kNull).fail("a control character in " + inQuotes(value), "plain text", "");
    if (expectsKey()) {
      startEntry(mark, value);
      return;
    }
    YamlNode node = makeNode(mark, YamlNode::Kind::kScalar);
    node.scalar = value;
    node.is_quoted = tag == "!";
    finish(std::move(node));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) override {
    open(mark, tag, anchor, style, YamlNode::Kind::kList);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value style) override {
    open(mark, tag, anchor, style, YamlNode::Kind::kMap);
  }
  void OnMapEnd() override { close(); }

 private:
  [[nodiscard]] bool expectsKey() const {
    return !open_.empty() && open_.back().kind == YamlNode::Kind::kMap &&
           open_.back().keys.size() == open_.back().items.size();
  }

  // Returns a node for the next value, with the value's position, path and key but without content.
  YamlNode makeNode(const YAML::Mark& mark, YamlNode::Kind kind) const {
    YamlNode node;
    node.file = file_;
    node.kind = kind;
    node.line = mark.line + 1;
    node.column = mark.column + 1;
    node.begin = static_cast<std::size_t>(mark.pos);
    if (open_.empty()) return node;
    const YamlNode& parent = open_.back();
    node.path = parent.path;
    if (parent.kind == YamlNode::Kind::kList) node.path += fmt::format("[{}]", parent.items.size());
    if (parent.kind != YamlNode::Kind::kMap || expectsKey()) return node;
    node.path += (node.path.empty() ? "" : ".") + parent.keys.back();
    node.key_begin = key_begin_;
    return node;
  }

  void startEntry(const YAML::Mark& mark, const std::string& key) {
    YamlNode& map = open_.back();
    const auto first = std::find(map.keys.begin(), map.keys.end(), key);
    if (first != map.keys.end())
      makeNode(mark, YamlNode::Kind::kNull)
          .failWithProblem(fmt::format("the key {} occurs a second time, after line {}", inQuotes(key),
                                       map.items[static_cast<std::size_t>(first - map.keys.begin())].line),
                           "remove one of them");
    map.keys.push_back(key);
    key_begin_ = static_cast<std::size_t>(mark.pos);
  }

  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, YAML::EmitterStyle::value style,
            YamlNode::Kind kind) {
    refuseAnchor(mark, anchor);
    refuseTag(mark, tag);
    YamlNode node = makeNode(mark, kind);
    if (expectsKey()) node.failWithProblem("a list or map cannot be a key", "write a word as the key");
    node.is_flow = style == YAML::EmitterStyle::Flow;
    open_.push_back(std::move(node));
  }

  void close() {
    YamlNode node = std::move(open_.back());
    open_.pop_back();
    finish(std::move(node));
  }

  void finish(YamlNode node) {
    if (open_.empty())
      root_ = std::move(node);
    else
      open_.back().items.push_back(std::move(node));
  }

  void refuseAnchor(const YAML::Mark& mark, YAML::anchor_t anchor) const {
    if (anchor != 0)
      makeNode(mark, YamlNode::Kind::kNull).failWithProblem("anchors (&) are not supported", "write the value alone");
  }

  // Throws InputError for a quote that is never closed; yaml-cpp would close the quote at the end of the file.
  void refuseOpenQuote(const YAML::Mark& mark) const {
    const auto at = static_cast<std::size_t>(mark.pos);
    const bool is_quote = text_[at] == '"' || text_[at] == '\'';  // otherwise a block scalar (| or >)
    if (is_quote && pastQuoted(text_, at) == std::string::npos)
      makeNode(mark, YamlNode::Kind::kNull).failWithProblem("the quote is not closed", "write quotes in pairs");
  }

  // Throws InputError for a tag in the text. yaml-cpp reports the tag "?" for plain values, "!" for quoted values, and
  // "" for some collections; a "!" that the user wrote is the first character of the value.
  void refuseTag(const YAML::Mark& mark, const std::string& tag) const {
    const auto at = static_cast<std::size_t>(mark.pos);
    const bool is_written = at < text_.size() && text_[at] == '!';
    if (is_written || (!tag.empty() && tag != "?" && tag != "!"))
      makeNode(mark, YamlNode::Kind::kNull)
          .failWithProblem("tags such as " + inQuotes(tag) + " are not supported", "write the value alone");
  }

  const std::string& text_;
  std::shared_ptr<const std::string> file_;
  YamlNode root_;
  std::vector<YamlNode> open_;
  std::size_t key_begin_ = 0;
};

// Throws InputError for a tab that no `#` precedes on its line; a tab in a comment is allowed.
void refuseTabs(const std::string& text, const std::string& file) {
  int line = 1, column = 1;
  bool in_comment = false;
  for (const char c : text) {
    if (c == '#') in_comment = true;
    if (c == '\t' && !in_comment)
      throw InputError(fmt::format("{}:{}:{}", file, line, column), "a tab", "spaces", "replace the tab with spaces");
    ++column;
    if (c != '\n') continue;
    in_comment = false;
    column = 1;
    ++line;
  }
}

}  // namespace

YamlNode parseYaml(const std::string& text, const std::string& file) {
  refuseTabs(text, file);
  TreeBuilder builder(text, file);
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder))
      throw InputError::problem(file, "the file contains only comments", "write keys and values");
    TreeBuilder second(text, file);
    if (parser.HandleNextDocument(second))
      throw InputError::problem(file, "the file has a second document (---)",
                                "split the file into files of one document each");
  } catch (const YAML::Exception& error) {
    throw InputError::problem(fmt::format("{}:{}:{}", file, error.mark.line + 1, error.mark.column + 1),
                              "the text is not YAML (" + error.msg + ")",
                              "check brackets, colons and indentation up to this place");
  }
  YamlNode root = builder.takeRoot();
  if (root.kind != YamlNode::Kind::kMap) root.fail("a map of keys and values");
  return root;
}

YamlFile readYamlFile(const std::string& path) {
  YamlFile file{path, readTextFile(path), {}};
  file.root = parseYaml(file.text, path);
  return file;
}

const YamlNode* findNode(const YamlNode& root, std::string_view path) {
  if (root.path == path) return &root;
  for (const YamlNode& item : root.items) {
    const bool leads_there = path == item.path || (path.starts_with(item.path) &&
                                                   (path[item.path.size()] == '.' || path[item.path.size()] == '['));
    if (!leads_there) continue;
    if (const YamlNode* found = findNode(item, path)) return found;
  }
  return nullptr;
}

}  // namespace tubeplan::app
