#include <cable_variation/scene_file/urdf_structure.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include <tinyxml2.h>

#include <cable_variation/util/name_list.h>

namespace cable_variation {
namespace {

using tinyxml2::XMLAttribute;
using tinyxml2::XMLElement;

std::string attributeOf(const XMLElement& element, const char* name) {
  const char* const value = element.Attribute(name);
  return value ? value : "";
}

std::string lineText(const XMLElement& element) {
  return " (line " + std::to_string(element.GetLineNum()) + ")";
}

/// Whether links and joints make a tree.
class TreeCheck {
 public:
  TreeCheck(const XMLElement& robot, std::vector<std::string>& faults) : robot_(robot), faults_(faults) {}

  void run() {
    const std::size_t before = faults_.size();
    for (auto* link = robot_.FirstChildElement("link"); link; link = link->NextSiblingElement("link")) {
      addLink(*link);
    }
    if (faults_.size() == before && names_.empty()) faults_.emplace_back("it has no links");
    for (auto* joint = robot_.FirstChildElement("joint"); joint; joint = joint->NextSiblingElement("joint")) {
      addJoint(*joint);
    }
    if (faults_.size() == before) checkCycles();
    if (faults_.size() == before) checkRoot();
  }

 private:
  struct Parent {
    std::string link;
    std::string joint;
  };

  void addLink(const XMLElement& link) {
    const std::string name = attributeOf(link, "name");
    if (name.empty()) {
      faults_.push_back("a link has no name" + lineText(link));
    } else if (!known_.insert(name).second) {
      faults_.push_back("there are two links '" + name + "'" + lineText(link));
    } else {
      names_.push_back(name);
    }
  }

  // The link that a joint's parent or child names; empty after a fault.
  std::string linkOf(const XMLElement& joint, const std::string& who, const char* end) {
    const XMLElement* const element = joint.FirstChildElement(end);
    const std::string link = element ? attributeOf(*element, "link") : "";
    if (link.empty()) {
      faults_.push_back(who + " names no " + end + " link" + lineText(joint));
    } else if (known_.count(link) == 0) {
      faults_.push_back(who + ": there is no link '" + link + "'" + didYouMean(link, names_) +
                        lineText(joint));
      return "";
    }
    return link;
  }

  void addJoint(const XMLElement& joint) {
    const std::string name = attributeOf(joint, "name");
    const std::string who = "joint '" + name + "'";
    if (name.empty()) faults_.push_back("a joint has no name" + lineText(joint));
    if (!joints_.insert(name).second)
      faults_.push_back("there are two joints '" + name + "'" + lineText(joint));
    const std::string parent = linkOf(joint, who, "parent");
    const std::string child = linkOf(joint, who, "child");
    if (parent.empty() || child.empty()) return;
    const auto [other, first] = parents_.emplace(child, Parent{parent, name});
    if (!first) {
      faults_.push_back("link '" + child + "' has two parents, '" + other->second.link + "' by joint '" +
                        other->second.joint + "' and '" + parent + "' by joint '" + name + "'" +
                        lineText(joint));
    }
  }

  // Follows every link up to one that is known to end.
  void checkCycles() {
    std::set<std::string> ends;
    for (const std::string& name : names_) {
      std::vector<std::string> chain;
      std::set<std::string> passed;
      for (std::string at = name; ends.count(at) == 0;) {
        if (!passed.insert(at).second) {
          tellCycle(chain, at);
          break;
        }
        chain.push_back(at);
        const auto parent = parents_.find(at);
        if (parent == parents_.end()) break;
        at = parent->second.link;
      }
      ends.insert(passed.begin(), passed.end());
    }
  }

  void tellCycle(const std::vector<std::string>& chain, const std::string& closing) {
    constexpr std::size_t kMost = 10;  // links to list
    std::string text;
    const auto start = std::find(chain.begin(), chain.end(), closing);
    const auto length = static_cast<std::size_t>(chain.end() - start);
    for (std::size_t i = 0; i < std::min(length, kMost); ++i)
      text += start[static_cast<std::ptrdiff_t>(i)] + " -> ";
    faults_.push_back("links are their own parents: " + text + (length > kMost ? "... -> " : "") + closing);
  }

