#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include <cable_variation/import/kbl_document.h>
#include <cable_variation/scene_file/scene_reader.h>

#include <test_packages.h>

namespace cable_variation {

inline std::string contentsOf(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A small harness: a trunk of two segments from XA.1 to XB.1, a ground lead and a splice.
inline const std::string& smallKbl() {
  static const std::string text = contentsOf(findTestPackage("test_data") + "/kbl/small.kbl");
  return text;
}

/// The text with one place of it replaced, which must be there.
inline std::string with(const std::string& text, const std::string& place, const std::string& by) {
  const std::size_t at = text.find(place);
  if (at == std::string::npos) throw std::logic_error("there is no '" + place + "' in the text");
  return text.substr(0, at) + by + text.substr(at + place.size());
}

/// What is said of a file that cannot be read; "" of one that can.
inline std::string faultOf(const std::string& text) {
  try {
    readKblText(text, "file.kbl");
  } catch (const SceneError& error) {
    return error.what();
  }
  return {};
}

inline Scene sceneOf(const std::string& text) {
  return readSceneText(text, "imported.yaml", [](const std::string&) { return std::string(); });
}

}  // namespace cable_variation
