#include "lsystem/similar_name.h"

#include <algorithm>
#include <array>

namespace rinceau {

namespace {

constexpr std::size_t longest = 64;  // longer names are no slips of the finger

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::size_t length_difference(std::string_view a, std::string_view b) {
    return a.size() > b.size() ? a.size() - b.size() : b.size() - a.size();
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b, int most) {
    const int more = most + 1;
    if (a.size() > longest || b.size() > longest || length_difference(a, b) > static_cast<std::size_t>(most)) return more;
    using Row = std::array<int, longest + 1>;
    std::array<Row, 3> rows{};  // of the beginnings of a, the last three
    for (std::size_t j = 0; j <= b.size(); ++j) rows[0][j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        Row& row = rows[i % 3];
        const Row& above = rows[(i + 2) % 3];
        const Row& before = rows[(i + 1) % 3];
        row[0] = static_cast<int>(i);
        int least = row[0];
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0 : 1)});
            const bool exchanged =
                i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
            if (exchanged) row[j] = std::min(row[j], before[j - 2] + 1);
            least = std::min(least, row[j]);
        }
        if (least > more) return more;
    }
    return std::min(rows[a.size() % 3][b.size()], more);
}

std::string_view similar_name(std::string_view name, const std::vector<std::string_view>& names) {
    constexpr std::size_t short_name = 4;
    int most = name.size() <= 1 ? 0 : name.size() <= short_name ? 1 : 2;
    std::string_view best;
    for (const std::string_view candidate : names) {
        if (candidate == name) continue;
        const int distance = edit_distance(name, candidate, most);
        if (distance > most) continue;
        best = candidate;
        if (distance == 0) break;
        most = distance - 1;
    }
    return best;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& names) {
    const std::string_view meant = similar_name(name, names);
    return meant.empty() ? "" : " (did you mean '" + std::string(meant) + "'?)";
}

std::string instead_of(std::string_view name, const std::vector<std::string>& known) {
    const std::string_view meant = similar_name(name, {known.begin(), known.end()});
    if (!meant.empty()) return ": did you mean '" + std::string(meant) + "'?";
    if (known.empty()) return "";
    constexpr std::size_t most_listed = 12;
    const std::size_t listed = std::min(known.size(), most_listed);
    std::string text = ": there is ";
    for (std::size_t i = 0; i < listed; ++i) text += (i == 0 ? "" : ", ") + known[i];
    if (listed < known.size()) text += " and " + std::to_string(known.size() - listed) + " more";
    return text;
}

}  // namespace rinceau
