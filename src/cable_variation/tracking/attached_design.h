#pragma once

#include <cstddef>
#include <vector>

#include <cable_variation/scene/design.h>
#include <cable_variation/tracking/clip_attachment.h>

namespace cable_variation {

/// A clip that is to close or to open.
struct AttachmentWish {
  std::size_t clip = 0;  ///< index into Harness::clips
  bool attached = true;
  bool closest = false;  ///< closing: takes hold of the closest section, as clips that slide do in any case
  double reach = 0.02;   ///< closing: of a section further away than this it does not [m]
};

/// A design with clips closed and opened at the same moment.
struct AttachedDesign {
  Design design;
  std::vector<AttachmentGap> gaps;  ///< per wish; of those that open, nothing
};

/// What followAttachment() is to lead to. Throws std::invalid_argument: a clip is closed or open already, the
/// section is too far away (says how far), a cable would be held by nothing, two clips would hold one
/// section.
/// @param harness of the design, its clips where they are now @param equilibrium its shape, converged
AttachedDesign withAttachments(Design design, const std::vector<AttachmentWish>& wishes,
                               const Harness& harness, const Equilibrium& equilibrium);

/// What `Scene::attachments` have each clip do at `time` [s] of the motions, if that is not what it does in
/// `harness`.
std::vector<AttachmentWish> scheduledAt(const Scene& scene, const Harness& harness, double time);

}  // namespace cable_variation
