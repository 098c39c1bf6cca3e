#include <command/loaded_design.h>

#include <utility>

#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/util/sha256.h>

namespace cable_variation_command {

using cable_variation::MeasureEvaluator;
using cable_variation::SolvedScene;

LoadedDesign::LoadedDesign(cable_variation::Scene scene, const std::string& author)
    : design_{std::move(scene), {}, {}},
      origin_{cable_variation::sha256(cable_variation::readSceneFile(design_.scene.source)), {}, author},
      harness_(harnessAt(design_, {})),
      solver_(newSolver(design_.scene)),
      equilibrium_(shapeFromNothing(solver_, harness_)),
      components_(componentPosesAt(design_.scene, {})) {}

const MeasureEvaluator& LoadedDesign::evaluator(const SolvedScene& any) {
  if (!evaluator_) evaluator_.emplace(design_.scene, equilibrium_.converged() ? solved() : any);
  return *evaluator_;
}

cable_variation::ComponentParts LoadedDesign::parts() const {
  return evaluator_ ? evaluator_->parts() : cable_variation::ComponentParts();
}

cable_variation::DesignSnapshot LoadedDesign::snapshot() const {
  return {design_, {}, solver_, parts(), 0, origin_};
}

}  // namespace cable_variation_command
