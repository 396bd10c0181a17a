// SPDX-License-Identifier: Apache-2.0
// A motion file on its way into a session: read once, understood anew after every correction, and what was
// corrected in files with the same joints before.
#pragma once

#include <QSettings>
#include <QString>
#include <memory>

#include "core/figure/understood_motion.h"

namespace noctule::ui {

struct MotionFile {
    std::shared_ptr<const BvhDocument> document;
    std::shared_ptr<const figure::UnderstoodMotion> motion;  ///< null: no person was found
    std::optional<Error> problem;                            ///< then why
    std::vector<std::string> reader_warnings;
};

/// On any thread. Fails when the file cannot be read; that no person is found is part of the value.
Result<MotionFile> readMotionFile(const std::string& path, const figure::MotionHints& hints,
                                  const JobContext& job);
MotionFile understoodAnew(const MotionFile& file, const figure::MotionHints& hints);

/// Corrections of bones and up axis, by the names of all joints.
class KeptCorrections {
public:
    explicit KeptCorrections(QSettings& settings) : settings_(settings) {}
    void keep(const BvhDocument& document, const figure::MotionHints& hints);
    /// Nothing when none were kept.
    std::optional<figure::MotionHints> find(const BvhDocument& document) const;

private:
    QSettings& settings_;
};

}  // namespace noctule::ui
