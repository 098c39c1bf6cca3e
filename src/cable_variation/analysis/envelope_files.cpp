#include <cable_variation/analysis/envelope_files.h>

#include <filesystem>

#include <cable_variation/analysis/other_reports.h>
#include <cable_variation/envelope/forbidden_region.h>
#include <cable_variation/report/envelope_urdf.h>
#include <cable_variation/report/page.h>
#include <cable_variation/report/stl.h>
#include <cable_variation/scene/resource_address.h>
#include <cable_variation/util/error.h>
#include <cable_variation/util/number_text.h>
#include <cable_variation/util/output_file.h>

namespace cable_variation {

EnvelopeFiles envelopeFiles(const OutputDirectory& output, const std::string& name, const Scene& scene,
                            const Envelope& envelope, const OuterSurface& surface,
                            const std::string& report) {
  EnvelopeFiles files;
  files.mesh = output.pathOf(name, ".stl");
  files.urdf = output.pathOf(name, ".urdf");
  files.region = output.pathOf(name, ".obj");
  files.report = output.pathOf(name, ".html");
  files.report_contents = {{files.report, report}};
  const std::filesystem::path folder = std::filesystem::path(files.urdf).parent_path();
  EnvelopeUrdfOptions options;
  options.name = name;
  options.probability = envelope.probability;
  options.folder = fileUrl(folder.string());
  const EnvelopeUrdf urdf = envelopeUrdf(envelope.frames.front(), surface.mesh, options);
  std::string title = "tolerance envelope " + name;
  if (envelope.probability > 0.0) title += ", a share of " + numberText(envelope.probability);
  files.mesh_contents = {{files.mesh, binaryStl(surface.mesh, title)}};
  files.region_contents = {{files.region, regionText(forbiddenRegion(scene, envelope))}};
  for (const auto& mesh : urdf.meshes) files.urdf_contents.emplace_back(folder / mesh.name, mesh.contents);
  files.rounding = stlRounding(surface.mesh);
  files.urdf_contents.emplace_back(files.urdf, urdf.text);  // last: who finds it finds the meshes it names
  return files;
}

void write(EnvelopeFiles& files, const OutputDirectory& output) {
  const auto writeAll = [&](const EnvelopeFiles::Contents& all, std::string& path) {
    try {
      output.make();
      std::vector<StagedFile> staged;
      staged.reserve(all.size());
      for (const auto& [name, contents] : all) staged.emplace_back(name, contents);
      StagedFile::commit(staged);
    } catch (const FileError& problem) {
      path.clear();
      // a folder that is not there is told once
      if (files.error.find(problem.what()) != std::string::npos) return;
      files.error += (files.error.empty() ? "" : "; ") + std::string(problem.what());
    }
  };
  writeAll(files.mesh_contents, files.mesh);
  writeAll(files.region_contents, files.region);
  writeAll(files.urdf_contents, files.urdf);
  try {
    for (const auto& [path, contents] : files.report_contents) {
      const std::string name = std::filesystem::path(path).stem();
      keepOtherReport(output, name, reportKind(contents));
    }
  } catch (const FileError& problem) {
    files.report_contents.clear();
    files.report.clear();
    files.error += (files.error.empty() ? "" : "; ") + std::string(problem.what());
  }
  writeAll(files.report_contents, files.report);
}

}  // namespace cable_variation
