#pragma once  // internal to import/

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <pugixml.hpp>

#include <cable_variation/scene_file/fault_list.h>

namespace cable_variation {

/// An XML text whose elements refer to each other by ids. Whatever is wrong goes to the fault list.
class XmlIds {
 public:
  /// A text that is no XML, and ids that are there twice, are faults. Throws FaultList::Full.
  XmlIds(const std::string& text, FaultList& faults);

  pugi::xml_node root() const { return document_.document_element(); }
  FaultList& faults() const { return *faults_; }
  /// The element of an id; an empty node: there is none.
  pugi::xml_node find(const std::string& id) const;
  int lineOf(const pugi::xml_node& node) const;  ///< from 1

 private:
  pugi::xml_document document_;
  std::vector<std::size_t> line_starts_;
  std::map<std::string, pugi::xml_node> elements_;
  FaultList* faults_;
};

/// The name of an element without its namespace's prefix.
std::string localName(const pugi::xml_node& node);

/// An element with readers of what is in it. After a fault they return nothing, NaN or an empty list.
class XmlElement {
 public:
  XmlElement(pugi::xml_node node, const XmlIds& ids) : node_(node), ids_(&ids) {}

  std::string id() const { return attribute("id"); }
  std::string attribute(const char* name) const { return node_.attribute(name).value(); }
  std::string kind() const { return localName(node_); }
  int line() const { return ids_->lineOf(node_); }
  /// "Segment 'Segment_12'"; of one without an id, that of the element around it with its name behind.
  std::string label() const;
  void fail(const std::string& message) const;

  std::vector<XmlElement> children(const std::string& name) const;
  std::optional<XmlElement> find(const std::string& name) const;  ///< the first
  std::optional<XmlElement> require(const std::string& name) const;
  /// All elements below, of these kinds.
  std::vector<XmlElement> below(const std::vector<std::string>& kinds) const;
  XmlElement parent() const { return {node_.parent(), *ids_}; }

  std::string text() const;  ///< without blanks around it; "" for the format's own "/NULL"
  std::string textOf(const std::string& name) const;  ///< of a child; empty: none
  double number() const;
  /// Numbers of all children of a name: `count` of them.
  std::vector<double> numbers(const std::string& name, std::size_t count) const;

  /// The element that this one's text refers to, of one of these kinds.
  std::optional<XmlElement> target(const std::vector<std::string>& kinds) const;
  /// Those that a list of ids refers to.
  std::vector<XmlElement> targets(const std::vector<std::string>& kinds) const;

 private:
  std::optional<XmlElement> elementOf(const std::string& id, const std::vector<std::string>& kinds) const;

  pugi::xml_node node_;
  const XmlIds* ids_;
};

}  // namespace cable_variation
