// Jobard & Lefer 1997. On a surface the place beside a line is found by a straight walk across it.

#include "growth/surface/streamlines.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <unordered_map>

#include "geometry/angle.h"

namespace rinceau {
namespace {

constexpr double default_share = 1.0 / 64;  // of the diagonal
constexpr double sample_share = 0.25;       // of the spacing between samples of a line
constexpr double seed_share = 0.98;         // of the spacing: a new line may begin so near to others
constexpr double sheets_agree = 0.3;        // cosine between normals: the other side of a thin sheet is far
constexpr double lines_agree = 0.7071;      // cosine between lines: those across do not hinder
constexpr double close_turn = 5;            // degrees by which a closed line may miss its own direction
constexpr double own_share = 3;             // of the test distance along a line: so far back it does not hinder itself

struct Sample {
    SpacePoint place, normal, direction;
    SurfacePoint at;
    Complex way;
    int line = 0;
    double along = 0;  ///< from the line's seed, negative backwards
};

/// Samples by cells in space. Only asked whether some are near: no order comes from it.
class SampleGrid {
  public:
    explicit SampleGrid(double cell) : cell_(cell) {}

    void add(const Sample& sample) { cells_[key(index(sample.place))].push_back(sample); }

    /// Takes back the samples of a line that is left out.
    void remove(const std::vector<Sample>& samples) {
        for (const Sample& sample : samples)
            std::erase_if(cells_[key(index(sample.place))], [&](const Sample& s) { return s.line == sample.line; });
    }

    /// Is no sample within the distance (not above a cell) but those of its own line nearby?
    bool is_free(const Sample& sample, double distance) const {
        const auto middle = index(sample.place);
        for (long dx = -1; dx <= 1; ++dx)
            for (long dy = -1; dy <= 1; ++dy)
                for (long dz = -1; dz <= 1; ++dz) {
                    const auto found = cells_.find(key({middle[0] + dx, middle[1] + dy, middle[2] + dz}));
                    if (found == cells_.end()) continue;
                    for (const Sample& other : found->second)
                        if (hinders(other, sample, distance)) return false;
                }
        return true;
    }

  private:
    static bool hinders(const Sample& other, const Sample& sample, double distance) {
        if (other.line == sample.line && std::abs(other.along - sample.along) < own_share * distance) return false;
        const SpacePoint way = other.place - sample.place;
        return dot(way, way) < distance * distance && dot(other.normal, sample.normal) > sheets_agree &&
               std::abs(dot(other.direction, sample.direction)) > lines_agree;
    }
    std::array<long, 3> index(SpacePoint p) const {
        return {std::lround(std::floor(p.x / cell_)), std::lround(std::floor(p.y / cell_)),
                std::lround(std::floor(p.z / cell_))};
    }
    static std::uint64_t key(const std::array<long, 3>& cell) {
        // cells that share a key are only looked through in vain
        std::uint64_t mixed = 0;
        for (const long i : cell) mixed = mixed * 0x9E3779B97F4A7C15u + static_cast<std::uint64_t>(i) + 1;
        return mixed;
    }

    double cell_;
    std::unordered_map<std::uint64_t, std::vector<Sample>> cells_;
};

/// One half of a line: from its seed in one direction.
struct HalfLine {
    std::vector<SurfacePoint> path;
    std::vector<Sample> samples;  ///< without the seed's
    double length = 0;
    bool closed = false;
};

class StreamlineDrawing {
  public:
    StreamlineDrawing(const FieldOnSurface& field, const StreamlineOptions& options)
        : field_(field),
          surface_(field.surface()),
          options_(options),
          spacing_(options.spacing > 0 ? options.spacing : default_share * surface_.diagonal),
          grid_(spacing_) {
        drawn_.spacing = spacing_;
    }

    Streamlines draw(const Progress& progress) &&;

  private:
    Sample sample_at(SurfacePoint at, Complex way, double along) const;
    void seed(SurfacePoint at, Complex way, bool minor);
    void seed_beside(const Sample& sample, bool minor);
    HalfLine half_line(const Sample& seed, double sign);
    std::optional<SurfaceTrace> way_to_seed(const Sample& first, const Sample& sample) const;
    void take(const Sample& seed, HalfLine forth, HalfLine back, bool minor);
    bool full() const { return samples_ >= options_.max_samples; }

