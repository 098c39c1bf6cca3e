#include <ros_interface/runs/envelope_files.h>

#include <filesystem>

#include <cable_variation/envelope/forbidden_region.h>
#include <cable_variation/report/envelope_urdf.h>
#include <cable_variation/report/stl.h>
#include <cable_variation/scene/resource_address.h>
#include <cable_variation/util/error.h>
#include <cable_variation/util/number_text.h>
#include <cable_variation/util/output_file.h>

namespace cable_variation_ros {

EnvelopeFiles envelopeFiles(const OutputDirectory& output, const std::string& name,
                            const cable_variation::Scene& scene, const cable_variation::Envelope& envelope,
                            const cable_variation::OuterSurface& surface, const std::string& report) {
  EnvelopeFiles files;
  files.mesh = output.pathOf(name, ".stl");
  files.urdf = output.pathOf(name, ".urdf");
  files.region = output.pathOf(name, ".obj");
  files.report = output.pathOf(name, ".html");
  files.report_contents = {{files.report, report}};
  const std::filesystem::path folder = std::filesystem::path(files.urdf).parent_path();
  cable_variation::EnvelopeUrdfOptions options;
  options.name = name;
  options.probability = envelope.probability;
  options.folder = cable_variation::fileUrl(folder.string());
  const cable_variation::EnvelopeUrdf urdf = envelopeUrdf(envelope.frames.front(), surface.mesh, options);
  std::string title = "tolerance envelope " + name;
  if (envelope.probability > 0.0)
    title += ", a share of " + cable_variation::numberText(envelope.probability);
  files.mesh_contents = {{files.mesh, cable_variation::binaryStl(surface.mesh, title)}};
  files.region_contents = {{files.region, regionText(forbiddenRegion(scene, envelope))}};
  for (const auto& mesh : urdf.meshes) files.urdf_contents.emplace_back(folder / mesh.name, mesh.contents);
  files.rounding = cable_variation::stlRounding(surface.mesh);
  files.urdf_contents.emplace_back(files.urdf, urdf.text);  // last: who finds it finds the meshes it names
  return files;
}

void write(EnvelopeFiles& files, const OutputDirectory& output) {
  const auto writeAll = [&](const EnvelopeFiles::Contents& all, std::string& path) {
    try {
      output.make();
      std::vector<cable_variation::StagedFile> staged;
      staged.reserve(all.size());
      for (const auto& [name, contents] : all) staged.emplace_back(name, contents);
      cable_variation::StagedFile::commit(staged);
    } catch (const cable_variation::FileError& problem) {
      path.clear();
      // a folder that is not there is told once
      if (files.error.find(problem.what()) != std::string::npos) return;
      files.error += (files.error.empty() ? "" : "; ") + std::string(problem.what());
    }
  };
  writeAll(files.mesh_contents, files.mesh);
  writeAll(files.region_contents, files.region);
  writeAll(files.urdf_contents, files.urdf);
  writeAll(files.report_contents, files.report);
}

}  // namespace cable_variation_ros
