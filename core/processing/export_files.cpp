// SPDX-License-Identifier: Apache-2.0
#include "core/processing/export_files.h"

#include "core/formats/bvh.h"
#include "core/formats/fbx_writer.h"
#include "core/formats/glb_writer.h"
#include "core/formats/opensim.h"
#include "core/formats/positions_csv.h"
#include "core/formats/rigged_figure.h"
#include "core/mesh/mannequin/mannequin.h"
#include "core/mesh/retarget/fit_mesh.h"

namespace noctule {
namespace {

/// Two seconds the first time.
const SkinnedMesh& defaultBody() {
    static const SkinnedMesh body = makeMannequin(defaultActor());
    return body;
}

Status writeBvhFile(const ExportRequest& request, const ExportedMotion& motion) {
    MotionClip clip = motion.clip;
    clip.skeleton = renamed(clip.skeleton, request.names);
    BvhOptions options;
    options.metres_per_unit = request.metres_per_unit;
    return writeBvh(request.bvh_path, clip, options, request.overwrite);
}

Status writeFbxFile(const ExportRequest& request, const ExportedMotion& motion, const JobContext& job) {
    const auto figure = figureOf(request, motion);
    if (!figure)
        return figure.error();
    return writeFbx(request.fbx_path, *figure, {request.metres_per_unit, request.root_name},
                    request.overwrite, job);
}

Status writeGlbFile(const ExportRequest& request, const ExportedMotion& motion, const JobContext& job) {
    const auto figure = figureOf(request, motion);
    return figure ? writeGlb(request.glb_path, *figure, request.overwrite, job) : Status(figure.error());
}

Result<MovingBody> movingBodyOf(const ExportRequest& request, const ExportedMotion& motion) {
    const Skeleton& skeleton = motion.filmed.skeleton;
    if (!request.with_body)
        return MovingBody();
    return request.worn ? MovingBody::of(request.worn, skeleton, motion.feet_at_rest)
                        : MovingBody::ofOurs(defaultBody(), skeleton, motion.feet_at_rest);
}

Status writePictureFile(const ExportRequest& request, const ExportedMotion& motion) {
    const MotionClip& clip = motion.filmed;
    const auto body = movingBodyOf(request, motion);
    if (!body)
        return body.error();
    const size_t frame = request.from_s ? 0 : clip.frames.size() / 2;
    return writePicture(request.png_path, {*body, clip, body->lockedFeet(motion.filmed_feet)}, frame,
                        request.film, request.overwrite);
}

Status writeFilmFile(const ExportRequest& request, const ExportedMotion& motion, const JobContext& job) {
    const MotionClip& clip = motion.filmed;
    const auto body = movingBodyOf(request, motion);
    if (!body)
        return body.error();
    return writeFilm(request.video_path, {*body, clip, body->lockedFeet(motion.filmed_feet)}, request.film,
                     request.overwrite, job);
}

Status writeTableFile(const std::string& path, const Result<OpenSimTable>& table, bool overwrite) {
    return table ? writeOpenSimTable(path, *table, overwrite) : Status(table.error());
}

}  // namespace

SkinnedMesh bodyFor(const Skeleton& skeleton, const FeetAtRest& feet) {
    return fitted(defaultBody(), defaultActor().skeleton, skeleton, feet);
}

namespace {

Result<Figure> onlyFigureOf(const ExportRequest& request, const ExportedMotion& motion) {
    if (request.with_body && request.worn) {
        const auto moving = MovingBody::of(request.worn, motion.clip.skeleton, motion.feet_at_rest);
        return moving ? riggedFigure(motion.clip, motion.confidence, *request.worn, request.names,
                                     motion.feet_at_rest, moving->lockedFeet(motion.feet))
                      : Result<Figure>(moving.error());
    }
    std::optional<SkinnedMesh> body;
    if (request.with_body)
        body = bodyFor(motion.clip.skeleton, motion.feet_at_rest);
    auto figure = makeFigure(motion.clip, std::move(body), request.names);
    if (figure)
        figure->confidence = motion.confidence;
    return figure;
}

}  // namespace

Result<Figure> figureOf(const ExportRequest& request, const ExportedMotion& motion) {
    auto figure = onlyFigureOf(request, motion);
    if (figure && !request.character.empty())
        return asCharacter(std::move(*figure), request.character);
    return figure;
}

std::vector<ExportWriter> exportWriters(const ExportRequest& request, const ExportedMotion& motion) {
    std::vector<ExportWriter> writers;
    const auto add = [&](const std::string& path, std::function<Status(const JobContext&)> write) {
        if (!path.empty())
            writers.push_back({path, std::move(write)});
    };
    add(request.bvh_path, [&](const JobContext&) { return writeBvhFile(request, motion); });
    add(request.fbx_path, [&](const JobContext& job) { return writeFbxFile(request, motion, job); });
    add(request.glb_path, [&](const JobContext& job) { return writeGlbFile(request, motion, job); });
    add(request.csv_path, [&](const JobContext&) {
        return writePositionsCsv(request.csv_path, motion.clip, request.angles, request.overwrite,
                                 motion.begin_s);
    });
    add(request.mot_path, [&](const JobContext&) {
        return writeTableFile(request.mot_path, openSimAngles(motion.clip), request.overwrite);
    });
    add(request.sto_path, [&](const JobContext&) {
        return writeTableFile(request.sto_path, openSimOrientations(motion.clip), request.overwrite);
    });
    add(request.png_path, [&](const JobContext&) { return writePictureFile(request, motion); });
    add(request.video_path, [&](const JobContext& job) { return writeFilmFile(request, motion, job); });
    return writers;
}

}  // namespace noctule
