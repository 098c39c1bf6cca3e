#include <cable_variation/harness/harness.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace cable_variation {
namespace {

template <class... Parts>
std::string textOf(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  throw std::invalid_argument(textOf(parts...));
}

const Cable& cableOf(const Harness& harness, std::size_t index, const std::string& who) {
  if (index >= harness.cables.size()) {
    refuse(who, " names cable ", index, ", expected less than the ", harness.cables.size(),
           " cables there are");
  }
  return harness.cables[index];
}

void requireOnCable(const Cable& cable, double arc_length, const std::string& who) {
  if (!(arc_length >= 0.0 && arc_length <= cable.length * (1.0 + 1e-9))) {
    refuse(who, " is at ", arc_length, " m of cable '", cable.name,
           "', expected between 0 and its length of ", cable.length, " m");
  }
}

void requireUnit(const Eigen::Quaterniond& q, const std::string& who) {
  if (!(std::abs(q.norm() - 1.0) < 1e-6))
    refuse(who, " has an orientation of norm ", q.norm(), ", expected 1");
}

void validate(const Harness& harness, const Clip& clip) {
  const std::string who = "clip '" + clip.name + "'";
  const Cable& cable = cableOf(harness, clip.cable, who);
  requireOnCable(cable, clip.arc_length, who);
  requireUnit(clip.pose.orientation, who);
  if (!clip.pose.position.allFinite()) refuse(who, " has a position that is not finite");
  if (clip.constraint.slides && !(clip.arc_length > 0.0 && clip.arc_length < cable.length)) {
    refuse(who, " slides, so it must start inside cable '", cable.name, "', between 0 and ", cable.length,
           " m; it is at ", clip.arc_length, " m");
  }
  for (const auto* freedoms : {&clip.constraint.translation, &clip.constraint.rotation}) {
    for (const ClipFreedom& freedom : *freedoms) {
      if (freedom.kind != ClipFreedom::Kind::sprung) continue;
      if (!(std::isfinite(freedom.stiffness) && freedom.stiffness > 0.0)) {
        refuse(who, " has a spring of stiffness ", freedom.stiffness, ", expected a positive number");
      }
    }
  }
}

void validate(const Harness& harness, const Joint& joint) {
  const std::string who = "joint '" + joint.name + "'";
  requireOnCable(cableOf(harness, joint.parent, who), joint.parent_arc_length, who);
  requireOnCable(cableOf(harness, joint.child, who), joint.child_arc_length, who);
  requireUnit(joint.rotation, who);
  if (joint.type == Joint::Type::hinge && !(std::abs(joint.axis.norm() - 1.0) < 1e-6)) {
    refuse(who, " has a hinge axis of length ", joint.axis.norm(), ", expected 1");
  }
  if (joint.parent == joint.child) {
    refuse(who, " joins cable '", harness.cables[joint.parent].name, "' to itself, expected two cables");
  }
}

void validate(const Harness& harness, const PointLoad& load) {
  const std::string who = "load '" + load.name + "'";
  requireOnCable(cableOf(harness, load.cable, who), load.arc_length, who);
  if (!load.force.allFinite()) refuse(who, " has a force that is not finite");
  if (!load.moment.allFinite()) refuse(who, " has a moment that is not finite");
}

// Where a cable slides, the radius at a place of it would be an unknown, which contact does not know yet.
void requireKnownRadius(const Harness& harness, const PartContact& contact) {
  const Cable& cable = harness.cables[contact.cable];
  const double radius = cable.sections.front().section.radius;
  const bool varies = std::any_of(cable.sections.begin(), cable.sections.end(),
                                  [&](const SectionAt& knot) { return knot.section.radius != radius; });
  if (!varies) return;
  for (const Clip& clip : harness.clips) {
    if (clip.cable != contact.cable || !clip.constraint.slides) continue;
    refuse("cable '", cable.name, "' slides through clip '", clip.name,
           "', and its radius changes along it; contact with part '", contact.part,
           "' expects the same radius all along, or a cable that does not slide");
  }
}

void validate(const Harness& harness, const PartContact& contact) {
  const std::string who = "contact with part '" + contact.part + "'";
  const Cable& cable = cableOf(harness, contact.cable, who);
  if (!contact.surface) refuse(who, " has no surface");
  if (!(std::isfinite(contact.stand_off) && contact.stand_off >= 0.0))
    refuse(who, " has a stand-off of ", contact.stand_off, " m, expected 0 or more");
  if (!(std::isfinite(contact.skip_near_clips) && contact.skip_near_clips >= 0.0))
    refuse(who, " skips ", contact.skip_near_clips, " m near clips, expected 0 or more");
  for (const std::size_t clip : contact.own_clips) {
    if (clip >= harness.clips.size())
      refuse(who, " names clip ", clip, ", expected less than the ", harness.clips.size(),
             " clips there are");
  }
  for (const SectionAt& section : cable.sections) {
    if (section.section.radius + contact.stand_off > 0.0) continue;
    refuse("cable '", cable.name, "' has a radius of ", section.section.radius, " m and a stand-off of ",
           contact.stand_off, " m from part '", contact.part, "'; contact expects more than 0 together");
  }
  requireKnownRadius(harness, contact);
}

// Two clips, or a clip and a joint's child, cannot hold one section.
void collectSharedSections(const Harness& harness, std::vector<std::string>& faults) {
  struct Claim {
    std::size_t cable;
    double arc_length;
    std::string who;
  };
  std::vector<Claim> claims;
  for (const Clip& clip : harness.clips) {
    if (clip.attached) claims.push_back({clip.cable, clip.arc_length, "clip '" + clip.name + "'"});
  }
  for (const Joint& joint : harness.joints) {
    claims.push_back({joint.child, joint.child_arc_length, "joint '" + joint.name + "'"});
  }
  for (std::size_t i = 0; i < claims.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (claims[i].cable != claims[j].cable) continue;
      const Cable& cable = harness.cables[claims[i].cable];
      if (std::abs(claims[i].arc_length - claims[j].arc_length) > 1e-6 * cable.length) continue;
      faults.push_back(textOf(claims[j].who, " and ", claims[i].who, " both hold cable '", cable.name,
                              "' at ", claims[i].arc_length, " m, expected different places"));
    }
  }
}

