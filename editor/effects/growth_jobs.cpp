#include "editor/effects/growth_jobs.h"

#include <chrono>
#include <utility>

#include "editor/effects/folders.h"
#include "editor/effects/guarded.h"
#include "editor/effects/progress_posts.h"
#include "files/files.h"
#include "growth/aggregate/density_picture_png.h"
#include "growth/strokes.h"
#include "scene/svg_read.h"

namespace rinceau {
namespace {

using Clock = std::chrono::steady_clock;

/// A picture of much takes longer to draw than to grow.
constexpr auto between_looks = std::chrono::milliseconds(150);
/// Of a region's outline, as a share of its drawing's diagonal: finer than is seen.
constexpr double region_deviation = 1e-4;

/// Tells how far work is, and shows what stands by then.
class Watcher {
  public:
    Watcher(std::uint64_t job, GrowthStop stop, const Progress& progress, const Worker::Post& post)
        : job_(job), stop_(std::move(stop)), progress_(progress), post_(post) {}

    GrowthWatch watch() {
        return {.stop = [this] { return stop_->load(); },
                .wants_look = [this] { return Clock::now() >= next_look_; },
                .show = [this](GrownPattern pattern) { show(std::move(pattern), false); },
                .progress = [this](std::string_view stage, double fraction) { tell(stage, fraction); }};
    }
    void show(GrownPattern pattern, bool done) {
        post_(GrowthAction{PatternGrown{job_, std::make_shared<const GrownPattern>(std::move(pattern)), done}});
        next_look_ = Clock::now() + between_looks;
    }
    void fail(std::string message) { post_(GrowthAction{GrowthFailed{job_, std::move(message)}}); }

  private:
    void tell(std::string_view stage, double fraction) {
        progress_(stage, fraction);
        if (posts_.worth(stage, Clock::now())) post_(GrowthAction{GrowthProgress{job_, std::string(stage), fraction}});
    }

    std::uint64_t job_;
    GrowthStop stop_;
    const Progress& progress_;
    const Worker::Post& post_;
    ProgressPosts posts_;
    Clock::time_point next_look_ = Clock::now() + between_looks;
};

Region read_region(const std::string& path) {
    const Scene scene = read_svg(read_input(path), {.file_name = path}).scene;
    return region_of(scene, region_deviation * diagonal(scene.viewport), path);
}

FillFiles read_files(const AggregateSettings& settings) {
    FillFiles files;
    if (!settings.region.empty()) files.region = read_region(absolute_path(settings.region));
    if (!settings.density.empty()) {
        const std::string path = absolute_path(settings.density);
        files.density = std::make_shared<const DensityPicture>(read_density_png(read_input(path), {{0, 0}, {1, 1}}, path));
    }
    return files;
}

bool same_surroundings(const ArrangeOrder& a, const ArrangeOrder& b) {
    return a.source == b.source && a.guides == b.guides && a.canvas == b.canvas && a.settings.turn == b.settings.turn &&
           a.settings.fill == b.settings.fill && a.settings.directed == b.settings.directed;
}

}  // namespace

ArrangeSurroundings SurroundingsCache::surroundings(const ArrangeOrder& order) {
    const std::lock_guard lock(mutex_);
    if (!order_.source || !same_surroundings(order, order_)) {
        kept_ = surroundings_of(order);
        order_ = order;
        order_.from.reset();
        order_.steps.clear();
    }
    return kept_;
}

Worker::Job source_job(ReadSource request) {
    return [request = std::move(request)](const Progress& progress, const Worker::Post& post) {
        const auto answer = [&](GrowthSource source) {
            post(GrowthAction{SourceRead{request.job, std::make_shared<const GrowthSource>(std::move(source))}});
        };
        guarded([&] { answer(growth_source(request.question, request.known, progress)); },
                [&](std::string message) { answer({.question = request.question, .mistake = std::move(message)}); });
    };
}

Worker::Job arrange_job(GrowArrangement request, std::shared_ptr<SurroundingsCache> cache, GrowthStop stop) {
    return [request = std::move(request), cache = std::move(cache), stop = std::move(stop)](const Progress& progress,
                                                                                            const Worker::Post& post) {
        Watcher watcher(request.job, stop, progress, post);
        const auto work = [&] {
            watcher.show(arranged(*request.order, cache->surroundings(*request.order), watcher.watch()), true);
        };
        guarded(work, [&](std::string message) { watcher.fail(std::move(message)); });
    };
}

Worker::Job fill_job(FillPattern request, GrowthStop stop) {
    return [request = std::move(request), stop = std::move(stop)](const Progress& progress, const Worker::Post& post) {
        Watcher watcher(request.job, stop, progress, post);
        const auto work = [&] {
            const FillFiles files = read_files(request.order->settings);
            watcher.show(filled(*request.order, files, watcher.watch()), true);
        };
        guarded(work, [&](std::string message) { watcher.fail(std::move(message)); });
    };
}

Worker::Job grown_document_job(MakeGrownDocument request) {
    return [request = std::move(request)](const Progress&, const Worker::Post& post) {
        const auto work = [&] {
            Document made = grown_document(request.document, *request.pattern);
            post(GrowthAction{GrownDocumentMade{request.job, request.document.grammar, std::move(made)}});
        };
        guarded(work, [&](std::string message) { post(GrowthAction{GrowthFailed{request.job, std::move(message)}}); });
    };
}

}  // namespace rinceau
