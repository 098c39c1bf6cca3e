#include <cable_variation/analysis/other_reports.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include <cable_variation/report/page.h>
#include <cable_variation/util/error.h>
#include <cable_variation/util/regular_file.h>

namespace cable_variation {

namespace {

namespace fs = std::filesystem;

/// Of the page in a file; empty: it is no report, or cannot be read.
std::string kindOfFile(const std::string& path) {
  std::string head(1024, '\0');
  try {
    RegularFile file(path, kAnySize, RegularFile::Links::refuse);
    head.resize(file.read(head.data(), head.size()));
  } catch (const std::invalid_argument&) {
    return "";
  }
  return reportKind(head);
}

/// As part of a file's name: "stability_analysis".
std::string fileWord(std::string kind) {
  std::transform(kind.begin(), kind.end(), kind.begin(), [](char c) {
    if (c >= 'A' && c <= 'Z') return static_cast<char>(c - 'A' + 'a');
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ? c : '_';
  });
  return kind.substr(0, 40);
}

}  // namespace

void keepOtherReport(const OutputDirectory& output, const std::string& name, const std::string& kind) {
  const std::string other = kindOfFile(output.pathOf(name, ".html"));
  if (other.empty() || other == kind) return;
  for (const char* extension : {".csv", ".html"}) {  // the page last: it tells what the table is of
    const std::string from = output.pathOf(name, extension);
    std::error_code error;
    if (!fs::is_regular_file(fs::symlink_status(from, error))) continue;
    const std::string to = fs::path(from).replace_filename(name + "_" + fileWord(other) + extension);
    fs::rename(from, to, error);
    if (!error) continue;
    throw FileError("file '" + from + "', which is of another analysis, cannot be kept as '" + to +
                    "': " + error.message());
  }
}

}  // namespace cable_variation
