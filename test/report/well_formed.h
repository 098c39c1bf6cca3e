#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace cable_variation {

/// What a strict XML parser (Python's expat) says of `text`; empty: it is well-formed.
inline std::string faultOfXml(const std::string& text) {
  std::string name = (std::filesystem::temp_directory_path() / "xml_XXXXXX").string();
  const int descriptor = mkstemp(name.data());
  if (descriptor < 0) return "no temporary file";
  std::FILE* file = fdopen(descriptor, "wb");
  std::fwrite(text.data(), 1, text.size(), file);
  std::fclose(file);
  const std::string command = std::string(PYTHON3) +
                              " -c 'import sys, xml.parsers.expat as e; "
                              "e.ParserCreate().ParseFile(open(sys.argv[1], \"rb\"))' " +
                              name + " 2>&1";
  std::string said;
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return "no parser";
  std::array<char, 256> buffer;
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) said += buffer.data();
  if (pclose(pipe) != 0 && said.empty()) said = "the parser failed";
  std::filesystem::remove(name);
  return said;
}

}  // namespace cable_variation
