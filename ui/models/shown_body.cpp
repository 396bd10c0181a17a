// SPDX-License-Identifier: Apache-2.0
#include "ui/models/shown_body.h"

#include <QFileInfo>
#include <algorithm>

#include "core/film/texture_decoder.h"
#include "core/mesh/import/mesh_reader.h"
#include "core/mesh/surface_graph.h"
#include "ui/language/core_words.h"

namespace noctule::ui {
namespace {

StandingMesh standingMesh(const ReadBody& read, const WearingChoices& choices) {
    const RiggedMesh placed = placedForRigging(*read.mesh);
    StandingMesh standing{std::make_shared<const SkinnedMesh>(standingSurface(placed.skin)), {}};
    if (read.body && !choices.landmarks) {
        standing.found = *read.body->landmarks;
    } else if (auto found = findLandmarks(welded(placed.skin).mesh, read.path); found) {
        standing.found = std::move(*found);
    } else {
        float height_m = 0;
        for (const SkinnedVertex& vertex : placed.skin.vertices)
            height_m = std::max(height_m, vertex.p_m.y());
        standing.found = typicalLandmarks(static_cast<double>(height_m));
    }
    return standing;
}

Result<ReadBody> readBodyFrom(const std::string& path, const WearingChoices& choices,
                              std::shared_ptr<const RiggedMesh> known, const JobContext& job) {
    ReadBody read{path, std::move(known), nullptr, std::nullopt};
    if (!read.mesh) {
        job.progress(0, ShownBody::tr("Reading the file").toStdString());
        auto mesh = importMeshApart(path, {}, job);
        if (!mesh && mesh.error().kind == ErrorKind::kCancelled)
            return mesh.error();
        if (!mesh) {
            read.problem = mesh.error();
            return read;
        }
        read.mesh = std::make_shared<const RiggedMesh>(std::move(*mesh));
    }
    read.textures = undrawnTextures(*read.mesh, path);
    job.progress(0.5, read.mesh->isRigged() ? ShownBody::tr("Finding bones").toStdString()
                                            : ShownBody::tr("Fitting a skeleton").toStdString());
    auto body = wearable(*read.mesh, path, choices, {nullptr, job.cancel});
    if (body)
        read.body = std::make_shared<const WearableBody>(std::move(*body));
    else if (body.error().kind == ErrorKind::kCancelled)
        return body.error();
    else
        read.problem = body.error();
    if (!read.mesh->isRigged())
        read.standing = standingMesh(read, choices);
    return read;
}

}  // namespace

ShownBody::ShownBody(Jobs& jobs, SessionModel& session, QObject* parent)
    : QObject(parent), jobs_(jobs), session_(session) {
    connect(&session, &SessionModel::opened, this, &ShownBody::follow);
    connect(&session, &SessionModel::changed, this, &ShownBody::follow);
}

Blending ShownBody::blending() const {
    return shown_.blending;
}

Job* ShownBody::read(const SessionBody& body, QObject* context, std::function<void(const ReadBody&)> done) {
    const std::string path = body.pathIn(session_.session().folder).string();
    const QString name = QFileInfo(QString::fromStdString(path)).fileName();
    const QDateTime written = QFileInfo(QString::fromStdString(path)).lastModified();
    return jobs_.start<ReadBody>(
        {tr("Reading %1"), name},
        [path, choices = body.choices,
         known = known_path_ == path && known_written_ == written ? known_ : nullptr](const JobContext& job) {
            return readBodyFrom(path, choices, known, job);
        },
        [this, written, context = QPointer(context),
         done = std::move(done)](Result<ReadBody> result) -> QString {
            if (!result)
                return {};
            if (result->mesh) {
                known_path_ = result->path;
                known_written_ = written;
                known_ = result->mesh;
            }
            if (context)
                done(*result);
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void ShownBody::follow() {
    const SessionBody wanted = session_.isOpen() ? session_.session().body : SessionBody{};
    const std::string path =
        wanted.isOurs() ? std::string() : wanted.pathIn(session_.session().folder).string();
    if (wanted == shown_ && path == shown_path_)
        return;
    const bool same_body = path == shown_path_ && wanted.choices == shown_.choices;
    shown_ = wanted;
    shown_path_ = path;
    if (!same_body) {
        read_ = {};
        if (reading_)
            reading_->cancel();
    }
    emit changed();
    if (same_body)
        return;
    if (wanted.isOurs())
        keep(wanted, {});
    else
        reading_ = read(wanted, this, [this, wanted](const ReadBody& read) { keep(wanted, read); });
}

void ShownBody::keep(const SessionBody& body, ReadBody read) {
    if (!(body.mesh == shown_.mesh && body.choices == shown_.choices))
        return;  // another was chosen meanwhile
    read_ = std::move(read);
    emit changed();  // which ends what was told of the mesh before
    if (read_.problem)
        emit failed(coreWords(read_.problem->message), coreWords(read_.problem->remedy));
    else if (read_.textures)
        emit warned(coreWords(read_.textures->message) + ". " + coreWords(read_.textures->remedy) + ".");
}

}  // namespace noctule::ui
