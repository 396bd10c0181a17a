// SPDX-License-Identifier: Apache-2.0
// The body that views show: the studio's own, or the mesh that the session names, read and fitted with bones
// by a job. Reading it anew for other bones takes the mesh that is there already.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QPointer>
#include <functional>

#include "core/session/session_body.h"
#include "ui/jobs/jobs.h"
#include "ui/models/session_model.h"

namespace noctule::ui {

/// What a view draws, and how.
struct BodyLook {
    std::shared_ptr<const SkinnedMesh> ours;   ///< in the default actor's measures; null: none
    std::shared_ptr<const WearableBody> worn;  ///< null: ours
    Blending blending = Blending::kLinear;
};

/// An unrigged mesh as its landmarks know it.
struct StandingMesh {
    std::shared_ptr<const SkinnedMesh> surface;  ///< standingSurface()
    Landmarks found;                             ///< by themselves; where that failed, of a typical body
};

/// A file's mesh, and the body made from it or why there is none.
struct ReadBody {
    std::string path;
    std::shared_ptr<const RiggedMesh> mesh;
    std::shared_ptr<const WearableBody> body;
    std::optional<Error> problem;            ///< of the body; without a mesh of the file
    std::optional<Error> textures{};         ///< why some are not drawn
    std::optional<StandingMesh> standing{};  ///< of a mesh without bones
};

class ShownBody : public QObject {
    Q_OBJECT
public:
    ShownBody(Jobs& jobs, SessionModel& session, QObject* parent = nullptr);

    /// Null while it is ours, is being read or cannot be worn.
    std::shared_ptr<const WearableBody> worn() const { return read_.body; }
    Blending blending() const;
    /// What is wrong with the mesh that the session names.
    const std::optional<Error>& problem() const { return read_.problem; }
    /// Why some of its textures are not drawn.
    const std::optional<Error>& undrawn() const { return read_.textures; }
    /// A job; `done` is not called when `context` is gone or it was cancelled.
    Job* read(const SessionBody& body, QObject* context, std::function<void(const ReadBody&)> done);

signals:
    void changed();
    /// The session's mesh cannot be shown: what happened, and what to do.
    void failed(const QString& what, const QString& remedy);
    /// It is shown, but not all of it: whole sentences.
    void warned(const QString& what);

private:
    void follow();
    void keep(const SessionBody& body, ReadBody read);

    Jobs& jobs_;
    SessionModel& session_;
    SessionBody shown_;
    std::string shown_path_;  ///< absolute: another session's may be called the same
    ReadBody read_;
    std::string known_path_;
    QDateTime known_written_;
    std::shared_ptr<const RiggedMesh> known_;  ///< the last mesh that was read
    QPointer<Job> reading_;
};

}  // namespace noctule::ui
