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

// Of a lower triangle.
constexpr int packed(int row, int column) { return row * (row + 1) / 2 + column; }

}  // namespace
}  // namespace cable_variation::element
