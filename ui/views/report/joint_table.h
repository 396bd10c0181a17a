// SPDX-License-Identifier: Apache-2.0
// The joint table of the report: sorts by a click on its heads, copies with Ctrl+C, and the chosen row is the
// chosen joint everywhere.
#pragma once

#include <QTableView>
#include <memory>

#include "core/report/take_verdict.h"
#include "ui/models/selection.h"

class QSortFilterProxyModel;

namespace noctule::ui {

class JointTableModel;

class JointTable : public QTableView {
    Q_OBJECT
public:
    explicit JointTable(Selection& selection, QWidget* parent = nullptr);

    void setVerdict(std::shared_ptr<const TakeVerdict> verdict);
    /// All rows as they are sorted, with their heads, separated by tabs.
    QString asText() const;
    void copy() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void choose(const QString& joint);
    void fitColumns();
    int contentHeight() const;

    Selection& selection_;
    JointTableModel* joints_;
    QSortFilterProxyModel* sorted_;
};

}  // namespace noctule::ui
