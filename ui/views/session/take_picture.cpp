// SPDX-License-Identifier: Apache-2.0
#include "ui/views/session/take_picture.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include "core/review/take_review.h"
#include "ui/models/shared_context.h"
#include "ui/scene/scene_view.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

/// Changes with the take, with the theme's colours and with the size.
QString cachePath(const QString& take_path, const QSize& size) {
    const QString key = QStringLiteral("%1 %2 %3 %4 %5")
                            .arg(take_path)
                            .arg(QFileInfo(take_path).lastModified().toMSecsSinceEpoch())
                            .arg(size.width())
                            .arg(size.height())
                            .arg(Theme::get().isDark());
    const QByteArray hash = QCryptographicHash::hash(key.toUtf8(), QCryptographicHash::Sha1).toHex();
    return QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation))
        .filePath(QStringLiteral("pictures/%1.png").arg(QString::fromLatin1(hash)));
}

Result<TimedMotion> lastMotion(const std::string& path, const JobContext& job) {
    const auto overview = overviewTake(path, job);
    if (!overview)
        return overview.error();
    if (overview->runs.empty())
        return Error{ErrorKind::kUnusable, path + " has no result yet", "Process it"};
    return loadPoses(path, overview->runs.back().run.run, job);
}

double middle_s(const TimedMotion& motion) {
    return motion.frames.empty()
               ? 0
               : static_cast<double>(motion.frames[motion.frames.size() / 2].time_ns) * 1e-9;
}

Result<QImage> paintTake(const std::shared_ptr<const SkinnedMesh>& body, const std::string& path,
                         const QSize& size_px, const QString& cached, const JobContext& job) {
    const auto motion = lastMotion(path, job);
    if (!motion)
        return motion.error();
    QImage picture = thumbnail(body, *motion, middle_s(*motion), size_px);
    QDir().mkpath(QFileInfo(cached).path());
    picture.save(cached);  // kept for next time; without it the picture is only made again
    return picture;
}

}  // namespace

void takePicture(SharedContext& shared, const QString& take_path, const QSize& size_px,
                 std::function<void(const QImage&)> done) {
    const QString cached = cachePath(take_path, size_px);
    if (const QImage picture(cached); !picture.isNull())
        return done(picture);
    shared.whenBodyIsThere(&shared, [&shared, take_path, size_px, cached, done = std::move(done)] {
        shared.jobs().start<QImage>(
            {SharedContext::tr("Picture of %1"), QFileInfo(take_path).completeBaseName()},
            [body = shared.body(), path = take_path.toStdString(), size_px, cached](const JobContext& job) {
                return paintTake(body, path, size_px, cached, job);
            },
            [done](Result<QImage> picture) -> QString {
                if (picture && !picture->isNull())
                    done(*picture);
                return {};
            },
            Jobs::Loudness::kQuiet);
    });
}

}  // namespace noctule::ui
