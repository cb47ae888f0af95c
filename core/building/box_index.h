#pragma once
// Boxes found by place: a packed R-tree (sort-tile-recursive). Built once; memory and building time stay in
// proportion to the number of boxes however they lie.

#include "core/base/geometry.h"

#include <cstddef>
#include <vector>

namespace farol::building {

class BoxIndex {
public:
    BoxIndex() = default;
    explicit BoxIndex(const std::vector<Box2>& boxes);
    /// Indices of the boxes that meet `box`, ascending.
    std::vector<std::size_t> meeting(const Box2& box) const;

private:
    struct Node {
        Box2 box;
        std::size_t first = 0, last = 0; ///< children, or items of a leaf
        bool leaf = true;
    };
    std::vector<std::size_t> m_items;
    std::vector<Box2> m_boxes; ///< in the order of m_items
    std::vector<Node> m_nodes; ///< leaves first, the root last
};

Box2 grown(const Box2& box, double by);
bool meet(const Box2& a, const Box2& b);

} // namespace farol::building
