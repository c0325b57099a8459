#include "analyzer/production_writer.h"
#include "analyzer/rule_comment.h"

namespace rinceau {

WrittenRule write_group(const WritingContext& context, int p) {
    const Part& part = context.part(p);
    Production production;
    production.symbol = context.symbol(p);
    production.comment = rule_comment(context.rules, part, context.symbols, context.uses);
    const Similarity to_turtle = inverse(context.anchor(p));
    for (const Child& child : part.children) {
        append_placed(context, production.successor, to_turtle * child.pose * context.anchor(child.part), child.part,
                      context.turtle_scale(p), true);
    }
    return {{std::move(production)}, {}};
}

}  // namespace rinceau
