#include <memory>
#include <stdexcept>
#include <utility>

#include <cable_variation/import/kbl_import.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/util/error.h>
#include <cable_variation/util/output_file.h>
#include <command/scene_json.h>
#include <command/scene_options.h>
#include <command/text_table.h>
#include <command/verb.h>

namespace cable_variation_command {

using cable_variation::ImportedRestShape;
using cable_variation::ImportFinding;
using cable_variation::ImportMapping;
using cable_variation::ImportResult;
using cable_variation::KblDocument;
using cable_variation::Scene;
using cable_variation::SceneError;

namespace {

Json findingsJson(const std::string& file, const cable_variation::ImportFindings& findings) {
  Json list = Json::array();
  for (const ImportFinding& finding : findings) {
    Json json = Json::object();
    json.set("kind", toString(finding.kind))
        .set("id", finding.id)
        .set("file", file)
        .set("line", finding.line);
    list.add(json.set("message", finding.message));
  }
  return list;
}

class ImportVerb : public Verb {
 public:
  void declare(Options& options) override {
    options.word("FILE", file_, "a KBL file (VDA 4964, 2.3 to 2.5); before the options");
    options.text("mapping", "FILE", mapping_,
                 "what that file does not say (doc/import.md); default: defaults for all of it");
    options.text("output", "FILE", output_,
                 "the scene file to write, -o for short; default: to the standard output");
    options.shortName('o', "output");
    options.text("rest_shape", "NAME", rest_shape_,
                 "straight or curve: what cables are made as; default: as the mapping says");
  }

  Answer run(cable_variation::RunControl& control) override {
    if (!output_.empty()) keepInputs({file_, mapping_}, output_);
    ImportMapping mapping;
    if (!mapping_.empty()) mapping = cable_variation::readImportMapping(mapping_);
    chooseRestShape(mapping);
    control.report({"reading"});
    const KblDocument document = cable_variation::readKbl(file_);
    control.report({"importing"});
    const ImportResult result = importKbl(document, mapping);
    const std::string scene = sceneText(result.draft);
    requireReadable(scene);

    Answer answer;
    for (const ImportFinding& finding : result.findings) {
      answer.warnings.push_back(file_ + (finding.line > 0 ? ":" + std::to_string(finding.line) : "") + ": " +
                                toString(finding.kind) + ": " + finding.message);
    }
    answer.json.set("source", file_).set("version", document.version);
    answer.json.set("part_number", document.part_number).set("segments", document.segments.size());
    answer.json.set("cables", result.draft.cables.size()).set("joints", result.draft.joints.size());
    answer.json.set("clips", result.draft.clips.size());
    answer.json.set("findings", findingsJson(file_, result.findings)).set("defaults", result.defaults);
    control.complete();
    if (output_.empty()) {
      answer.text = scene;
      answer.json.set("scene", scene);
      return answer;
    }
    cable_variation::writeFile(output_, scene);
    answer.json.set("output", output_);
    for (const std::string& value : result.defaults) answer.text += wrapped("default: " + value);
    answer.text += wrapped(output_ + ": " + std::to_string(document.segments.size()) + " segments as " +
                           std::to_string(result.draft.cables.size()) + " cables, " +
                           std::to_string(result.draft.joints.size()) + " joints and " +
                           std::to_string(result.draft.clips.size()) + " clips; " +
                           std::to_string(result.findings.size()) + " findings");
    return answer;
  }

 private:
  void chooseRestShape(ImportMapping& mapping) const {
    if (rest_shape_.empty()) return;
    if (rest_shape_ != "straight" && rest_shape_ != "curve")
      throw UsageError("--rest_shape: is '" + rest_shape_ + "', expected straight or curve");
    mapping.rest_shape = rest_shape_ == "curve" ? ImportedRestShape::curve : ImportedRestShape::straight;
    mapping.given.insert("rest_shape");
  }

  /// A scene that would not load is this program's fault, or beyond the limits of a scene.
  void requireReadable(const std::string& text) const {
    const std::string name = output_.empty() ? "the scene" : output_;
    try {
      cable_variation::readSceneText(text, name, [](const std::string&) { return std::string(); });
    } catch (const SceneError& error) {
      throw cable_variation::InternalError("the scene made of " + file_ +
                                           " does not load, it is not written: " + error.what());
    }
  }

  std::string file_, mapping_, output_, rest_shape_;
};

}  // namespace

std::unique_ptr<Verb> makeImport() { return std::make_unique<ImportVerb>(); }

}  // namespace cable_variation_command
