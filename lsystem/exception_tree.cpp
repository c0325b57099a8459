#include "lsystem/exception_tree.h"

namespace rinceau {

ExceptionTree::ExceptionTree(const std::vector<Exception>& exceptions) {
    for (std::size_t i = 0; i < exceptions.size(); ++i) {
        int node = 0;
        for (const int number : exceptions[i].address) {
            const auto [place, added] = children_.try_emplace(key(node, number), static_cast<int>(exceptions_.size()));
            if (added) exceptions_.push_back(none);
            node = place->second;
        }
        if (node != 0) exceptions_[static_cast<std::size_t>(node)] = static_cast<int>(i);
    }
}

}  // namespace rinceau
