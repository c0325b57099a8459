// Everything that docs/growth.md promises, measured: one line a figure with its bar, and whether it holds. Exit status 1 if
// one does not. Usage: growth_bench CORPUS_FOLDER [--csv] [--only NAME] [--pictures FOLDER] [--skip-speed] CORPUS_FOLDER
// holds arrangement/*.svg (exemplars) and shapes/*.svg (silhouettes).

#include "growth_bench.h"

#include <filesystem>
#include <fstream>

#include "growth/measure/outline_overlaps.h"

namespace rinceau::test {
namespace {

constexpr double picture_size = 1200;

void write_outlines(const std::string& file, const Box& box, const std::vector<std::pair<Region, int>>& outlines) {
    std::ofstream out(file);
    const double size = std::max(width(box), height(box));
    out << "<svg xmlns='http://www.w3.org/2000/svg' width='" << picture_size << "' height='" << picture_size << "' viewBox='"
        << box.low.x << ' ' << -box.high.y << ' ' << width(box) << ' ' << height(box) << "'>\n<rect x='" << box.low.x
        << "' y='" << -box.high.y << "' width='" << width(box) << "' height='" << height(box) << "' fill='white'/>\n";
    constexpr const char* colors[] = {"#3b6ea8", "#c8553d", "#5a8f4e", "#8a5aa8", "#c09a2f", "#4a9c9c"};
    for (const auto& [region, kind] : outlines) {
        out << "<path fill-rule='evenodd' stroke='black' fill-opacity='0.7' stroke-width='" << size / 4000 << "' fill='"
            << colors[static_cast<std::size_t>(kind) % std::size(colors)] << "' d='";
        for (const auto& ring : region)
            for (std::size_t i = 0; i < ring.size(); ++i) out << (i == 0 ? " M" : " L") << ring[i].x << ' ' << -ring[i].y;
        out << " Z'/>\n";
    }
    out << "</svg>\n";
}

std::string file_of(const std::string& folder, std::string name) {
    for (char& c : name)
        if (c == ' ' || c == ',' || c == '%') c = '_';
    std::filesystem::create_directories(folder);
    return (std::filesystem::path(folder) / (name + ".svg")).string();
}

}  // namespace

void GrowthPictures::draw(const std::string& name, const Exemplar& exemplar, const ElementArrangement& arrangement) const {
    if (folder.empty()) return;
    std::vector<std::pair<Region, int>> outlines;
    Box box;
    for (const ArrangedElement& element : arranged_elements(arrangement)) {
        const ExemplarElement& reference = exemplar.elements[static_cast<std::size_t>(element.reference)];
        outlines.emplace_back(placed_region(reference.outline, translate(element.position) * rotate(element.angle)),
                              reference.symbol);
        box = including(box, element.position);
    }
    write_outlines(file_of(folder, name), grown(box, exemplar.mean_edge), outlines);
}

void GrowthPictures::draw(const std::string& name, const ShapeCase& shapes, const std::vector<PlacedRegion>& placed) const {
    if (folder.empty()) return;
    std::vector<std::pair<Region, int>> outlines;
    for (const PlacedRegion& one : placed)
        outlines.emplace_back(placed_region(shapes.regions[static_cast<std::size_t>(one.shape)].rings, one.pose), one.shape);
    write_outlines(file_of(folder, name), {{0, 0}, {shapes.side, shapes.side}}, outlines);
}

}  // namespace rinceau::test

using namespace rinceau::test;

namespace {

struct BenchOptions {
    std::string corpus, only;
    GrowthPictures pictures;
    bool csv = false, speed = true;
};

BenchOptions options_of(const std::vector<std::string>& arguments) {
    BenchOptions options;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& argument = arguments[i];
        const bool value = i + 1 < arguments.size();
        if (argument == "--csv") {
            options.csv = true;
        } else if (argument == "--skip-speed") {
            options.speed = false;
        } else if (argument == "--only" && value) {
            options.only = arguments[++i];
        } else if (argument == "--pictures" && value) {
            options.pictures.folder = arguments[++i];
        } else {
            options.corpus = argument;
        }
    }
    return options;
}

void append(std::vector<ExemplarCase>& cases, std::vector<ExemplarCase> more) {
    for (ExemplarCase& one : more) cases.push_back(std::move(one));
}

}  // namespace

int main(int count, char** values) {
    const BenchOptions options = options_of({values + 1, values + count});
    if (options.corpus.empty()) {
        std::cerr << "usage: growth_bench CORPUS_FOLDER [--csv] [--only NAME] [--pictures FOLDER] [--skip-speed]\n";
        return 2;
    }
    GrowthLines lines(options.csv);
    const std::vector<ExemplarCase> lattices = lattice_cases(), strewn = strewn_cases();
    std::vector<ExemplarCase> regions{lattices[0], lattices[5], lattices[4], strewn[0], strewn[2]};
    std::vector<ExemplarCase> modes{lattices[0], lattices[5], strewn[0], strewn[2]};
    std::vector<ExemplarCase> speeds{lattices[0], lattices[8], strewn[0], strewn[2]};
    std::vector<ExemplarCase> all = lattices;
    append(all, strewn);
    append(all, sample_cases(options.only));
    append(all, drawn_cases(options.corpus + "/arrangement", options.only));
    arrangement_lines(lines, all, options.only, options.pictures);
    arrangement_region_lines(lines, regions, options.only, options.pictures);
    arrangement_mode_lines(lines, modes, options.only, options.pictures);
    if (options.speed) arrangement_speed_lines(lines, speeds, options.only);

    constexpr double shapes = 224;
    aggregate_lines(lines, shape_cases(options.corpus + "/shapes", shapes, options.only), options.only, options.pictures);
    if (options.speed && options.only.empty()) aggregate_speed_lines(lines, options.corpus + "/shapes");
    if (!options.csv) std::cout << '\n' << lines.judgements() << " bars, " << lines.failures() << " failures\n";
    return lines.failures() == 0 ? 0 : 1;
}
