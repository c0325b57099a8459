#pragma once
// What is edited: one value. Its large parts are shared between versions and never changed in place.

#include <map>
#include <memory>
#include <set>
#include <string>

#include "analyzer/analyze.h"
#include "lsystem/derive.h"
#include "lsystem/grammar.h"
#include "scene/element.h"

namespace rinceau {

/// Texts of the files that a grammar uses, by the names under which resolve_uses() asks for them.
using UsedFiles = std::map<std::string, std::string>;

struct Document {
    std::shared_ptr<const Scene> drawing;          ///< in which the grammar was found; null if it was opened as a grammar
    std::shared_ptr<const Grammar> grammar;        ///< as it is written, uses kept; never null
    std::shared_ptr<const Grammar> resolved;       ///< for drawing: with all that it uses; never null
    std::shared_ptr<const UsedFiles> used;         ///< null if it uses none
    std::shared_ptr<const AnalysisReport> report;  ///< of the analysis that found the grammar; null if none did
    AnalyzeOptions analysis;                       ///< with which the drawing was, and will be, analysed
    DeriveOptions derive;                          ///< depth and seed that are looked at
    std::set<std::string> locked;                  ///< names of numbers (lsystem/numbers.h) that edits leave alone
    std::shared_ptr<const Grammar> origin;         ///< as it was opened or last analysed: what numbers are reset to; or null
};

/// A document that holds nothing: an empty grammar.
Document empty_document();

/// The document with another grammar. Throws as resolve_uses().
Document with_grammar(const Document& document, Grammar grammar);

/// Was the grammar edited since it was opened or found by an analysis?
bool rules_were_edited(const Document& document);

/// All but the number of threads, which changes nothing.
bool same_analysis(const AnalyzeOptions& a, const AnalyzeOptions& b);

/// The same versions of grammar and drawing, and equal options and locks: quick, for every frame.
bool same_version(const Document& a, const Document& b);

/// The same content: grammars and options compare by what they say, drawings and reports by identity.
bool same_document(const Document& a, const Document& b);

}  // namespace rinceau
