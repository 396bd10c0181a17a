// SPDX-License-Identifier: Apache-2.0
// The open take judged with all of its results side by side: for the list of results and the report page. It
// is made in the background once the shown result has its own report.
#pragma once

#include <QObject>
#include <QPointer>
#include <memory>
#include <optional>

#include "ui/models/review_context.h"

namespace noctule::ui {

class FullReport : public QObject {
    Q_OBJECT
public:
    explicit FullReport(ReviewContext& review, QObject* parent = nullptr);

    /// Null until made; then of the result that is shown.
    std::shared_ptr<const ReportData> data() const { return data_; }
    /// Mean joint error of a result against the reference; absent without one or while it is not known.
    std::optional<double> meanError_deg(int run) const;
    /// Makes it now unless it is there or being made.
    void need();

signals:
    void changed();

private:
    void outdate();
    void consider();

    ReviewContext& review_;
    std::shared_ptr<const ReportData> data_;
    QPointer<Job> job_;
    uint64_t ticket_ = 0;  ///< results of an earlier take or choice are dropped
    int shown_ = -1;       ///< that data_ is about
    bool failed_ = false;
};

}  // namespace noctule::ui
