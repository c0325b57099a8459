#include "scene/svg_path_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "geometry/angle.h"
#include "scene/svg_arc.h"
#include "scene/svg_number.h"

namespace rinceau {

namespace {

constexpr std::string_view command_letters = "MmLlHhVvCcSsQqTtAaZz";

bool is_command(char c) { return c != '\0' && command_letters.find(c) != std::string_view::npos; }
bool starts_number(char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+'; }
bool is_relative(char command) { return command >= 'a'; }
char upper(char command) { return is_relative(command) ? static_cast<char>(command - 'a' + 'A') : command; }

std::size_t argument_count(char kind) {
    switch (kind) {
        case 'H':
        case 'V':
            return 1;
        case 'C':
            return 6;
        case 'S':
        case 'Q':
            return 4;
        case 'A':
            return 7;
        default:
            return 2;
    }
}

using Arguments = std::array<double, 7>;

bool in_range(Point p) { return std::abs(p.x) <= largest_coordinate && std::abs(p.y) <= largest_coordinate; }
bool in_range(const Segment& piece) { return in_range(piece.control1) && in_range(piece.control2) && in_range(piece.to); }

// Draws the commands with absolute points; knows what "current point", smooth curves and closing need.
class Pen {
  public:
    Point at() const { return at_; }
    /// Was a command left out that goes beyond the largest coordinate, by a mirrored control point or an arc's bulge?
    bool lost_one() const { return lost_one_; }
    void move(Point to) {
        finish();
        at_ = path_.start = to;
        previous_ = 'M';
    }
    void close() {
        open_ = true;
        path_.closed = true;
        const Point start = path_.start;
        finish();
        at_ = path_.start = start;
        previous_ = 'Z';
    }
    void line(Point to) { add(std::array{line_to(to)}, 'L'); }
    void curve(Point control1, Point control2, Point to) {
        handle_ = control2;
        add(std::array{curve_to(control1, control2, to)}, 'C');
    }
    void quadratic(Point control, Point to) {
        handle_ = control;
        add(std::array{curve_to(at_ + 2.0 / 3 * (control - at_), to + 2.0 / 3 * (control - to), to)}, 'Q');
    }
    void arc(Point radii, double rotation, bool large, bool sweep, Point to) {
        add(arc_segments(at_, radii, rotation, large, sweep, to), 'A');
    }
    /// The control point of a smooth curve after a curve of this kind: the last one mirrored, else the current point.
    Point smooth_control(char kind) const { return previous_ == kind ? 2 * at_ - handle_ : at_; }
    std::vector<Path> take() {
        finish();
        return std::move(paths_);
    }
    std::vector<std::pair<std::size_t, std::size_t>> take_arc_joints() { return std::move(arc_joints_); }

  private:
    /// All pieces of one command, or none.
    void add(std::span<const Segment> pieces, char kind) {
        lost_one_ = lost_one_ || !std::ranges::all_of(pieces, [](const Segment& piece) { return in_range(piece); });
        if (lost_one_) return;
        open_ = true;
        for (const Segment& piece : pieces) {
            if (&piece != &pieces.front()) arc_joints_.emplace_back(paths_.size(), path_.segments.size() - 1);
            path_.segments.push_back(piece);
        }
        at_ = path_.segments.back().to;
        previous_ = kind;
    }
    void finish() {
        if (open_) paths_.push_back(std::move(path_));
        path_ = {};
        open_ = false;
    }

    std::vector<Path> paths_;
    std::vector<std::pair<std::size_t, std::size_t>> arc_joints_;
    Path path_;
    bool open_ = false;  // path_ has something to draw
    bool lost_one_ = false;
    Point at_;
    Point handle_;  // last control point of the curve before
    char previous_ = 'M';
};

void draw(Pen& pen, char command, const Arguments& a) {
    const Point origin = is_relative(command) ? pen.at() : Point{};
    const auto point = [&](std::size_t i) { return origin + Point{a[i], a[i + 1]}; };
    switch (upper(command)) {
        case 'M':
            pen.move(point(0));
            break;
        case 'L':
            pen.line(point(0));
            break;
        case 'H':
            pen.line({origin.x + a[0], pen.at().y});
            break;
        case 'V':
            pen.line({pen.at().x, origin.y + a[0]});
            break;
        case 'C':
            pen.curve(point(0), point(2), point(4));
            break;
        case 'S':
            pen.curve(pen.smooth_control('C'), point(0), point(2));
            break;
        case 'Q':
            pen.quadratic(point(0), point(2));
            break;
        case 'T':
            pen.quadratic(pen.smooth_control('Q'), point(0));
            break;
        case 'A':
            pen.arc({a[0], a[1]}, radians(a[2]), a[3] != 0, a[4] != 0, point(5));
            break;
        default:
            break;
    }
}

// The flags of an arc are single digits, which need no separator: "a1 1 0 0140 0".
std::optional<double> read_flag(TextCursor& cursor) {
    if (cursor.peek() != '0' && cursor.peek() != '1') return std::nullopt;
    return cursor.text[cursor.at++] - '0';
}

class PathReader {
  public:
    explicit PathReader(std::string_view text) : cursor_{text} {}

    ParsedPath read() {
        skip_space(cursor_);
        while (!cursor_.at_end() && read_command()) skip_space(cursor_);
        result_.paths = pen_.take();
        result_.arc_joints = pen_.take_arc_joints();
        return std::move(result_);
    }

  private:
    bool fail(std::string expected) {
        result_.faulty = true;
        result_.fault_at = cursor_.at;
        result_.fault = std::move(expected);
        return false;
    }

    bool read_command() {
        const char letter = cursor_.peek();
        if (!is_command(letter)) return fail("expected a path command");
        if (first_ && upper(letter) != 'M') return fail("expected M or m as the first path command");
        first_ = false;
        ++cursor_.at;
        if (upper(letter) == 'Z') {
            pen_.close();
            return true;
        }
        skip_space(cursor_);
        return read_groups(letter);
    }

    // One or more groups of arguments; those after a moveto are linetos.
    bool read_groups(char letter) {
        for (;;) {
            const std::optional<Arguments> arguments = read_arguments(letter);
            if (!arguments) return false;
            draw(pen_, letter, *arguments);
            if (pen_.lost_one()) return fail("expected a curve within 1e15 of the origin");
            if (letter == 'M') letter = 'L';
            if (letter == 'm') letter = 'l';
            const std::size_t end = cursor_.at;
            const bool comma = skip_comma_space(cursor_);
            if (starts_number(cursor_.peek())) continue;
            if (comma) cursor_.at = end;
            return true;
        }
    }

    std::optional<Arguments> read_arguments(char letter) {
        Arguments arguments{};
        const std::size_t count = argument_count(upper(letter));
        const double room =
            largest_coordinate - (is_relative(letter) ? std::max(std::abs(pen_.at().x), std::abs(pen_.at().y)) : 0);
        for (std::size_t i = 0; i < count; ++i) {
            if (i > 0) skip_comma_space(cursor_);
            const std::size_t start = cursor_.at;
            const bool is_flag = count == 7 && (i == 3 || i == 4);
            const std::optional<double> value = is_flag ? read_flag(cursor_) : read_number(cursor_);
            if (value && std::abs(*value) <= room) {
                arguments[i] = *value;
                continue;
            }
            cursor_.at = start;
            fail(is_flag                         ? "expected a flag, 0 or 1"
                 : starts_number(cursor_.peek()) ? "number out of range"
                                                 : "expected a number");
            return std::nullopt;
        }
        return arguments;
    }

    TextCursor cursor_;
    ParsedPath result_;
    Pen pen_;
    bool first_ = true;
};

}  // namespace

ParsedPath parse_path_data(std::string_view text) { return PathReader(text).read(); }

}  // namespace rinceau
