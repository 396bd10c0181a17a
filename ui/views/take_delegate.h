// SPDX-License-Identifier: Apache-2.0
// Draws a row of the take list: dot, name, length, stars; the name is edited where it stands.
#pragma once

#include <QStyledItemDelegate>
#include <optional>

namespace noctule::ui {

class TakeDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    static constexpr int kRow = 28;  ///< height of a row, pixels at 100 percent

    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

    /// The rating that a click within a row means; absent beside the stars.
    static std::optional<int> ratingAt(const QRect& row, const QPoint& position);
};

}  // namespace noctule::ui
