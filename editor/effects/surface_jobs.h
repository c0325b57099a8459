#pragma once
// What the threads of growth on surfaces do.

#include <atomic>
#include <memory>

#include "editor/effects/growth_jobs.h"
#include "editor/effects/worker.h"
#include "editor/model/request.h"

namespace rinceau {

/// Posts MeshRead.
Worker::Job mesh_job(ReadMesh request);

/// Posts FieldDesigned.
Worker::Job field_job(DesignField request);

/// Posts SurfaceProgress and SurfaceGrown now and then, then SurfaceGrown{.done}.
Worker::Job surface_job(GrowOnSurface request, GrowthStop stop);

/// Posts SurfaceExported.
Worker::Job surface_file_job(WriteSurface request);

}  // namespace rinceau
