#pragma once  // internal to geometry/

#include <optional>

#include <cable_variation/geometry/tube_distance/tube_section.h>

namespace cable_variation {

/// A lower bound of the distance [m] of a part of one section, given by its control points, from all of
/// another: sharp where the two run beside each other, where hulls have to be cut very small.
///
/// Each place p(u) is compared with one place q(v(u)) near its foot, v linear in u. Half the squared distance
/// to q(v), as a function of v, has a second derivative of at least some m > 0, if q is further from the
/// centre of its bend than p: so with D = p(u) - q(v(u)) the squared distance is at least |D|² - (D·q')²/m
/// whatever v is. Both are polynomials of u, whose Bernstein coefficients bound them. None where there is no
/// such m.
std::optional<double> parallelBound(const TubeSection& first, const ControlPoints& part,
                                    const TubeSection& second);

}  // namespace cable_variation
