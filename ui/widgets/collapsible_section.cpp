// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/collapsible_section.h"

#include <QBoxLayout>
#include <QKeyEvent>
#include <QPainter>

#include "ui/style/paint.h"
#include "ui/style/theme.h"

namespace noctule::ui {

namespace {

class Heading : public QAbstractButton {
public:
    explicit Heading(const QString& title) {
        setText(title);
        setCheckable(true);
        setFocusPolicy(Qt::TabFocus);
        setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    }
    QSize sizeHint() const override {
        const Theme& theme = Theme::get();
        const QFontMetrics metrics(theme.font(TextRole::kSecondary, true));
        return {theme.px(22) + metrics.horizontalAdvance(text()),
                std::max(theme.px(28), metrics.height() + theme.px(4))};
    }
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent*) override {
        const Theme& theme = Theme::get();
        QPainter painter(this);
        const QColor color = underMouse() ? theme.tokens().t1 : theme.tokens().t2;
        paintIcon(painter, QRect(0, 0, theme.px(16), height()), isChecked() ? "down" : "chevron",
                  theme.px(12), color);
        painter.setFont(theme.font(TextRole::kSecondary, true));
        painter.setPen(color);
        painter.drawText(rect().adjusted(theme.px(20), 0, 0, 0), Qt::AlignVCenter, text());
    }
    void keyPressEvent(QKeyEvent* event) override {
        const int key = event->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter)
            return click();
        if (key == Qt::Key_Right || key == Qt::Key_Left)
            return setChecked(key == Qt::Key_Right);
        QAbstractButton::keyPressEvent(event);
    }
    void enterEvent(QEvent*) override { update(); }
    void leaveEvent(QEvent*) override { update(); }
};

}  // namespace

CollapsibleSection::CollapsibleSection(const QString& title, QWidget* content, bool open, QWidget* parent)
    : QWidget(parent), heading_(new Heading(title)), content_(content) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(heading_);
    column->addWidget(content_);
    heading_->setChecked(open);
    content_->setVisible(open);
    connect(heading_, &QAbstractButton::toggled, this, [this](bool now_open) {
        content_->setVisible(now_open);
        emit toggled(now_open);
    });
    connect(&Theme::get(), &Theme::changed, this, [this] { heading_->updateGeometry(); });
}

void CollapsibleSection::setOpen(bool open) {
    heading_->setChecked(open);
}

bool CollapsibleSection::isOpen() const {
    return heading_->isChecked();
}

}  // namespace noctule::ui
