// A vector register and its ways to memory, for the sources that are compiled once per instruction set, with
// CABLE_VARIATION_WIDTH the doubles of a register. In an unnamed namespace, so that nothing compiled for one
// processor can be linked in place of another's.

namespace cable_variation::element {
namespace {

typedef double Pack
    __attribute__((vector_size(8 * CABLE_VARIATION_WIDTH), aligned(8 * CABLE_VARIATION_WIDTH)));
constexpr int kWidth = CABLE_VARIATION_WIDTH;

inline Pack load(const double* lane) { return *reinterpret_cast<const Pack*>(lane); }
inline void store(double* lane, Pack value) { *reinterpret_cast<Pack*>(lane) = value; }
inline void add(double* lane, Pack value) { store(lane, load(lane) + value); }

// How many rods are worked on, and how many at once: kLanes, as many as a register holds, ...
struct Lanes {
  using Value = Pack;
  static constexpr int kCount = kLanes, kStep = kWidth;
};
// ... or one.
struct Alone {
  using Value = double;
  static constexpr int kCount = 1, kStep = 1;
};
template <class Of>
inline typename Of::Value get(const double* lane) {
  return *reinterpret_cast<const typename Of::Value*>(lane);
}
template <class Of>
inline void put(double* lane, typename Of::Value value) {
  *reinterpret_cast<typename Of::Value*>(lane) = value;
}

// Of a lower triangle.
constexpr int packed(int row, int column) { return row * (row + 1) / 2 + column; }

}  // namespace
}  // namespace cable_variation::element
