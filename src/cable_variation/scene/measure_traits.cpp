#include <cable_variation/scene/measure_traits.h>

namespace cable_variation {
namespace {

using Type = Measure::Type;
using Subject = MeasureTraits::Subject;
using Worse = MeasureTraits::Worse;
using Unlikely = MeasureTraits::UnlikelyLimit;

constexpr bool kClearance = true, kFromNominal = true, kEigenvalue = true;

// A position is a coordinate: its limits may well be further than the cables are long.
// clang-format off
constexpr MeasureTraitsTable kTraits{{
    {Type::distance, "distance", &quantity::length, Subject::cables, Worse::smaller, Unlikely::longer_than_cables, kClearance},
    {Type::similarity, "similarity", &quantity::length, Subject::cables, Worse::larger, Unlikely::longer_than_cables, !kClearance, kFromNominal},
    {Type::position, "position", &quantity::length, Subject::cable, Worse::further_from_nominal, Unlikely::none},
    {Type::bend_radius, "bend_radius", &quantity::length, Subject::cables, Worse::smaller, Unlikely::longer_than_cables},
    {Type::strain, "strain", &quantity::number, Subject::cables, Worse::larger, Unlikely::from_one},
    {Type::stress, "stress", &quantity::stress, Subject::cables, Worse::larger, Unlikely::below_a_kilopascal},
    {Type::section_force, "section_force", &quantity::force, Subject::cables, Worse::larger, Unlikely::none},
    {Type::section_moment, "section_moment", &quantity::moment, Subject::cables, Worse::larger, Unlikely::none},
    {Type::twist, "twist", &quantity::angle, Subject::cable, Worse::larger, Unlikely::none},
    {Type::clip_force, "clip_force", &quantity::force, Subject::clip, Worse::larger, Unlikely::none},
    {Type::clip_moment, "clip_moment", &quantity::moment, Subject::clip, Worse::larger, Unlikely::none},
    {Type::slide, "slide", &quantity::length, Subject::clip, Worse::larger, Unlikely::longer_than_cables},
    {Type::contact_force, "contact_force", &quantity::force, Subject::cables, Worse::larger, Unlikely::none},
    {Type::contact_length, "contact_length", &quantity::length, Subject::cables, Worse::larger, Unlikely::longer_than_cables},
    {Type::route_deviation, "route_deviation", &quantity::length, Subject::cable, Worse::larger, Unlikely::longer_than_cables},
    {Type::energy, "energy", &quantity::energy, Subject::harness, Worse::larger, Unlikely::none},
    {Type::eigenvalue, "eigenvalue", &quantity::spring, Subject::harness, Worse::smaller, Unlikely::none, !kClearance, !kFromNominal, kEigenvalue},
}};
// clang-format on
static_assert(hasRowOfEach(kTraits, &MeasureTraits::type),
              "a type of measure has no row, or is out of order");

}  // namespace

const MeasureTraitsTable& measureTraits() { return kTraits; }

const MeasureTraits& traitsOf(Measure::Type type) { return kTraits.at(static_cast<std::size_t>(type)); }

const char* toString(Measure::Type type) { return traitsOf(type).name; }

}  // namespace cable_variation