  void checkRoot() {
    std::vector<std::string> roots;
    for (const std::string& name : names_) {
      if (parents_.count(name) == 0) roots.push_back(name);
    }
    constexpr std::size_t kMost = 5;
    if (roots.size() == 1) return;
    const std::size_t count = roots.size();
    roots.resize(std::min(count, kMost));
    faults_.push_back(std::to_string(count) + " links have no parent: " + joined(roots) +
                      (count > kMost ? ", ..." : "") + "; expected one");
  }

  const XMLElement& robot_;
  std::vector<std::string>& faults_;
  std::vector<std::string> names_;
  std::set<std::string> known_;
  std::set<std::string> joints_;
  std::map<std::string, Parent> parents_;  // by child
};

/// Writes a document with every % of an attribute replaced; texts between elements, which URDF has none of,
/// are left out.
class Replacing : public tinyxml2::XMLPrinter {
 public:
  explicit Replacing(const std::string& mark) : XMLPrinter(nullptr, true), mark_(mark) {}

  bool VisitEnter(const XMLElement& element, const XMLAttribute* first) override {
    OpenElement(element.Name(), true);
    for (const XMLAttribute* attribute = first; attribute; attribute = attribute->Next()) {
      PushAttribute(attribute->Name(), replaced(attribute->Value()).c_str());
    }
    return true;
  }
  using XMLPrinter::VisitEnter;
  bool Visit(const tinyxml2::XMLText&) override { return true; }
  bool Visit(const tinyxml2::XMLComment&) override { return true; }
  bool Visit(const tinyxml2::XMLDeclaration&) override { return true; }
  bool Visit(const tinyxml2::XMLUnknown&) override { return true; }

 private:
  std::string replaced(std::string text) const {
    for (std::size_t at = text.find('%'); at != std::string::npos; at = text.find('%', at)) {
      text.replace(at, 1, mark_);
      at += mark_.size();
    }
    return text;
  }

  const std::string& mark_;
};

}  // namespace

std::string checkedUrdf(const std::string& text, const std::string& mark, std::vector<std::string>& faults) {
  tinyxml2::XMLDocument document;
  if (document.Parse(text.c_str(), text.size()) != tinyxml2::XML_SUCCESS) {
    const bool deep = document.ErrorID() == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED;
    faults.push_back((deep ? "its elements are nested too deep" : "it is no XML") + std::string(" (line ") +
                     std::to_string(document.ErrorLineNum()) + ")");
    return "";
  }
  const XMLElement* const robot = document.FirstChildElement("robot");
  if (!robot) {
    faults.emplace_back("it is no URDF; expected an element <robot>");
    return "";
  }
  std::vector<std::string> found;
  TreeCheck(*robot, found).run();
  if (!found.empty()) {
    constexpr std::size_t kMost = 100;  // that anybody reads
    faults.insert(faults.end(), found.begin(),
                  found.begin() + static_cast<std::ptrdiff_t>(std::min(found.size(), kMost)));
    if (found.size() > kMost) {
      faults.push_back("and " + std::to_string(found.size() - kMost) +
                       " more faults of its links and joints");
    }
    return "";
  }
  Replacing printer(mark);
  document.Accept(&printer);
  return printer.CStr();
}

std::string unusedCharacter(const std::string& text) {
  for (unsigned code = 0; code < 64; ++code) {  // of the private use area, U+E000 to U+E03F
    std::string mark{'\xee', '\x80', static_cast<char>(0x80U + code)};
    if (text.find(mark) == std::string::npos) return mark;
  }
  throw std::invalid_argument("it has all characters of U+E000 to U+E03F; expected a URDF");
}

}  // namespace cable_variation
