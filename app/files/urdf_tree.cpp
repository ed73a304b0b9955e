#include "app/files/urdf_tree.hpp"

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <tinyxml2.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "app/files/input_error.hpp"
#include "app/files/suggestion.hpp"
#include "app/files/urdf_checks.hpp"
#include "app/files/utf8.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using tinyxml2::XMLDocument, tinyxml2::XMLElement;

/// Takes what the parser has to say, in place of the terminal. urdfdom gives pieces of the file to printf as its
/// format: where they may hold a percent sign, as it stands or as a character by its number, nothing may be said at
/// all.
class ParserMessages : public console_bridge::OutputHandler {
 public:
  explicit ParserMessages(const std::string& text) : level_(console_bridge::getLogLevel()) {
    console_bridge::useOutputHandler(this);
    const bool may_format = text.find('%') != std::string::npos || text.find("&#") != std::string::npos;
    console_bridge::setLogLevel(may_format ? console_bridge::CONSOLE_BRIDGE_LOG_NONE
                                           : console_bridge::CONSOLE_BRIDGE_LOG_ERROR);
  }
  ~ParserMessages() override {
    console_bridge::setLogLevel(level_);
    console_bridge::restorePreviousOutputHandler();
  }
  ParserMessages(const ParserMessages&) = delete;
  ParserMessages& operator=(const ParserMessages&) = delete;
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first.empty()) first = text;
  }
  std::string first;

 private:
  console_bridge::LogLevel level_;
};

/// The child elements of this name.
std::vector<XMLElement*> childrenOf(XMLElement& element, const char* name) {
  std::vector<XMLElement*> children;
  for (auto* child = element.FirstChildElement(name); child; child = child->NextSiblingElement(name))
    children.push_back(child);
  return children;
}

/// " offset 0.2" of an element with a text.
std::string wordsIn(const XMLElement* element) {
  return element && element->GetText() ? fmt::format(" {} {}", element->Name(), nameInLine(element->GetText())) : "";
}

void forget(XMLElement& element, std::initializer_list<const char*> names) {
  for (const char* name : names)
    for (XMLElement* child : childrenOf(element, name)) element.DeleteChild(child);
}

std::string linkNamedBy(XMLElement& joint, const char* element) {
  return attributeOf(joint.FirstChildElement(element), "link");
}

/// XML lets the numbers of an attribute stand on several lines, urdfdom does not; and lets characters be written by
/// their numbers that no name has.
void settleAttributes(XMLElement& element, const std::string& file) {
  for (auto* attribute = element.FirstAttribute(); attribute; attribute = attribute->Next()) {
    std::string value = attribute->Value();
    if (!isPlainText(value))
      throw InputError(fmt::format("{}:{}", file, element.GetLineNum()), "a control character in " + inQuotes(value),
                       "plain text");
    const auto isBreak = [](char c) { return c == '\n' || c == '\r' || c == '\t'; };
    if (std::none_of(value.begin(), value.end(), isBreak)) continue;
    std::replace_if(value.begin(), value.end(), isBreak, ' ');
    element.SetAttribute(attribute->Name(), value.c_str());
  }
  for (auto* child = element.FirstChildElement(); child; child = child->NextSiblingElement())
    settleAttributes(*child, file);
}

/// Of one link, as it is written.
struct LinkContent {
  std::size_t solids = 0;
  bool has_inertial = false;
};

/// What urdfdom is given, and what each link has there.
class Preparation {
 public:
  Preparation(const std::string& text, const std::string& file) : file_(file) {
    if (document_.Parse(text.c_str(), text.size()) != tinyxml2::XML_SUCCESS)
      throw InputError(
          fmt::format("{}:{}", file_, std::max(1, document_.ErrorLineNum())),
          text.find("<robot") == std::string::npos ? "no XML" : "XML that breaks off, or whose tags do not match",
          "a URDF robot");
    robot_ = document_.FirstChildElement("robot");
    const XMLElement* root = document_.FirstChildElement();
    if (!robot_)
      throw InputError(file_, "no robot" + (root ? ", but " + inQuotes(root->Name()) : ""), "a URDF robot",
                       "a file with another root, as SDF, is to be converted first");
    refuseXacro(*robot_);
    settleAttributes(*robot_, file_);
    for (XMLElement* transmission : childrenOf(*robot_, "transmission")) noteTransmission(*transmission);
    forget(*robot_, {"material", "gazebo", "transmission"});
    checkNames(*robot_, file_);
    checkTree();
    for (XMLElement* link : childrenOf(*robot_, "link")) prepareLink(*link);
    for (XMLElement* joint : childrenOf(*robot_, "joint")) prepareJoint(*joint);
  }

