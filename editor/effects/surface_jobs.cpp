#include "editor/effects/surface_jobs.h"

#include <chrono>
#include <filesystem>
#include <utility>

#include "editor/effects/folders.h"
#include "editor/effects/guarded.h"
#include "editor/effects/progress_posts.h"
#include "editor/model/surface_stage.h"
#include "files/files.h"
#include "growth/mesh/mesh_glb_write.h"
#include "growth/mesh/mesh_obj_write.h"
#include "growth/mesh/mesh_picture.h"
#include "scene/svg_raster.h"

namespace rinceau {
namespace {

using Clock = std::chrono::steady_clock;

/// Of what stands while more is growing: uploading it takes longer.
constexpr auto between_looks = std::chrono::milliseconds(300);

/// Names in a shape grammar are relative to its folder.
ReadNamed reader_beside(const std::string& file) {
    const std::filesystem::path folder = std::filesystem::path(absolute_path(file)).parent_path();
    return [folder](const std::string& name) { return read_input((folder / name).string()); };
}

class SurfaceWatcher {
  public:
    SurfaceWatcher(std::uint64_t job, GrowthStop stop, const Progress& progress, const Worker::Post& post)
        : job_(job), stop_(std::move(stop)), progress_(progress), post_(post) {}

    SurfaceWatch watch() {
        return {.stop = [this] { return stop_->load(); },
                .wants_look = [this] { return Clock::now() >= next_look_; },
                .show = [this](GrownSurface grown) { show(std::move(grown), false); },
                .progress = [this](std::string_view stage, double fraction) { tell(stage, fraction); }};
    }
    void show(GrownSurface grown, bool done) {
        post_(SurfaceAction{SurfaceGrown{job_, std::make_shared<const GrownSurface>(std::move(grown)), {}, done}});
        next_look_ = Clock::now() + between_looks;
    }
    void fail(std::string message) { post_(SurfaceAction{SurfaceGrown{job_, nullptr, std::move(message), true}}); }

  private:
    void tell(std::string_view stage, double fraction) {
        progress_(stage, fraction);
        if (posts_.worth(stage, Clock::now())) post_(SurfaceAction{SurfaceProgress{job_, std::string(stage), fraction}});
    }

    std::uint64_t job_;
    GrowthStop stop_;
    const Progress& progress_;
    const Worker::Post& post_;
    ProgressPosts posts_;
    Clock::time_point next_look_ = Clock::now() + between_looks;
};

/// The surface with what grows on it.
MeshAssembly joined(const SurfaceStage& stage, const GrownSurface* grown) {
    MeshAssembly all = *stage.ground;
    if (grown == nullptr) return all;
    const int first = static_cast<int>(all.meshes.size());
    const MeshAssembly& pattern = *grown->assembly;
    all.meshes.insert(all.meshes.end(), pattern.meshes.begin(), pattern.meshes.end());
    for (MeshInstance instance : pattern.instances) {
        instance.mesh += first;
        all.instances.push_back(instance);
    }
    return all;
}

void write_surface(const WriteSurface& request) {
    const std::string path = absolute_path(request.path);
    const std::string ending = std::filesystem::path(path).extension().string();
    const MeshAssembly all = joined(*request.stage, request.grown.get());
    const UpAxis up = request.view.z_up ? UpAxis::z : UpAxis::y;
    if (ending == ".glb") {
        write_output(path, glb_bytes(all, up));
    } else if (ending == ".obj") {
        std::string text;
        write_obj(all, [&](std::string_view piece) { text += piece; });
        write_output(path, text);
    } else if (ending == ".png") {
        constexpr int width = 1200;
        write_output(path, picture_to_png(mesh_picture(all, up, {.elevation = request.view.elevation, .width = width})));
    } else {
        throw InputError({request.path}, "a surface is written as .glb, .obj or .png; expected a name that ends so");
    }
}

}  // namespace

Worker::Job mesh_job(ReadMesh request) {
    return [request = std::move(request)](const Progress&, const Worker::Post& post) {
        const auto work = [&] {
            SurfaceStage stage = surface_stage(request.path, read_input(absolute_path(request.path)));
            post(SurfaceAction{MeshRead{request.job, std::make_shared<const SurfaceStage>(std::move(stage)), {}}});
        };
        guarded(work, [&](std::string message) { post(SurfaceAction{MeshRead{request.job, nullptr, std::move(message)}}); });
    };
}

Worker::Job field_job(DesignField request) {
    return [request = std::move(request)](const Progress& progress, const Worker::Post& post) {
        const auto work = [&] {
            StageField field = stage_field(*request.stage, request.settings, request.spacing, progress);
            post(SurfaceAction{FieldDesigned{request.job, std::make_shared<const StageField>(std::move(field)), {}}});
        };
        guarded(work, [&](std::string message) {
            post(SurfaceAction{FieldDesigned{request.job, nullptr, std::move(message)}});
        });
    };
}

Worker::Job surface_job(GrowOnSurface request, GrowthStop stop) {
    return [request = std::move(request), stop = std::move(stop)](const Progress& progress, const Worker::Post& post) {
        SurfaceWatcher watcher(request.job, stop, progress, post);
        const auto work = [&] {
            const ReadNamed read = reader_beside(request.order->settings.grammar);
            watcher.show(grown_on_surface(*request.order, read, watcher.watch()), true);
        };
        guarded(work, [&](std::string message) { watcher.fail(std::move(message)); });
    };
}

Worker::Job surface_file_job(WriteSurface request) {
    return [request = std::move(request)](const Progress&, const Worker::Post& post) {
        const auto tell = [&](std::string mistake) {
            post(SurfaceAction{SurfaceExported{request.path, std::move(mistake)}});
        };
        guarded(
            [&] {
                write_surface(request);
                tell({});
            },
            tell);
    };
}

}  // namespace rinceau
