#include <cable_variation/harness/clip.h>

#include <algorithm>

namespace cable_variation {
namespace {

constexpr ClipFreedom kLocked{};
constexpr ClipFreedom kFree{ClipFreedom::Kind::free, 0.0};

bool anyHeld(const std::array<ClipFreedom, 3>& freedoms) {
  return std::any_of(freedoms.begin(), freedoms.end(),
                     [](const ClipFreedom& f) { return f.kind != ClipFreedom::Kind::free; });
}

}  // namespace

bool ClipConstraint::holdsPosition() const { return anyHeld(translation); }

bool ClipConstraint::holdsRotation() const { return anyHeld(rotation); }

bool ClipConstraint::locksPosition() const {
  return std::all_of(translation.begin(), translation.end(),
                     [](const ClipFreedom& f) { return f.kind == ClipFreedom::Kind::locked; });
}

ClipConstraint fixedClip() { return {{kLocked, kLocked, kLocked}, {kLocked, kLocked, kLocked}, false}; }

ClipConstraint rollingClip() { return {{kLocked, kLocked, kLocked}, {kFree, kLocked, kLocked}, false}; }

ClipConstraint pivotClip() { return {{kLocked, kLocked, kLocked}, {kFree, kFree, kFree}, false}; }

ClipConstraint hingeClip(Axis axis) {
  ClipConstraint constraint = fixedClip();
  constraint.rotation[static_cast<std::size_t>(axis)] = kFree;
  return constraint;
}

ClipConstraint slidingClip() {
  ClipConstraint constraint = fixedClip();
  constraint.slides = true;
  return constraint;
}

ClipConstraint slidingRollingClip() {
  ClipConstraint constraint = rollingClip();
  constraint.slides = true;
  return constraint;
}

ClipConstraint eyeletClip() {
  ClipConstraint constraint = pivotClip();
  constraint.slides = true;
  return constraint;
}

ClipConstraint guideClip(bool rolls) {
  ClipConstraint constraint = rolls ? rollingClip() : fixedClip();
  constraint.translation[0] = kFree;
  return constraint;
}

ClipConstraint planeClip(Axis normal) {
  ClipConstraint constraint = freeClip();
  constraint.translation[static_cast<std::size_t>(normal)] = kLocked;
  return constraint;
}

ClipConstraint grommetClip(const GrommetStiffness& k, bool slides) {
  return {{ClipFreedom::sprung(k.axial), ClipFreedom::sprung(k.radial), ClipFreedom::sprung(k.radial)},
          {ClipFreedom::sprung(k.torsional), ClipFreedom::sprung(k.conical), ClipFreedom::sprung(k.conical)},
          slides};
}

ClipConstraint freeClip() { return {{kFree, kFree, kFree}, {kFree, kFree, kFree}, false}; }

}  // namespace cable_variation
