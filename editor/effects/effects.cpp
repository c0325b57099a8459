#include "editor/effects/effects.h"

#include <exception>
#include <utility>

#include "analyzer/analyze.h"
#include "editor/effects/analysis_jobs.h"
#include "editor/effects/guarded.h"
#include "editor/effects/read_document.h"
#include "editor/effects/write_export.h"
#include "files/files.h"
#include "files/output_error.h"
#include "lsystem/grammar_text.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

/// What is allowed to a picture that is derived between two frames.
constexpr double seconds_at_once = 0.05;
constexpr std::uint64_t modules_at_once = 1'000'000;
/// In a picture with no more elements a selection is found between two frames.
constexpr std::size_t elements_at_once = 20'000;

}  // namespace

Effects::Effects(ActionQueue& answers)
    : answers_(answers),
      files_([this](Action action) { answers_.post(std::move(action)); }),
      pictures_([this](Action action) { answers_.post(std::move(action)); }),
      selections_([this](Action action) { answers_.post(std::move(action)); }),
      lights_([this](Action action) { answers_.post(std::move(action)); }),
      befores_([this](Action action) { answers_.post(std::move(action)); }),
      analyses_([this](Action action) { answers_.post(std::move(action)); }),
      clusters_([this](Action action) { answers_.post(std::move(action)); }),
      maps_([this](Action action) { answers_.post(std::move(action)); }) {}

void Effects::fulfil(const Request& request) {
    std::visit([this](const auto& known) { one(known); }, request);
}

void Effects::one(const ReadDocument& request) {
    files_.start([path = request.path](const Progress&, const Worker::Post& post) {
        guarded([&] { post(FileAction{read_document(path)}); },
                [&](std::string message) {
                    post(FileAction{FileFailed{path, std::move(message)}});
                });
    });
}

void Effects::one(const WriteDocument& request) {
    guarded(
        [&] {
            write_output(request.path, to_text(*request.document.grammar));
            answers_.post(FileAction{FileSaved{request.path, request.document.grammar}});
        },
        [&](std::string message) {
            answers_.post(FileAction{SaveFailed{request.path, std::move(message)}});
        });
}

void Effects::one(const WriteExport& request) {
    guarded(
        [&] {
            answers_.post(
                FileAction{FileExported{request.path, write_export(request.document, request.path, request.format)}});
        },
        [&](std::string message) {
            answers_.post(FileAction{SaveFailed{request.path, std::move(message)}});
        });
}

void Effects::one(const DerivePicture& request) {
    pictures_.stop();
    const auto answer = [revision = request.revision](DerivedPicture picture) {
        return CanvasAction{PictureDerived{revision, std::make_shared<const DerivedPicture>(std::move(picture))}};
    };
    Document quick = request.document;
    quick.derive.max_seconds = seconds_at_once;
    quick.derive.max_modules = modules_at_once;
    try {
        answers_.post(answer(derive_picture(quick)));
        return;
    } catch (const LimitError&) {  // takes longer: below
    } catch (const std::exception& error) {
        answers_.post(CanvasAction{PictureFailed{request.revision, error.what()}});
        return;
    }
    pictures_.start([request, answer](const Progress& progress, const Worker::Post& post) {
        guarded([&] { post(answer(derive_picture(request.document, progress))); },
                [&](std::string message) {
                    post(CanvasAction{PictureFailed{request.revision, std::move(message)}});
                });
    });
}

void Effects::one(const FindSelection& request) {
    selections_.stop();
    if (request.search.picture->items.size() <= elements_at_once) {
        answers_.post(CanvasAction{find_selection(request.search)});
        return;
    }
    selections_.start([search = request.search](const Progress& progress, const Worker::Post& post) {
        post(CanvasAction{find_selection(search, progress)});
    });
}

void Effects::one(const LightRule& request) {
    lights_.start([request](const Progress& progress, const Worker::Post& post) {
        guarded(
            [&] {
                LitItems lit = lit_by_rule(request.document, request.production, progress);
                post(CanvasAction{RuleLit{request.revision, request.production, std::move(lit)}});
            },
            [](const std::string&) {});  // what has no picture has nothing to light
    });
}

void Effects::one(const DeriveBefore& request) {
    befores_.start([document = request.document](const Progress& progress, const Worker::Post& post) {
        guarded(
            [&] {
                DerivedPicture picture =
                    document.drawing ? drawing_picture(*document.drawing) : derive_picture(document, progress);
                post(CanvasAction{BeforeDerived{std::make_shared<const DerivedPicture>(std::move(picture))}});
            },
            [](const std::string&) {});  // a document that was open has had a picture
    });
}

void Effects::one(const RunAnalysis& request) { analyses_.start(analysis_job(request, prepared_)); }

void Effects::one(const StopAnalysis&) { analyses_.stop(); }

void Effects::one(const TabulateClusters& request) { clusters_.start(clusters_job(request, prepared_)); }

void Effects::one(const MapElements& request) { maps_.start(mapping_job(request)); }

void Effects::one(const CloseWindow&) { closing_ = true; }

}  // namespace rinceau