    const FieldOnSurface& field_;
    const SurfaceMesh& surface_;
    StreamlineOptions options_;
    double spacing_;
    SampleGrid grid_;
    std::deque<Sample> queue_;
    long samples_ = 0;
    int next_line_ = 0;
    Streamlines drawn_;
};

Sample StreamlineDrawing::sample_at(SurfacePoint at, Complex way, double along) const {
    return {position_in_space(surface_, at),
            normal_at(surface_, at),
            direction_in_space(surface_, at.face, way),
            at,
            way,
            next_line_,
            along};
}

/// The rest of the way, if the line has come back to its seed: with little to the side, in its direction.
std::optional<SurfaceTrace> StreamlineDrawing::way_to_seed(const Sample& first, const Sample& sample) const {
    const SpacePoint way = first.place - sample.place;
    const double rest = dot(way, sample.direction);
    if (std::abs(sample.along) < spacing_ || rest < 0 || dot(first.normal, sample.normal) < sheets_agree)
        return std::nullopt;
    if (rest > (options_.nearest + sample_share) * spacing_) return std::nullopt;
    const SurfaceTrace walk = trace(surface_, &field_, sample.at, sample.way, rest, {.jump = 0, .keep_path = true});
    const SpacePoint direction = direction_in_space(surface_, walk.end.face, walk.direction);
    // in the seed's tangent plane, as faces are bent against each other
    const SpacePoint flat = unit(direction - dot(direction, first.normal) * first.normal);
    const SpacePoint ahead = unit(first.direction - dot(first.direction, first.normal) * first.normal);
    const double gap = abs(position_in_space(surface_, walk.end) - first.place);
    if (gap > sample_share / 2 * spacing_ || dot(flat, ahead) < std::cos(radians(close_turn))) return std::nullopt;
    return walk;
}

HalfLine StreamlineDrawing::half_line(const Sample& seed, double sign) {
    HalfLine half;
    half.path.push_back(seed.at);
    Sample first = seed;
    first.way = sign * seed.way;
    first.direction = sign * seed.direction;
    Sample last = first;
    const double step = sample_share * spacing_;
    while (!full()) {
        const SurfaceTrace walk = trace(surface_, &field_, last.at, last.way, step, {.jump = 0, .keep_path = true});
        const Sample next = sample_at(walk.end, walk.direction, last.along + sign * walk.length);
        const bool free = grid_.is_free(next, options_.nearest * spacing_);
        const auto rest = free ? std::nullopt : way_to_seed(first, next);
        if (!free && !rest) break;
        half.path.insert(half.path.end(), walk.path.begin() + 1, walk.path.end());
        if (rest) {
            half.path.insert(half.path.end(), rest->path.begin() + 1, rest->path.end());
            half.path.push_back(seed.at);
            half.closed = true;
            break;
        }
        half.length += walk.length;
        half.samples.push_back(next);
        grid_.add(next);
        ++samples_;
        if (walk.at_border || walk.length < step / 2) break;
        last = next;
    }
    return half;
}

void StreamlineDrawing::take(const Sample& seed, HalfLine forth, HalfLine back, bool minor) {
    const bool closed = forth.closed;
    ++next_line_;
    if (!closed && forth.length + back.length < options_.shortest * spacing_) {
        grid_.remove({seed});
        grid_.remove(forth.samples);
        grid_.remove(back.samples);
        return;
    }
    Streamline line{{}, closed, minor};
    line.path.assign(back.path.rbegin(), back.path.rend());
    line.path.insert(line.path.end(), forth.path.begin() + (back.path.empty() ? 0 : 1), forth.path.end());
    drawn_.lines.push_back(std::move(line));
    queue_.push_back(seed);
    for (const HalfLine* half : {&forth, &back})
        for (const Sample& sample : half->samples) queue_.push_back(sample);
}

/// A line through the place, if it is not too near to others.
void StreamlineDrawing::seed(SurfacePoint at, Complex way, bool minor) {
    const Sample seed = sample_at(at, way, 0);
    if (full() || !grid_.is_free(seed, seed_share * spacing_)) return;
    grid_.add(seed);
    ++samples_;
    HalfLine forth = half_line(seed, 1);
    HalfLine back = forth.closed ? HalfLine{} : half_line(seed, -1);
    take(seed, std::move(forth), std::move(back), minor);
}

void StreamlineDrawing::seed_beside(const Sample& sample, bool minor) {
    for (const Complex across : {Complex{0, 1}, Complex{0, -1}}) {
        const SurfaceTrace walk = trace(surface_, nullptr, sample.at, sample.way * across, spacing_);
        if (walk.at_border) continue;
        const Complex line = walk.direction * conj(across), along = minor ? line * Complex{0, -1} : line;
        const Complex root = root_near(field_.at(walk.end), field_.n(), along);
        seed(walk.end, minor ? root * Complex{0, 1} : root, minor);
    }
}

Streamlines StreamlineDrawing::draw(const Progress& progress) && {
    const bool crosses = field_.n() == 4;
    for (int f = 0; f < surface_.faces(); ++f) {
        if (f % 1024 == 0) report(progress, "streamlines", static_cast<double>(f) / surface_.faces());
        const SurfacePoint middle = from_barycentric(surface_, f, {1.0 / 3, 1.0 / 3, 1.0 / 3});
        const Complex root = root_near(field_.at(middle), field_.n(), {1, 0});
        for (const bool minor : {false, true}) {
            if (!crosses && !(minor ? options_.minor : options_.major)) continue;
            seed(middle, minor ? root * Complex{0, 1} : root, minor && !crosses);
            while (!queue_.empty() && !full()) {
                const Sample sample = queue_.front();
                queue_.pop_front();
                seed_beside(sample, minor && !crosses);
            }
            queue_.clear();
        }
    }
    drawn_.complete = !full();
    report(progress, "streamlines", 1);
    return std::move(drawn_);
}

}  // namespace

Streamlines streamlines(const FieldOnSurface& field, const StreamlineOptions& options, const Progress& progress) {
    return StreamlineDrawing(field, options).draw(progress);
}

}  // namespace rinceau
