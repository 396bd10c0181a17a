// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/licences.h"

#include <qwt_global.h>

#include <Eigen/Core>
#include <QCoreApplication>
#include <nlohmann/json.hpp>

#include "core/mesh/import/glb_reader.h"
#include "core/recording/library_versions.h"

namespace noctule::ui {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Licences)
};

QString eigenVersion() {
    return QStringLiteral("%1.%2.%3")
        .arg(EIGEN_WORLD_VERSION)
        .arg(EIGEN_MAJOR_VERSION)
        .arg(EIGEN_MINOR_VERSION);
}

QString jsonVersion() {
    return QStringLiteral("%1.%2.%3")
        .arg(NLOHMANN_JSON_VERSION_MAJOR)
        .arg(NLOHMANN_JSON_VERSION_MINOR)
        .arg(NLOHMANN_JSON_VERSION_PATCH);
}

QString fromCore(const std::string& text) {
    return QString::fromStdString(text);
}

}  // namespace

QList<LinkedWork> linkedWorks() {
    return {
        {"Qt", qVersion(), "LGPL-3.0", Words::tr("windows and controls"), "qt.io"},
        {"Qwt", QWT_VERSION_STR, "Qwt License 1.0 (LGPL-2.1 with exceptions)", Words::tr("plots"),
         "qwt.sourceforge.io"},
        {"Eigen", eigenVersion(), "MPL-2.0", Words::tr("linear algebra"), "eigen.tuxfamily.org"},
        {"SQLite", fromCore(sqliteVersion()), Words::tr("public domain"), Words::tr("take files"),
         "sqlite.org"},
        {"zstd", fromCore(zstdVersion()), "BSD-3-Clause", Words::tr("compression of takes"), "zstd.net"},
        {"Open Asset Import Library", fromCore(meshReaderVersion()), "BSD-3-Clause", Words::tr("meshes"),
         "assimp.org"},
        {"OpenCV", NOCTULE_OPENCV_VERSION, "Apache-2.0", Words::tr("markers in photographs, films"),
         "opencv.org"},
        {"libepoxy", NOCTULE_EPOXY_VERSION, "MIT", Words::tr("OpenGL"), "github.com/anholt/libepoxy"},
        {"JSON for Modern C++", jsonVersion(), "MIT", Words::tr("settings and documents"),
         "json.nlohmann.me"},
        {"Roboto", {}, "Apache-2.0", Words::tr("typeface"), "fonts.google.com/specimen/Roboto"},
    };
}

QString licencesAsText(const QString& software) {
    QString text = software + "\nApache-2.0\n\n";
    for (const LinkedWork& work : linkedWorks())
        text += QStringLiteral("%1 %2: %3 (%4)\n").arg(work.name, work.version, work.licence, work.address);
    return text.replace(" :", ":");
}

}  // namespace noctule::ui
