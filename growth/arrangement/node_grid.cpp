// A hash of blocks of 8 x 8 cells with a chain of nodes in each cell: a question looks up one or two blocks and walks the
// cells in rows, and a node that moves changes at most two chains.
#include "growth/arrangement/node_grid.h"

#include <cassert>

namespace rinceau {

int NodeGrid::slot_for(Point p) {
    const CellIndex c = cell_of(p);
    const int blocks = static_cast<int>(blocks_.size());
    const int block = blocks_.find_or_insert(block_key(c), blocks);
    if (block == blocks) heads_.resize(heads_.size() + (std::size_t{1} << (2 * block_bits)), -1);
    return static_cast<int>(slot_in(block, c));
}

void NodeGrid::hook(int node, int slot) {
    Entry& entry = entries_[static_cast<std::size_t>(node)];
    int& head = heads_[static_cast<std::size_t>(slot)];
    entry.slot = slot;
    entry.previous = -1;
    entry.next = head;
    if (head >= 0) entries_[static_cast<std::size_t>(head)].previous = node;
    head = node;
}

void NodeGrid::unhook(int node) {
    const Entry& entry = entries_[static_cast<std::size_t>(node)];
    if (entry.previous >= 0)
        entries_[static_cast<std::size_t>(entry.previous)].next = entry.next;
    else
        heads_[static_cast<std::size_t>(entry.slot)] = entry.next;
    if (entry.next >= 0) entries_[static_cast<std::size_t>(entry.next)].previous = entry.previous;
}

void NodeGrid::insert(int node, Point at) {
    const auto index = static_cast<std::size_t>(node);
    if (index >= entries_.size()) entries_.resize(index + 1);
    assert(entries_[index].slot < 0);
    entries_[index].at = at;
    hook(node, slot_for(at));
}

void NodeGrid::move(int node, Point to) {
    Entry& entry = entries_[static_cast<std::size_t>(node)];
    assert(entry.slot >= 0);
    entry.at = to;
    const int slot = slot_for(to);
    if (slot == entry.slot) return;
    unhook(node);
    hook(node, slot);
}

void NodeGrid::remove(int node) {
    Entry& entry = entries_[static_cast<std::size_t>(node)];
    assert(entry.slot >= 0);
    unhook(node);
    entry.slot = -1;
}

}  // namespace rinceau