  [[nodiscard]] std::string text() const {
    tinyxml2::XMLPrinter printer(nullptr, true);
    document_.Print(&printer);
    return printer.CStr();
  }
  [[nodiscard]] const std::map<std::string, LinkContent>& links() const { return links_; }
  [[nodiscard]] std::vector<std::string>& leftOut() { return left_out_; }
  [[nodiscard]] WrittenTurns& turns() { return turns_; }
  [[nodiscard]] std::map<std::string, ControllerWords>& controllers() { return controllers_; }

 private:
  [[noreturn]] void refuseAsXacro(const XMLElement& element, const char* found) const {
    throw InputError(fmt::format("{}:{}", file_, element.GetLineNum()), inQuotes(found), "plain URDF",
                     "convert xacro files first: xacro FILE > robot.urdf");
  }

  void refuseXacro(const XMLElement& element) const {
    if (std::string_view(element.Name()).starts_with("xacro:")) refuseAsXacro(element, element.Name());
    for (const auto* attribute = element.FirstAttribute(); attribute; attribute = attribute->Next())
      if (std::string_view(attribute->Value()).find("${") != std::string_view::npos)
        refuseAsXacro(element, attribute->Value());
    for (auto* child = element.FirstChildElement(); child; child = child->NextSiblingElement()) refuseXacro(*child);
  }

  /// One root, and every other link behind one joint.
  void checkTree() const {
    std::vector<std::string> links;
    for (XMLElement* link : childrenOf(*robot_, "link")) links.push_back(attributeOf(link, "name"));
    const std::set<std::string> known(links.begin(), links.end());
    std::map<std::string, std::string> carrier;
    for (XMLElement* joint : childrenOf(*robot_, "joint")) {
      const std::string name = attributeOf(joint, "name"), child = linkNamedBy(*joint, "child");
      for (const auto& link : {linkNamedBy(*joint, "parent"), child})
        if (!known.contains(link))
          throw InputError(placeOf(*joint, file_), "no link " + inQuotes(link),
                           "links of the robot as parent and child", suggestion(link, links));
      if (const auto [first, is_new] = carrier.emplace(child, name); !is_new)
        throw InputError(placeOf(*joint, file_),
                         fmt::format("the link {} behind the joint {} too", inQuotes(child), inQuotes(first->second)),
                         "a tree: each link behind one joint", "closed chains cannot be taken");
    }
    std::vector<std::string> roots;
    for (const auto& link : links)
      if (!carrier.contains(link)) roots.push_back(link);
    if (roots.empty())
      throw InputError(file_, "links that form a closed loop, each behind a joint", "a tree of links with one root");
    if (roots.size() > 1)
      throw InputError(file_, fmt::format("{} links behind no joint: {}", roots.size(), alternatives(roots)),
                       "one root, with all other links behind it");
  }

  void prepareLink(XMLElement& link) {
    forget(link, {"visual", "sensor"});
    const std::string name = attributeOf(&link, "name");
    for (XMLElement* inertial : childrenOf(link, "inertial")) {
      checkLinkNumbers(*inertial, link, file_);
      prepareInertial(*inertial, placeOf(link, file_));
    }
    for (XMLElement* collision : childrenOf(link, "collision")) {
      checkLinkNumbers(*collision, link, file_);
      XMLElement* geometry = collision->FirstChildElement("geometry");
      const XMLElement* solid = geometry ? geometry->FirstChildElement() : nullptr;
      if (solid && std::set<std::string_view>{"box", "cylinder", "sphere", "mesh"}.contains(solid->Name())) continue;
      left_out_.push_back(solid ? fmt::format("the {} of link {}: write it into the cell's link_shapes",
                                              nameInLine(solid->Name()), name)
                                : fmt::format("a collision of link {}: it has no solid", name));
      link.DeleteChild(collision);
    }
    links_[name] = {childrenOf(link, "collision").size(), link.FirstChildElement("inertial") != nullptr};
  }

