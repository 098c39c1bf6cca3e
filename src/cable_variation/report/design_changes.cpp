#include <cable_variation/report/design_changes.h>

#include <variant>

#include <cable_variation/report/markup.h>
#include <cable_variation/util/display_unit.h>

namespace cable_variation {

namespace {

std::string changed(double before, double after, const std::string& si_unit) {
  constexpr int kDigits = 6;
  const DisplayUnit unit = displayUnit(si_unit);
  return figure(unit.factor * before, kDigits) + " → " + figure(unit.factor * after, kDigits) + " " +
         unit.symbol;
}

/// Told of the cable or the clip itself.
bool isToldOtherwise(const DesignTarget& target) {
  const auto* property = std::get_if<CableProperty>(&target);
  return std::holds_alternative<ClipArcLength>(target) ||
         (property != nullptr && property->property == CableProperty::Property::length);
}

/// How far a thing was moved and turned, as far as it was.
void addMotion(const std::string& what, const Pose& motion, std::vector<std::string>& changes) {
  constexpr double kRounding = 1e-12;
  if (motion.position.norm() > kRounding)
    changes.push_back(what + " moved by " + figure(displayUnit("m").factor * motion.position.norm()) + " mm");
  const double turn = Eigen::AngleAxisd(motion.orientation).angle();
  if (motion.orientation.vec().norm() > kRounding)
    changes.push_back(what + " turned by " + figure(displayUnit("rad").factor * turn) + " deg");
}

}  // namespace

std::vector<std::string> designChanges(const Scene& loaded, const Scene& edited,
                                       const ComponentPoses& shifts) {
  std::vector<std::string> changes;
  for (std::size_t i = loaded.harness.cables.size(); i < edited.harness.cables.size(); ++i)
    changes.push_back("cable " + edited.harness.cables[i].name + " added");
  for (std::size_t i = 0; i < loaded.harness.cables.size(); ++i) {
    const double before = loaded.harness.cables[i].length, after = edited.harness.cables[i].length;
    if (before == after) continue;
    changes.push_back("length of cable " + edited.harness.cables[i].name + " " + changed(before, after, "m"));
  }
  for (const auto& [component, shift] : shifts) addMotion("component " + component, shift, changes);
  for (std::size_t i = loaded.harness.clips.size(); i < edited.harness.clips.size(); ++i) {
    changes.push_back("clip " + edited.harness.clips[i].name + " added (" + edited.harness.clips[i].type +
                      ")");
  }
  for (std::size_t i = 0; i < loaded.harness.clips.size(); ++i) {
    const std::string clip = "clip " + edited.harness.clips[i].name;
    const double before = loaded.harness.clips[i].arc_length, after = edited.harness.clips[i].arc_length;
    const std::size_t cable = edited.harness.clips[i].cable;
    const bool at_end =  // of a cable that got longer or shorter
        before == loaded.harness.cables[cable].length && after == edited.harness.cables[cable].length;
    if (before != after && !at_end)
      changes.push_back(clip + " along the cable " + changed(before, after, "m"));
    if (loaded.harness.clips[i].attached != edited.harness.clips[i].attached)
      changes.push_back(clip + (edited.harness.clips[i].attached ? " closed" : " opened"));
    const Pose moved = loaded.clip_mounts[i].pose.inverse() * edited.clip_mounts[i].pose;
    addMotion(clip, moved, changes);
  }
  for (std::size_t i = 0; i < edited.design_variables.size(); ++i) {
    const DesignVariable& variable = edited.design_variables[i];
    const double before = loaded.design_variables[i].nominal;
    if (before == variable.nominal || isToldOtherwise(variable.target)) continue;
    changes.push_back(variable.name + " " + changed(before, variable.nominal, variable.unit));
  }
  return changes;
}

}  // namespace cable_variation
