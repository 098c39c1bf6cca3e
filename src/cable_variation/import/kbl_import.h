#pragma once

#include <string>
#include <vector>

#include <cable_variation/import/import_finding.h>
#include <cable_variation/import/import_mapping.h>
#include <cable_variation/import/kbl_document.h>
#include <cable_variation/import/scene_draft.h>

namespace cable_variation {

/// A harness as a scene, and what a person should know of how it came about.
struct ImportResult {
  SceneDraft draft;                   ///< its head lists the findings and the defaults
  ImportFindings findings;            ///< of the file, each with an id
  std::vector<std::string> defaults;  ///< what the mapping does not say, and what was taken instead
};

/// Makes a scene of a harness: segments become cables and joints, mounted parts components with a clip each.
/// Throws SceneError for what no scene can be made of: segments without a length, coordinates that are not in
/// mm, a harness that nothing holds.
ImportResult importKbl(const KblDocument& document, const ImportMapping& mapping);

}  // namespace cable_variation
