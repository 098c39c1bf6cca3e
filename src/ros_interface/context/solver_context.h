#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <ros/time.h>

#include <cable_variation/analysis/design_snapshot.h>
#include <cable_variation/analysis/design_trial.h>
#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/scene/design.h>
#include <cable_variation/sensitivity/stability_analysis.h>
#include <cable_variation/tracking/clip_attachment.h>
#include <cable_variation/tracking/saved_design.h>
#include <cable_variation/util/input_limits.h>

namespace cable_variation_ros {

/// The scene, the design in force and its shape: what the solver's services share.
class SolverContext {
 public:
  /// The harness need not have an equilibrium: equilibrium() tells. A scene of components alone has none
  /// either, and loads, edits and moves as others do.
  /// @param limits of files that are read
  explicit SolverContext(cable_variation::Scene scene, const cable_variation::InputLimits& limits = {});

  const cable_variation::InputLimits& limits() const { return limits_; }

  const cable_variation::Design& design() const { return design_; }
  const cable_variation::Scene& loaded() const { return loaded_; }      ///< the scene without any edit
  const std::string& loadedText() const { return loaded_text_; }        ///< of its file; empty: it has none
  const cable_variation::Harness& harness() const { return harness_; }  ///< in force
  const cable_variation::Equilibrium& equilibrium() const { return equilibrium_; }
  /// The shape in force, or while there is none the last one of the design in force; not converged: never
  /// any.
  const cable_variation::Equilibrium& lastShape() const {
    return equilibrium_.converged() ? equilibrium_ : last_shape_;
  }
  /// That the last change made, if it was one of the components' places or of clips that close.
  const std::optional<cable_variation::ShapeJump>& lastJump() const { return jump_; }
  /// Components that are not where the scene has them: on tf, or by an edit of the design.
  const cable_variation::ComponentPoses& moved() const { return moved_; }
  const cable_variation::ComponentPoses& onTf() const {
    return on_tf_;
  }  ///< those alone that tf has elsewhere

  /// Of all components in the world, the deviations of the design included.
  cable_variation::ComponentPoses components() const;
  /// The newest tf that the components' places come from; without any, when the shape was solved.
  const ros::Time& stamp() const { return stamp_; }
  /// Scenes loaded in place of the first one.
  std::size_t loads() const { return loads_; }
  /// Whether anything was edited since the scene was loaded or reset.
  bool edited() const { return edited_; }
  cable_variation::DesignOrigin origin() const;
  void setAuthor(const std::string& author) { author_ = author; }

  /// Another number, another scene or design; moving components does not change it.
  std::size_t designNumber() const { return design_number_; }

  /// A copy for work on another thread.
  using Snapshot = cable_variation::DesignSnapshot;
  Snapshot snapshot() const;
  /// Components as far as they have been prepared: those that measures looked at.
  cable_variation::ComponentParts parts() const;
  /// For work on another thread with a snapshot of this context, which must outlive it. Its nominal shape is
  /// any.
  cable_variation::MeasureEvaluator evaluator(const Snapshot& snapshot) const;
  /// Of the design in force; its nominal shape is the one in force, which must have converged.
  cable_variation::MeasureEvaluator evaluatorInForce() const;

  /// Called whenever the harness or its shape has changed.
  void onChange(std::function<void()> callback) { changed_ = std::move(callback); }

  // Each throws, and leaves all as it was, when the harness is invalid
  // (std::invalid_argument) or has no equilibrium (requireConverged()).

  /// Another scene, solved from nothing.
  void load(cable_variation::Scene scene);
  /// A design that was in force before, of the scene `loaded`, in the shape that it had.
  void restore(cable_variation::Scene loaded, cable_variation::SavedDesign saved);
  /// The scene as loaded, solved from nothing.
  void reset();
  /// An edited design; the shape is followed to it, or solved from nothing if it cannot be.
  void adopt(cable_variation::Design design);

