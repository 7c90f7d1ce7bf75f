// CGAL's box_self_intersection_d behind a C interface: boxes in, pairs of their indices out.
//
// The box type is as small as CGAL allows, an explicit id and the corners, and is made of the given corners in
// each call, as a caller would have to. The pairs stay in a vector that keeps its memory from call to call.

#include <CGAL/box_intersection_d.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace {

template <int D>
struct IndexedBox {
    std::array<float, D> mins;
    std::array<float, D> maxs;
    std::uint32_t index;
};

template <int D>
struct Traits {
    using Box_parameter = const IndexedBox<D>&;
    using NT = float;
    using ID = std::uint32_t;

    static NT min_coord(Box_parameter box, int axis) { return box.mins[axis]; }
    static NT max_coord(Box_parameter box, int axis) { return box.maxs[axis]; }
    static ID id(Box_parameter box) { return box.index; }
    static int dimension() { return D; }
};

struct Pair {
    std::uint32_t first;
    std::uint32_t second;
};

struct Finder {
    std::vector<IndexedBox<2>> boxes2;
    std::vector<IndexedBox<3>> boxes3;
    std::vector<Pair> pairs;
};

template <int D>
void find_pairs(std::vector<IndexedBox<D>>& boxes, std::vector<Pair>& pairs, const float* corners,
                std::size_t count, std::ptrdiff_t cutoff) {
    boxes.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::memcpy(boxes[i].mins.data(), corners + 2 * D * i, sizeof boxes[i].mins);
        std::memcpy(boxes[i].maxs.data(), corners + 2 * D * i + D, sizeof boxes[i].maxs);
        boxes[i].index = static_cast<std::uint32_t>(i);
    }
    pairs.clear();
    const auto report = [&pairs](const IndexedBox<D>& a, const IndexedBox<D>& b) {
        pairs.push_back({a.index, b.index});
    };
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), report, Traits<D>(), cutoff,
                                  CGAL::Box_intersection_d::CLOSED);
}

}  // namespace

extern "C" {

Finder* peers_cgal_new() {
    try {
        return new Finder;
    } catch (...) {
        return nullptr;
    }
}

void peers_cgal_delete(Finder* finder) { delete finder; }

// Whether it was done: not if memory ran out or the dimension is neither 2 nor 3. The pairs are valid until the
// next call with this finder.
bool peers_cgal_find_pairs(Finder* finder, std::size_t dimension, const float* corners, std::size_t count,
                           std::ptrdiff_t cutoff, const Pair** pairs, std::size_t* pair_count) {
    // An exception must not leave C++.
    try {
        switch (dimension) {
            case 2:
                find_pairs<2>(finder->boxes2, finder->pairs, corners, count, cutoff);
                break;
            case 3:
                find_pairs<3>(finder->boxes3, finder->pairs, corners, count, cutoff);
                break;
            default:
                return false;
        }
    } catch (...) {
        return false;
    }
    *pairs = finder->pairs.data();
    *pair_count = finder->pairs.size();
    return true;
}

}  // extern "C"