// Every cable must be connected, through joints, to a clip that holds something.
void collectLooseCables(const Harness& harness, std::vector<std::string>& faults) {
  std::vector<bool> held(harness.cables.size(), false);
  for (const Clip& clip : harness.clips) {
    held[clip.cable] = held[clip.cable] || (clip.attached && clip.constraint.holdsPosition());
  }
  for (std::size_t round = 0; round < harness.joints.size(); ++round) {
    for (const Joint& joint : harness.joints) {
      if (held[joint.parent] || held[joint.child]) held[joint.parent] = held[joint.child] = true;
    }
  }
  const bool open = std::any_of(harness.clips.begin(), harness.clips.end(),
                                [](const Clip& clip) { return !clip.attached; });
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (!held[i]) {
      faults.push_back(textOf("cable '", harness.cables[i].name, "' is held by no ", open ? "attached " : "",
                              "clip, neither itself nor through a joint; expected at least one"));
    }
  }
}

// Following joints from child to parent must not lead back.
void collectJointCycles(const Harness& harness, std::vector<std::string>& faults) {
  for (const Joint& start : harness.joints) {
    const Joint* joint = &start;
    for (std::size_t steps = 0; joint != nullptr; ++steps) {
      if (steps > harness.joints.size()) {
        faults.push_back(
            textOf("joint '", start.name,
                   "' hangs on itself: its parent's section is, through other joints, its own child"));
        break;
      }
      const auto above = std::find_if(harness.joints.begin(), harness.joints.end(), [&](const Joint& other) {
        return other.child == joint->parent && std::abs(other.child_arc_length - joint->parent_arc_length) <=
                                                   1e-6 * harness.cables[joint->parent].length;
      });
      joint = above == harness.joints.end() ? nullptr : &*above;
    }
  }
}

}  // namespace

void validate(const Harness& harness) {
  const std::vector<std::string> faults = faultsOf(harness);
  if (!faults.empty()) throw std::invalid_argument(faults.front());
}

std::vector<std::string> faultsOf(const Harness& harness) {
  std::vector<std::string> faults;
  const auto collect = [&faults](const auto& check) {
    try {
      check();
    } catch (const std::invalid_argument& error) {
      faults.emplace_back(error.what());
    }
  };
  if (!harness.gravity.allFinite()) faults.emplace_back("gravity is not finite");
  if (harness.cables.empty()) faults.emplace_back("the harness has no cable, expected at least one");
  for (const Cable& cable : harness.cables) collect([&] { validate(cable); });
  for (const Clip& clip : harness.clips) collect([&] { validate(harness, clip); });
  for (const Joint& joint : harness.joints) collect([&] { validate(harness, joint); });
  for (const PointLoad& load : harness.loads) collect([&] { validate(harness, load); });
  for (const PartContact& contact : harness.contacts) collect([&] { validate(harness, contact); });
  if (!faults.empty()) return faults;  // what follows needs sound indices and lengths
  collectSharedSections(harness, faults);
  collectLooseCables(harness, faults);
  collectJointCycles(harness, faults);
  return faults;
}

}  // namespace cable_variation
