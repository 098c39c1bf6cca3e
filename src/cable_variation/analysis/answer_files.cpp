#include <cable_variation/analysis/answer_files.h>

#include <cable_variation/analysis/other_reports.h>
#include <cable_variation/report/page.h>
#include <cable_variation/util/error.h>
#include <cable_variation/util/output_file.h>

namespace cable_variation {

std::string writeBeside(const OutputDirectory& output, const std::string& name, const std::string& extension,
                        const std::string& contents, std::string& error) {
  const std::string path = output.pathOf(name, extension);
  try {
    output.make();
    if (extension == ".html") keepOtherReport(output, name, reportKind(contents));
    writeFile(path, contents);
    return path;
  } catch (const FileError& problem) {
    if (error.find(problem.what()) == std::string::npos)  // a folder that is not there is told once
      error += (error.empty() ? "" : "; ") + std::string(problem.what());
    return "";
  }
}

}  // namespace cable_variation
