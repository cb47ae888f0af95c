#include "core/building/box_index.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace farol::building {

namespace {

constexpr std::size_t kFanOut = 12;

Box2 joined(const Box2& a, const Box2& b) {
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

} // namespace

Box2 grown(const Box2& box, double by) {
    return {{box.low.x - by, box.low.y - by}, {box.high.x + by, box.high.y + by}};
}

bool meet(const Box2& a, const Box2& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

BoxIndex::BoxIndex(const std::vector<Box2>& boxes) : m_items(boxes.size()) {
    std::iota(m_items.begin(), m_items.end(), std::size_t{0});
    auto byX = [&](std::size_t a, std::size_t b) {
        return boxes[a].low.x + boxes[a].high.x < boxes[b].low.x + boxes[b].high.x;
    };
    auto byY = [&](std::size_t a, std::size_t b) {
        return boxes[a].low.y + boxes[a].high.y < boxes[b].low.y + boxes[b].high.y;
    };
    std::stable_sort(m_items.begin(), m_items.end(), byX);
    double leaves = std::ceil(static_cast<double>(boxes.size()) / kFanOut);
    std::size_t slice = static_cast<std::size_t>(std::ceil(std::sqrt(std::max(1.0, leaves)))) * kFanOut;
    for (std::size_t at = 0; at < m_items.size(); at += slice)
        std::stable_sort(m_items.begin() + static_cast<std::ptrdiff_t>(at),
                         m_items.begin() + static_cast<std::ptrdiff_t>(std::min(at + slice, m_items.size())),
                         byY);
    for (std::size_t item : m_items) m_boxes.push_back(boxes[item]);
    auto addRow = [this](std::size_t from, std::size_t to, bool leaf) {
        for (std::size_t at = from; at < to; at += kFanOut) {
            Node node{{}, at, std::min(at + kFanOut, to), leaf};
            for (std::size_t i = node.first; i < node.last; ++i) {
                const Box2& box = leaf ? m_boxes[i] : m_nodes[i].box;
                node.box = i == node.first ? box : joined(node.box, box);
            }
            m_nodes.push_back(node);
        }
    };
    addRow(0, m_items.size(), true);
    for (std::size_t from = 0, to = m_nodes.size(); to - from > 1; from = to, to = m_nodes.size())
        addRow(from, to, false);
}

std::vector<std::size_t> BoxIndex::meeting(const Box2& box) const {
    std::vector<std::size_t> found, open;
    if (!m_nodes.empty()) open.push_back(m_nodes.size() - 1);
    while (!open.empty()) {
        const Node& node = m_nodes[open.back()];
        open.pop_back();
        if (!meet(node.box, box)) continue;
        for (std::size_t i = node.first; i < node.last; ++i) {
            if (!node.leaf)
                open.push_back(i);
            else if (meet(m_boxes[i], box))
                found.push_back(m_items[i]);
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

} // namespace farol::building