  /// Masses count, and where they are; what turns them does not, and need not be there.
  void prepareInertial(XMLElement& inertial, const std::string& where) const {
    const std::string mass = attributeOf(inertial.FirstChildElement("mass"), "value");
    const auto number = numbersIn(mass);
    if (!number || number->size() != 1 || number->front() < 0)
      throw InputError(where, mass.empty() ? "an inertial without mass" : "the mass " + inQuotes(mass),
                       "<mass value=\"...\"/>, 0 kg or more");
    XMLElement* inertia = inertial.FirstChildElement("inertia");
    if (!inertia) inertia = inertial.InsertNewChildElement("inertia");
    for (const char* moment : {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"})
      if (!tubesheets::parseNumber(attributeOf(inertia, moment))) inertia->SetAttribute(moment, "0");
  }

  void noteTransmission(XMLElement& transmission) {
    std::string words = wordsIn(transmission.FirstChildElement("mechanicalReduction"));
    for (const char* part : {"joint", "actuator"})
      for (XMLElement* element : childrenOf(transmission, part))
        for (const char* number : {"mechanicalReduction", "offset"})
          words += wordsIn(element->FirstChildElement(number));
    for (XMLElement* joint : childrenOf(transmission, "joint"))
      controllers_[attributeOf(joint, "name")].transmission += words;
  }

  void noteController(XMLElement& joint) {
    const auto* soft = joint.FirstChildElement("safety_controller");
    const auto* marks = joint.FirstChildElement("calibration");
    if (!soft && !marks) return;
    auto& words = controllers_[attributeOf(&joint, "name")];
    const std::string lower = attributeOf(soft, "soft_lower_limit"), upper = attributeOf(soft, "soft_upper_limit");
    if (!lower.empty() || !upper.empty())
      words.soft_limits = fmt::format(" {} to {}", nameInLine(lower), nameInLine(upper));
    for (const char* edge : {"rising", "falling", "reference_position"})
      if (const auto at = attributeOf(marks, edge); !at.empty())
        words.reference_marks += fmt::format(" {} {}", edge, nameInLine(at));
  }

  void prepareJoint(XMLElement& joint) {
    noteController(joint);
    forget(joint, {"safety_controller", "calibration", "dynamics"});
    checkJointNumbers(joint, file_);
    const std::string name = attributeOf(&joint, "name"), type = attributeOf(&joint, "type");
    if (const auto rpy = numbersIn(attributeOf(joint.FirstChildElement("origin"), "rpy")))
      turns_[name] = {(*rpy)[0], (*rpy)[1], (*rpy)[2]};
    XMLElement* limit = joint.FirstChildElement("limit");
    if (!limit && (type == "revolute" || type == "prismatic"))
      throw InputError(placeOf(joint, file_), "no <limit>", "the limits of a " + type + " joint",
                       type == "revolute" ? "a joint that turns without end is continuous" : "");
    if (!limit) return;
    limit->SetAttribute("effort", "0");
    if (!limit->Attribute("velocity")) limit->SetAttribute("velocity", "0");
  }

  const std::string& file_;
  XMLDocument document_;
  XMLElement* robot_ = nullptr;
  std::map<std::string, LinkContent> links_;
  std::vector<std::string> left_out_;
  WrittenTurns turns_;
  std::map<std::string, ControllerWords> controllers_;
};

/// The parser leaves a link at the first thing that it cannot read.
void refuseLost(const urdf::ModelInterface& model, const Preparation& prepared, const std::string& file,
                const std::string& message) {
  const auto refuse = [&](const std::string& where) {
    throw InputError(where, message.empty() ? "something that cannot be read" : inQuotes(message), "a URDF robot");
  };
  for (const auto& [name, link] : model.links_) {
    const auto written = prepared.links().find(name);
    if (written == prepared.links().end() || written->second.solids != link->collision_array.size() ||
        written->second.has_inertial != (link->inertial != nullptr))
      refuse(fmt::format("{} (link {})", file, nameInLine(name)));
  }
  if (!message.empty()) refuse(file);
}

}  // namespace

UrdfTree readUrdfTree(const std::string& text, const std::string& file) {
  Preparation prepared(text, file);
  const std::string readable = prepared.text();
  ParserMessages messages(readable);
  UrdfTree tree{urdf::parseURDF(readable), std::move(prepared.turns()), std::move(prepared.leftOut()),
                std::move(prepared.controllers())};
  if (!tree.model || !tree.model->getRoot())
    throw InputError(file, messages.first.empty() ? "no robot" : inQuotes(messages.first), "a URDF robot");
  refuseLost(*tree.model, prepared, file, messages.first);
  return tree;
}

}  // namespace tubeplan::app
