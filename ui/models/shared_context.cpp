// SPDX-License-Identifier: Apache-2.0
#include "ui/models/shared_context.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QTemporaryFile>

#include "core/mesh/import/glb_reader.h"
#include "ui/models/file_choice.h"
#include "ui/models/tones.h"

namespace noctule::ui {
namespace {

constexpr const char* kBody = ":/noctule/bodies/mannequin.glb";

/// assimp reads files of the disk only; the body is part of the program.
Result<SkinnedMesh> readBody() {
    QFile resource(kBody);
    QTemporaryFile file(QDir::temp().filePath("noctule-XXXXXX.glb"));
    const bool opened = resource.open(QIODevice::ReadOnly) && file.open();
    const QByteArray bytes = opened ? resource.readAll() : QByteArray();
    if (!opened || file.write(bytes) != bytes.size() || !file.flush())
        return Error{
            ErrorKind::kDisk, SharedContext::tr("The body could not be unpacked").toStdString(),
            SharedContext::tr("Free some space on the disk; until then a skeleton is shown").toStdString()};
    return readSkinnedMesh(file.fileName().toStdString());
}

}  // namespace

SharedContext::SharedContext(StudioParts parts, QObject* parent)
    : QObject(parent),
      parts_(std::move(parts)),
      session_(jobs_, [this] { return sessionsFolder(); }),
      shown_body_(jobs_, session_) {
    connect(&session_, &SessionModel::opened, this, [this] {
        FileChoice::setSession(session_.isOpen() ? QString::fromStdString(session_.session().folder.string())
                                                 : QString());
    });
    connect(&shown_body_, &ShownBody::failed, this,
            [this](const QString& what, const QString& remedy) { emit failed(what, remedy, About::kFile); });
    connect(&shown_body_, &ShownBody::changed, this, [this] {
        if (!shown_body_.problem() && !shown_body_.undrawn())
            emit settled(About::kFile);
    });
    connect(&shown_body_, &ShownBody::warned, this,
            [this](const QString& what) { emit warned(what, About::kFile); });
    connect(&Tones::get(), &Tones::fellBack, this, [this](const QString& device) {
        emit warned(tr("Tones cannot be played on %1: the desktop plays them. Connect it, or choose another "
                       "device in Preferences.")
                        .arg(device),
                    About::kCapture);
    });
    loadBody();
}

SharedContext::~SharedContext() = default;

void SharedContext::sayOfFile(const QString& sentence) {
    emit settled(About::kFile);
    emit said(sentence);
}

void SharedContext::loadBody() {
    jobs_.start<SkinnedMesh>(
        tr("Loading the body"), [](const JobContext&) { return readBody(); },
        [this](Result<SkinnedMesh> mesh) -> QString {
            if (mesh)
                body_ = std::make_shared<const SkinnedMesh>(std::move(*mesh));
            body_ended_ = true;
            emit bodyLoaded();
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void SharedContext::whenBodyIsThere(QObject* context, std::function<void()> act) {
    if (body_ended_)
        act();
    else
        connect(this, &SharedContext::bodyLoaded, context, std::move(act));
}

QString SharedContext::sessionsFolder() const {
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return settings_.value("folders/sessions", QDir(documents).filePath("Noctule")).toString();
}

QString SharedContext::takesFolder() const {
    return session_.isOpen() ? QString::fromStdString(session_.session().folder.string()) : sessionsFolder();
}

}  // namespace noctule::ui
