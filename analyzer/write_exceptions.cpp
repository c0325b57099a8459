#include "analyzer/production_writer.h"

namespace rinceau {

namespace {

struct Collector {
    const WritingContext& context;
    std::vector<Exception> exceptions;
    std::string last_comment = {};

    const Item& item(int i) const { return context.rules.items[static_cast<std::size_t>(i)]; }

    /// `pose` is where the rules have the item's part. Each child is one symbol of its own, in their order.
    void collect(int i, const Similarity& pose, std::vector<int>& address) {
        int number = 0;
        collect_children(i, pose, address, number);
    }

    void collect_children(int i, const Similarity& pose, std::vector<int>& address, int& number) {
        const Item& at = item(i);
        const std::vector<Child>& children = context.part(at.part).children;
        for (std::size_t k = 0; k < at.members.size(); ++k) {
            const Similarity place = pose * children[k].pose;
            if (context.part(children[k].part).rule == context.part(at.part).rule) {  // a call of itself: numbers go on
                collect_tree(children[k].part, at.members[k], place, address, number);
                continue;
            }
            address.push_back(++number);
            if (is_regular(context.rules, at, k)) {
                collect(at.members[k], place, address);
            } else {
                except(children[k].part, at.members[k], place * gauge_of(at.part, k), address);
            }
            address.pop_back();
        }
    }

    /// How the production turns a terminal that looks the same when it is turned.
    Similarity gauge_of(int part, std::size_t child) const {
        const RuleKind kind = context.rule_of(part).kind;
        if (kind == RuleKind::sequence) return context.anchors.gauge_of_rule[static_cast<std::size_t>(context.part(part).rule)];
        if (kind != RuleKind::group && kind != RuleKind::ring) return {};
        const std::vector<Child>& children = context.part(part).children;
        const Child& written = kind == RuleKind::ring ? children.front() : children[child];
        const Similarity pose = inverse(context.anchor(part)) * written.pose * context.anchor(written.part);
        return least_turning_gauge(context, pose, written.part);
    }

    /// What several in a row have in common is said once.
    void add(Exception exception, const std::string& comment) {
        if (comment != last_comment) exception.comment = comment;
        last_comment = comment;
        exceptions.push_back(std::move(exception));
    }

    void collect_tree(int part, int member, const Similarity& place, std::vector<int>& address, int& number) {
        if (member >= 0) {
            collect_children(member, place, address, number);
            return;
        }
        for (const Child& child : context.part(part).children) {
            if (context.part(child.part).rule == context.part(part).rule) {
                collect_tree(child.part, -1, {}, address, number);
                continue;
            }
            address.push_back(++number);
            except(child.part, -1, {}, address);
            address.pop_back();
        }
    }

    void except(int part, int member, const Similarity& place, std::vector<int>& address) {
        Exception exception;
        exception.address = address;
        if (member < 0) {
            add(std::move(exception), "no " + context.symbol(part) + " here");
            return;
        }
        const Item& instead = item(member);
        const Similarity turtle = place * context.anchor(part);
        append_placed(context, exception.successor, inverse(turtle) * instead.pose * context.anchor(instead.part), instead.part,
                      scale_of(turtle), false);
        const std::string& name = context.symbol(instead.part);
        add(std::move(exception), name == context.symbol(part) ? "only a part of this " + name
                                                               : name + " instead of " + context.symbol(part));
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
