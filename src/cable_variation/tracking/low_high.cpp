#include <cable_variation/tracking/low_high.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <cable_variation/measures/cable_view.h>

namespace cable_variation {
namespace {

// Stretches that shapes are followed by, in radii of the thinnest cable: their ends tell of a jump.
constexpr double kStretch = 4.0;
constexpr std::size_t kFewestStretches = 16;  // per cable, of one that is thick for its length

}  // namespace

std::string deviationText(const DesignVariable& variable, double deviation) {
  std::ostringstream text;
  text.precision(3);
  if (variable.unit == "rad") {
    text << deviation * 180.0 / M_PI << " deg";
  } else if (variable.unit == "m") {
    text << 1e3 * deviation << " mm";
  } else {
    text << deviation << (variable.unit.empty() ? "" : " ") << variable.unit;
  }
  return text.str();
}

LimitFinder::LimitFinder(const Scene& scene, const DesignValues& values, const ComponentPoses& moved,
                         const Harness& harness, const Equilibrium& equilibrium,
                         const EquilibriumSolver& solver)
    : scene_(scene),
      values_(values),
      moved_(moved),
      harness_(harness),
      equilibrium_(equilibrium),
      solver_(solver) {
  const std::vector<CableView> views = viewsOf(harness, equilibrium);
  double thinnest = std::numeric_limits<double>::infinity();
  for (const CableShape& shape : equilibrium.shapes) thinnest = std::min(thinnest, shape.radius);
  for (std::size_t cable = 0; cable < views.size(); ++cable) {
    const double longest =
        std::min(kStretch * thinnest, harness.cables[cable].length / static_cast<double>(kFewestStretches));
    const auto own = cutIntoStretches(cable, views[cable], longest);
    stretches_.insert(stretches_.end(), own.begin(), own.end());
  }
}

AtLimit LimitFinder::find(std::size_t variable, bool upper) const {
  const DesignVariable& varied = scene_.design_variables[variable];
  VariedDesign design;
  design.variables = {variable};
  design.values = values_;
  design.moved = moved_;
  const SampleSpace space(scene_, design);
  SamplePlace place = space.designAt(0.0);
  place.deviations[0] = upper ? varied.upper : varied.lower;
  FollowedShape followed;
  try {
    const StretchReader reader(space, stretches_, frames_);
    followed = ShapeFollower(reader, solver_, harness_, equilibrium_, 0.0).followClosely(place);
  } catch (const std::exception& error) {
    followed.message = error.what();
  }
  if (!followed.converged) return leap(space, place, followed.message);
  AtLimit found{
      std::move(followed.equilibrium), std::move(followed.harness), space.components(place), "", {}};
  if (followed.jump) {
    const MaterialStretch& stretch = stretches_[followed.jump->stretch];
    found.snap = SnapWithin{
        variable,
        0.5 * (followed.jump->before.place.deviations[0] + followed.jump->after.place.deviations[0]),
        followed.jump->distance, stretch.cable, 0.5 * (stretch.start + stretch.end)};
    std::ostringstream text;
    text.precision(3);
    text << "from " << deviationText(varied, found.snap->deviation)
         << " on the cables snap to another equilibrium, by " << 1e3 * found.snap->jump << " mm";
    found.message = text.str();
  }
  return found;
}

// What there is at the limit although the shape could not be followed there.
AtLimit LimitFinder::leap(const SampleSpace& space, const SamplePlace& place, const std::string& why) const {
  AtLimit found;
  found.message = why;
  try {
    EquilibriumSolver solver = solver_;
    found.harness = space.harness(place);
    found.equilibrium = solver.update(found.harness);
    if (!found.equilibrium.converged()) {
      found.message = found.equilibrium.message;
      return found;
    }
    found.components = space.components(place);
    found.message = "the shape cannot be followed there (" + why +
                    "): the values are those of an equilibrium " + "that it may not go over into";
  } catch (const std::invalid_argument& error) {
    found.message = error.what();
  }
  return found;
}

}  // namespace cable_variation
