// SPDX-License-Identifier: Apache-2.0
#include "core/processing/export_files.h"

#include "core/formats/bvh.h"
#include "core/formats/fbx_writer.h"
#include "core/formats/glb_writer.h"
#include "core/formats/opensim.h"
#include "core/formats/positions_csv.h"
#include "core/mesh/fit_mesh.h"
#include "core/mesh/mannequin.h"

namespace noctule {
namespace {

Result<Figure> figureOf(const ExportRequest& request, const ExportedMotion& motion) {
    std::optional<SkinnedMesh> body;
    if (request.with_body)
        body = bodyFor(motion.clip.skeleton);
    auto figure = makeFigure(motion.clip, std::move(body), request.names);
    if (figure)
        figure->confidence = motion.confidence;
    return figure;
}

Status writeBvhFile(const ExportRequest& request, const ExportedMotion& motion) {
    MotionClip clip = motion.clip;
    clip.skeleton = renamed(clip.skeleton, request.names);
    BvhOptions options;
    options.metres_per_unit = request.metres_per_unit;
    return writeBvh(request.bvh_path, clip, options, request.overwrite);
}

Status writeFbxFile(const ExportRequest& request, const ExportedMotion& motion) {
    const auto figure = figureOf(request, motion);
    if (!figure)
        return figure.error();
    return writeFbx(request.fbx_path, *figure, {request.metres_per_unit, request.root_name},
                    request.overwrite);
}

Status writeGlbFile(const ExportRequest& request, const ExportedMotion& motion) {
    const auto figure = figureOf(request, motion);
    return figure ? writeGlb(request.glb_path, *figure, request.overwrite) : Status(figure.error());
}

Status writeTableFile(const std::string& path, const Result<OpenSimTable>& table, bool overwrite) {
    return table ? writeOpenSimTable(path, *table, overwrite) : Status(table.error());
}

}  // namespace

SkinnedMesh bodyFor(const Skeleton& skeleton) {
    static const Actor actor = defaultActor();
    static const SkinnedMesh body = makeMannequin(actor);
    return fitted(body, actor.skeleton, skeleton);
}

std::vector<ExportWriter> exportWriters(const ExportRequest& request, const ExportedMotion& motion) {
    std::vector<ExportWriter> writers;
    const auto add = [&](const std::string& path, std::function<Status()> write) {
        if (!path.empty())
            writers.push_back({path, std::move(write)});
    };
    add(request.bvh_path, [&] { return writeBvhFile(request, motion); });
    add(request.fbx_path, [&] { return writeFbxFile(request, motion); });
    add(request.glb_path, [&] { return writeGlbFile(request, motion); });
    add(request.csv_path,
        [&] { return writePositionsCsv(request.csv_path, motion.clip, request.angles, request.overwrite); });
    add(request.mot_path,
        [&] { return writeTableFile(request.mot_path, openSimAngles(motion.clip), request.overwrite); });
    add(request.sto_path, [&] {
        return writeTableFile(request.sto_path, openSimOrientations(motion.clip), request.overwrite);
    });
    return writers;
}

}  // namespace noctule
