#include <cable_variation/geometry/mesh/marching_tetrahedra.h>

#include <algorithm>

namespace cable_variation {
namespace {

// Corners of a cube are numbered by their bits: 1 along x, 2 along y, 4 along z. A tetrahedron goes from
// corner 0 to corner 7 along the axes in one of six orders; those of odd order are mirrored, so two of their
// corners change places.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra = {
    {{0, 1, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}, {0, 3, 2, 7}, {0, 6, 4, 7}}};

// All even orders that put one corner, or two, first.
constexpr std::array<std::array<std::size_t, 4>, 4> kOneFirst = {
    {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}}};
constexpr std::array<std::array<std::size_t, 4>, 6> kTwoFirst = {
    {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};

class Contouring {
 public:
  Contouring(const GridBlock& block, const Eigen::Vector3d& origin, double cell)
      : block_(block), origin_(origin), cell_(cell) {
    number_.fill(kNone);
  }

  void cube(int x, int y, int z) {
    x_ = x;
    y_ = y;
    z_ = z;
    int inside = 0;
    for (int corner = 0; corner < 8; ++corner) inside += isInside(corner);
    if (inside == 0 || inside == 8) return;
    for (const auto& corners : kTetrahedra) tetrahedron(corners);
  }

  ContourPart part;

 private:
  static constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);
  using Triangle = std::array<std::uint32_t, 3>;

  std::size_t point(int corner) const {
    return GridBlock::at(x_ + (corner & 1), y_ + (corner >> 1 & 1), z_ + (corner >> 2));
  }
  bool isInside(int corner) const { return block_.values[point(corner)] < 0.0; }

  void tetrahedron(const std::array<int, 4>& corners) {
    std::size_t inside = 0;
    for (std::size_t i = 0; i < 4; ++i) inside |= static_cast<std::size_t>(isInside(corners[i])) << i;
    const auto vertex = [&](std::size_t a, std::size_t b) { return vertexOn(corners[a], corners[b]); };
    for (const auto& [a, b, c, d] : kOneFirst) {
      const std::size_t alone = std::size_t{1} << a;
      if (inside == alone) part.triangles.push_back(Triangle{vertex(a, b), vertex(a, c), vertex(a, d)});
      if (inside == 15 - alone) part.triangles.push_back(Triangle{vertex(a, b), vertex(a, d), vertex(a, c)});
    }
    for (const auto& [a, b, c, d] : kTwoFirst) {
      if (inside != (std::size_t{1} << a | std::size_t{1} << b)) continue;
      const std::uint32_t p = vertex(a, c), q = vertex(a, d), r = vertex(b, d), s = vertex(b, c);
      const auto squared = [&](std::uint32_t i, std::uint32_t k) {
        return (part.vertices[i] - part.vertices[k]).squaredNorm();
      };
      if (squared(p, r) <= squared(q, s)) {
        part.triangles.push_back(Triangle{p, q, r});
        part.triangles.push_back(Triangle{p, r, s});
      } else {
        part.triangles.push_back(Triangle{p, q, s});
        part.triangles.push_back(Triangle{q, r, s});
      }
    }
  }

  // From the lower corner to the higher one: all that share the edge compute the same.
  std::uint32_t vertexOn(int a, int b) {
    const int low = std::min(a, b), high = std::max(a, b);
    const int direction = high - low;  // the bits that differ, for the higher one has all of the lower one's
    std::uint32_t& number = number_[point(low) * 8 + static_cast<std::size_t>(direction)];
    if (number != kNone) return number;
    number = static_cast<std::uint32_t>(part.vertices.size());

    const std::array<std::int64_t, 3> at = {block_.first[0] + x_ + (low & 1),
                                            block_.first[1] + y_ + (low >> 1 & 1),
                                            block_.first[2] + z_ + (low >> 2)};
    const auto bits = [](std::int64_t value) { return static_cast<std::uint64_t>(value); };
    part.edges.push_back(
        ((bits(at[2]) * (GridBlock::kLargest + 1) + bits(at[1])) * (GridBlock::kLargest + 1) + bits(at[0])) *
            8 +
        bits(direction));
    const double from = block_.values[point(low)], to = block_.values[point(high)];
    const double share = from / (from - to);
    const Eigen::Array3d corner(static_cast<double>(at[0]), static_cast<double>(at[1]),
                                static_cast<double>(at[2]));
    const Eigen::Array3d way(direction & 1, direction >> 1 & 1, direction >> 2);
    part.vertices.emplace_back(origin_ + cell_ * (corner + share * way).matrix());
    return number;
  }

  const GridBlock& block_;
  const Eigen::Vector3d& origin_;
  double cell_;
  int x_ = 0, y_ = 0, z_ = 0;
  std::array<std::uint32_t, 8 * GridBlock::kPoints * GridBlock::kPoints * GridBlock::kPoints> number_;
};

}  // namespace

ContourPart contour(const GridBlock& block, const Eigen::Vector3d& origin, double cell) {
  Contouring contouring(block, origin, cell);
  for (int z = 0; z < GridBlock::kCubes; ++z) {
    for (int y = 0; y < GridBlock::kCubes; ++y) {
      for (int x = 0; x < GridBlock::kCubes; ++x) contouring.cube(x, y, z);
    }
  }
  return std::move(contouring.part);
}

TriangleMesh joined(const std::vector<ContourPart>& parts) {
  std::vector<std::uint64_t> edges;
  for (const ContourPart& part : parts) edges.insert(edges.end(), part.edges.begin(), part.edges.end());
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  TriangleMesh mesh;
  mesh.vertices.resize(edges.size());
  std::vector<std::uint32_t> number;
  for (const ContourPart& part : parts) {
    number.clear();
    for (std::size_t i = 0; i < part.edges.size(); ++i) {
      const auto place = std::lower_bound(edges.begin(), edges.end(), part.edges[i]) - edges.begin();
      number.push_back(static_cast<std::uint32_t>(place));
      mesh.vertices[number.back()] = part.vertices[i];
    }
    for (const auto& [a, b, c] : part.triangles) {
      mesh.triangles.push_back({number[a], number[b], number[c]});
    }
  }
  return mesh;
}

}  // namespace cable_variation
