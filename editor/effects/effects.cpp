#include "editor/effects/effects.h"

#include <exception>
#include <utility>

#include "analyzer/analyze.h"
#include "editor/effects/analysis_jobs.h"
#include "editor/effects/growth_jobs.h"
#include "editor/effects/surface_jobs.h"
#include "editor/effects/guarded.h"
#include "editor/effects/progress_posts.h"
#include "editor/effects/read_tool_replacement.h"
#include "lsystem/derivation_facts.h"
#include "lsystem/grammar_text.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

/// What is allowed to a picture that is derived between two frames.
constexpr double seconds_at_once = 0.05;
constexpr std::uint64_t modules_at_once = 1'000'000;
constexpr double seconds_to_measure = 3;
/// In a picture with no more elements a selection is found between two frames.
constexpr std::size_t elements_at_once = 20'000;

}  // namespace

Effects::Effects(ActionQueue& answers, const KeptFolders& folders)
    : answers_(answers),
      post_([&answers](Action action) { answers.post(std::move(action)); }),
      surroundings_(std::make_shared<SurroundingsCache>()),
      files_(answers, folders) {}

void Effects::fulfil(const Request& request) {
    std::visit(
        [this](const auto& known) {
            if constexpr (requires { files_.fulfil(known); }) {
                files_.fulfil(known);
            } else {
                one(known);
            }
        },
        request);
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

void Effects::one(const CheckText& request) {
    texts_.start([request](const Progress& progress, const Worker::Post& post) {
        const auto answer = [&](TextFindings findings) {
            post(RulesAction{TextChecked{request.revision, std::move(findings)}});
        };
        guarded([&] { answer(check_rule_text(request.text, request.file, request.document, progress)); },
                [&](std::string message) { answer({.picture = std::move(message)}); });
    });
}

void Effects::one(const MeasureDepth& request) {
    depths_.start([request](const Progress& progress, const Worker::Post& post) {
        const auto& grammar = request.document.resolved;
        DeriveOptions derive = request.document.derive;
        derive.depth = -1;
        derive.max_seconds = seconds_to_measure;
        guarded(
            [&] {
                post(RulesAction{DepthMeasured{grammar, derivation_facts(*grammar, derive, progress).depth}});
            },
            [&](const std::string&) {
                post(RulesAction{DepthMeasured{grammar, -1}});
            });
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

void Effects::one(const RunTool& request) {
    const auto use = [request](const Worker::Post& post) {
        guarded(
            [&] {
                post(ToolsAction{ToolDone{request.job, use_tool(request.document, *request.edit)}});
            },
            [&](std::string message) {
                post(ToolsAction{ToolFailed{request.job, std::move(message)}});
            });
    };
    if (request.at_once) {
        use([this](Action action) { answers_.post(std::move(action)); });
    } else {
        tools_.start([use](const Progress&, const Worker::Post& post) { use(post); });
    }
}

void Effects::one(const ReadReplacement& request) {
    replacements_.start([request](const Progress&, const Worker::Post& post) {
        guarded([&] { post(read_tool_replacement(request)); },
                [&](std::string message) {
                    post(ToolsAction{ReplacementFailed{request.with, std::move(message)}});
                });
    });
}

GrowthStop Effects::begin_growth() {
    growth_stop_->store(true);
    return growth_stop_ = std::make_shared<std::atomic<bool>>(false);
}

void Effects::one(const ReadSource& request) { sources_.start(source_job(request)); }

void Effects::one(const GrowArrangement& request) { growth_.start(arrange_job(request, surroundings_, begin_growth())); }

void Effects::one(const FillPattern& request) { growth_.start(fill_job(request, begin_growth())); }

void Effects::one(const MakeGrownDocument& request) { growth_.start(grown_document_job(request)); }

void Effects::one(const EndGrowth& request) {
    growth_stop_->store(true);
    if (!request.keep) growth_.stop();
}

void Effects::one(const ReadMesh& request) { meshes_.start(mesh_job(request)); }

void Effects::one(const DesignField& request) { fields_.start(field_job(request)); }

void Effects::one(const GrowOnSurface& request) {
    surface_stop_->store(true);
    surface_stop_ = std::make_shared<std::atomic<bool>>(false);
    surfaces_.start(surface_job(request, surface_stop_));
}

void Effects::one(const EndSurface& request) {
    surface_stop_->store(true);
    if (!request.keep) surfaces_.stop();
}

void Effects::one(const WriteSurface& request) { surface_files_.start(surface_file_job(request)); }

void Effects::one(const CloseWindow&) { closing_ = true; }

}  // namespace rinceau