  /// A design that differs from the one in force in which clips are attached, and where those hold that
  /// close: the shape follows from the one in force, of which there must be one. `energy_before` and the like
  /// are in lastAttachment().
  void attach(cable_variation::Design design);
  /// What the last change was, if it was attach(); of the clips before it, attachedBefore().
  const std::optional<cable_variation::AttachedClips>& lastAttachment() const { return attachment_; }
  const std::vector<bool>& attachedBefore() const { return attached_before_; }  ///< per clip

  /// Components have moved on tf: the shape follows. Whether it could, equilibrium() tells.
  /// @param stamp of the newest tf that tells so
  void move(const cable_variation::ComponentPoses& on_tf, const ros::Time& stamp);

  /// Components are where they were, as newer tf tells: the stamp alone changes.
  void confirm(const ros::Time& stamp);
  /// Called then.
  void onConfirm(std::function<void()> callback) { confirmed_ = std::move(callback); }

  /// An equilibrium beside the one in force.
  using Trial = cable_variation::DesignTrial;
  /// `follow`: from the shape in force, else from nothing.
  Trial solve(const cable_variation::DesignValues& values, const cable_variation::ComponentPoses& moved,
              bool follow) const;

  /// The scene as it was loaded, without edits and with its components where it has them, solved from
  /// nothing, once. Throws requireConverged()'s.
  const Trial& asLoaded() const;

  /// Measures (indices into Scene::measures) of a trial, similarity being that
  /// to the shape in force; without such a shape it is not a number, and its
  /// note says so.
  std::vector<cable_variation::MeasureValue> measure(const Trial& trial,
                                                     const std::vector<std::size_t>& measures) const;
  /// Of the design in force with `options.values`, to which the shape is followed
  /// where it can be. Completes options.values with what is in force, and options.moved.
  /// Throws as requireConverged() if there is none.
  cable_variation::StabilityAnalysis analyse(cable_variation::StabilityOptions& options) const;

  /// How the shape in force, which must have converged, changes with a design variable (an index).
  cable_variation::EquilibriumRate shapeRate(std::size_t variable) const;

 private:
  void take(cable_variation::EquilibriumSolver solver, cable_variation::Design design,
            cable_variation::Harness harness, cable_variation::Equilibrium equilibrium, bool edited,
            std::optional<cable_variation::AttachedClips> attachment = {});
  void replaceScene(cable_variation::Scene loaded, std::string text);
  void notify();
  const cable_variation::MeasureEvaluator& preparedEvaluator(const cable_variation::SolvedScene& any) const;
  std::vector<cable_variation::MeasureValue> measure(const cable_variation::SolvedScene& at,
                                                     const std::vector<std::size_t>& measures) const;

  cable_variation::InputLimits limits_;
  cable_variation::Scene loaded_;  ///< for reset()
  std::string loaded_text_;
  std::string author_;
  cable_variation::Design design_;
  cable_variation::ComponentPoses on_tf_, moved_;
  cable_variation::Harness harness_;
  cable_variation::EquilibriumSolver solver_;
  cable_variation::Equilibrium equilibrium_;
  cable_variation::Equilibrium last_shape_;
  std::optional<cable_variation::ShapeJump> jump_;
  std::optional<cable_variation::AttachedClips> attachment_;
  std::vector<bool> attached_before_;
  ros::Time stamp_ = ros::Time::now();
  std::size_t design_number_ = 0;
  std::function<void()> changed_, confirmed_;
  // Preparing the components' geometry takes tens of milliseconds: done when first needed, kept for a scene.
  mutable std::optional<cable_variation::MeasureEvaluator> evaluator_;
  mutable bool evaluator_in_force_ = false;  ///< its nominal shape is the one in force
  mutable std::optional<Trial> as_loaded_;
  std::size_t loads_ = 0;
  bool edited_ = false;
};

}  // namespace cable_variation_ros
