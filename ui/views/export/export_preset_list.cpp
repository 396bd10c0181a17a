// SPDX-License-Identifier: Apache-2.0
#include "ui/views/export/export_preset_list.h"

#include <QPainter>
#include <QStyledItemDelegate>

#include "ui/style/theme.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"

namespace noctule::ui {
namespace {

constexpr int kPresetRow = 52, kPresetInset = 16, kStripe = 3, kKeyRole = Qt::UserRole,
              kDetailRole = Qt::UserRole + 1;

/// Name above, detail below; the chosen one with a stripe at its left.
class PresetDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override {
        return {0, Theme::get().px(kPresetRow)};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const Theme& theme = Theme::get();
        const Tokens& tokens = theme.tokens();
        const bool chosen = option.state & QStyle::State_Selected;
        const bool enabled = index.flags() & Qt::ItemIsEnabled;
        painter->save();
        if (chosen) {
            painter->fillRect(option.rect, tokens.sel);
            painter->fillRect(QRect(option.rect.topLeft(), QSize(theme.px(kStripe), option.rect.height())),
                              tokens.acc);
        } else if (enabled && option.state & QStyle::State_MouseOver) {
            painter->fillRect(option.rect, tokens.ctl);
        }
        const QFont name = theme.font(TextRole::kBody, chosen), small = theme.font(TextRole::kSecondary);
        const QFontMetrics name_metrics(name), small_metrics(small);
        const QRect text = option.rect.adjusted(theme.px(kPresetInset), 0, -theme.px(12), 0);
        const int top = text.center().y() - (name_metrics.height() + small_metrics.height()) / 2;
        painter->setFont(name);
        painter->setPen(enabled ? tokens.t1 : tokens.t3);
        painter->drawText(text.left(), top + name_metrics.ascent(),
                          name_metrics.elidedText(index.data().toString(), Qt::ElideRight, text.width()));
        painter->setFont(small);
        painter->setPen(tokens.t3);
        painter->drawText(
            text.left(), top + name_metrics.height() + small_metrics.ascent(),
            small_metrics.elidedText(index.data(kDetailRole).toString(), Qt::ElideRight, text.width()));
        painter->restore();
    }
};

}  // namespace

ExportPresetList::ExportPresetList(ExportPresets& presets, QWidget* parent)
    : QWidget(parent),
      presets_(presets),
      list_(new QListWidget),
      save_(makeButton(ButtonKind::kText, tr("Save as own preset"))),
      remove_(makeButton(ButtonKind::kText, tr("Remove"), "trash")) {
    auto* column = makeColumn(this);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setItemDelegate(new PresetDelegate(this));
    list_->setMouseTracking(true);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setAccessibleName(tr("Presets"));
    column->addWidget(list_, 1);
    auto* buttons = addRow(column, 0, {8, 8, 8, 12});
    buttons->addWidget(save_);
    buttons->addStretch();
    buttons->addWidget(remove_);
    connect(list_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        if (!item)
            return;
        const QString key = item->data(kKeyRole).toString();
        remove_->setVisible(presets_.all()[static_cast<size_t>(presets_.indexOf(key))].is_own);
        emit chosen(key);
    });
    connect(save_, &QPushButton::clicked, this, &ExportPresetList::saveWanted);
    connect(remove_, &QPushButton::clicked, this, [this] { emit removeWanted(current()); });
    connect(&Theme::get(), &Theme::changed, this, [this] { list_->doItemsLayout(); });
    refresh();
}

QString ExportPresetList::current() const {
    const QListWidgetItem* item = list_->currentItem();
    return item ? item->data(kKeyRole).toString() : QString();
}

void ExportPresetList::choose(const QString& key) {
    if (const int row = presets_.indexOf(key); row >= 0)
        list_->setCurrentRow(row);
}

void ExportPresetList::refresh() {
    const QString key = current();
    {
        const QSignalBlocker quiet(list_);
        list_->clear();
        for (const ExportPreset& preset : presets_.all()) {
            auto* item = new QListWidgetItem(preset.name, list_);
            item->setData(kKeyRole, preset.key);
            item->setData(kDetailRole, preset.detail);
            item->setToolTip(preset.name + '\n' + preset.detail);
            item->setData(Qt::AccessibleDescriptionRole, preset.detail);
        }
        list_->setCurrentRow(std::max(0, presets_.indexOf(key)));
    }
    remove_->setVisible(presets_.all()[static_cast<size_t>(list_->currentRow())].is_own);
}

}  // namespace noctule::ui
