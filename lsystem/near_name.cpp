#include "lsystem/near_name.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace rinceau {

namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// Levenshtein's distance, row by row.
std::size_t edits_between(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& known) {
    std::string nearest;
    std::size_t fewest = std::max(name.size() / 3, std::size_t{1}) + 1;
    if (name.size() < 2) fewest = 1;  // any letter is near any other: the case only
    for (const std::string& candidate : known) {
        const std::size_t edits = edits_between(name, candidate);
        if (edits >= fewest) continue;
        fewest = edits;
        nearest = candidate;
    }
    return nearest;
}

std::string instead_of(const std::string& name, const std::vector<std::string>& known) {
    const std::string nearest = nearest_name(name, known);
    if (!nearest.empty()) return ": did you mean '" + nearest + "'?";
    if (known.empty()) return "";
    constexpr std::size_t most_listed = 12;
    std::string text = ": there is ";
    const std::size_t listed = std::min(known.size(), most_listed);
    for (std::size_t i = 0; i < listed; ++i) text += (i == 0 ? "" : ", ") + known[i];
    if (listed < known.size()) text += " and " + std::to_string(known.size() - listed) + " more";
    return text;
}

}  // namespace rinceau
