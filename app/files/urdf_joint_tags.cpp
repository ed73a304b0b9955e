#include "app/files/urdf_joint_tags.hpp"

#include <tinyxml2.h>

#include <algorithm>
#include <vector>

namespace tubeplan::app {

namespace {

/// Names of a robot's own elements, in the order of the file, as they are read: entities resolved, blanks for breaks.
std::vector<std::string> namesInRobot(const tinyxml2::XMLDocument& document, const char* element) {
  std::vector<std::string> names;
  const auto* robot = document.FirstChildElement("robot");
  for (const auto* child = robot ? robot->FirstChildElement(element) : nullptr; child;
       child = child->NextSiblingElement(element)) {
    const char* name = child->Attribute("name");
    std::ranges::replace_if(
        names.emplace_back(name ? name : ""), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  }
  return names;
}

/// Walks the tags and notes what belongs to the robot's own joints.
class JointTagWalk {
 public:
  JointTagWalk(std::string_view text, std::vector<std::string> names) : text_(text), names_(std::move(names)) {}

  void noteIn(UrdfTags& tags) {
    for (auto tag = nextXmlTag(text_, 0); tag && tags.robot_end.empty();) {
      const auto next = static_cast<std::size_t>(tag->whole.data() + tag->whole.size() - text_.data());
      if (tag->opens) note(*tag, tags);
      if (tag->opens && !tag->closes) within_.push_back(tag->name);
      if (!tag->opens && within_ == std::vector<std::string_view>{"robot"}) tags.robot_end = tag->whole;
      if (!tag->opens && !within_.empty()) within_.pop_back();
      tag = nextXmlTag(text_, next);
    }
  }

 private:
  void note(const XmlTag& tag, UrdfTags& tags) {
    if (within_.empty() || within_[0] != "robot") return;
    if (within_.size() == 1 && tag.name == "joint" && count_ < names_.size())
      now_ = &(tags.joints[names_[count_++]] = {tag, {}, {}});
    if (!now_ || within_.size() != 2 || within_[1] != "joint") return;
    if (tag.name == "origin" && !now_->origin) now_->origin = tag;
    if (tag.name == "limit" && !now_->limit) now_->limit = tag;
  }

  std::string_view text_;
  std::vector<std::string> names_;
  std::size_t count_ = 0;
  std::vector<std::string_view> within_;
  UrdfJointTags* now_ = nullptr;
};

}  // namespace

UrdfTags urdfTagsOf(std::string_view text) {
  tinyxml2::XMLDocument document;
  UrdfTags tags;
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) return tags;
  for (auto& link : namesInRobot(document, "link")) tags.links.insert(std::move(link));
  JointTagWalk(text, namesInRobot(document, "joint")).noteIn(tags);
  return tags;
}

}  // namespace tubeplan::app
