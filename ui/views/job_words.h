// SPDX-License-Identifier: Apache-2.0
// Jobs in words, the same everywhere: "turn_003: ranges, 6 s left".
#pragma once

#include <QCoreApplication>
#include <QString>

#include "ui/jobs/jobs.h"

namespace noctule::ui {

class JobWords {
    Q_DECLARE_TR_FUNCTIONS(JobWords)
public:
    /// While it runs: what, which part of it, and the time left as far as it can be told.
    static QString progress(const Job& job);
    /// "6 s left", "2 min left"; empty while it cannot be told.
    static QString timeLeft(const Job& job);
};

}  // namespace noctule::ui
