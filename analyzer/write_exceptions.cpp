#include "analyzer/production_writer.h"

namespace rinceau {

namespace {

struct Collector {
    const WritingContext& context;
    std::vector<Exception> exceptions;

    const Item& item(int i) const { return context.rules.items[static_cast<std::size_t>(i)]; }

    /// `pose` is where the rules have the item's part. Each child is one symbol of its own, in their order.
    void collect(int i, const Similarity& pose, std::vector<int>& address) {
        const Item& at = item(i);
        const std::vector<Child>& children = context.part(at.part).children;
        for (std::size_t k = 0; k < at.members.size(); ++k) {
            address.push_back(static_cast<int>(k) + 1);
            const Similarity place = pose * children[k].pose;
            if (is_regular(context.rules, at, k)) {
                collect(at.members[k], place, address);
            } else {
                except(children[k].part, at.members[k], place, address);
            }
            address.pop_back();
        }
    }

    void except(int part, int member, const Similarity& place, std::vector<int>& address) {
        Exception exception;
        exception.address = address;
        exception.comment = "no " + context.symbol(part) + " here";
        if (member < 0) {
            exceptions.push_back(std::move(exception));
            return;
        }
        const Item& instead = item(member);
        const Similarity turtle = place * context.anchor(part);
        exception.comment = context.symbol(instead.part) + " instead of " + context.symbol(part);
        append_placed(context, exception.successor, inverse(turtle) * instead.pose * context.anchor(instead.part), instead.part,
                      scale_of(turtle), false);
        exceptions.push_back(std::move(exception));
        collect(member, instead.pose, address);  // its module takes over the address
    }
};

}  // namespace

std::vector<Exception> write_exceptions(const WritingContext& context, int root, int number, const Similarity& pose) {
    Collector collector{context, {}};
    std::vector<int> address{number};
    collector.collect(root, pose, address);
    return std::move(collector.exceptions);
}

}  // namespace rinceau
