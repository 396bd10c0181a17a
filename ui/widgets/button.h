// SPDX-License-Identifier: Apache-2.0
// Push buttons of the studio. One filled (primary) button a screen at most; all others outlined, then text
// only. The shortcut is drawn inside as a key and told to screen readers; it is the page's or the window's
// QAction that acts on it.
#pragma once

#include <QKeySequence>
#include <QPushButton>

namespace noctule::ui {

enum class ButtonKind {
    kPrimary,   ///< filled with the accent, 38 px high
    kOutlined,  ///< 30 px high
    kText,      ///< words in the accent, 30 px high
    kRecord,    ///< red pill of the top bar, recording only
};

class Button : public QPushButton {
    Q_OBJECT
public:
    Button(ButtonKind kind, const QString& text, const QString& icon_name, const QKeySequence& shortcut,
           QWidget* parent);

    ButtonKind kind() const { return kind_; }
    /// As tall as before.
    void setKind(ButtonKind kind) {
        kind_ = kind;
        setTall(tall_);
    }
    void setIconName(const QString& icon_name);
    void setShortcutHint(const QKeySequence& shortcut);
    /// 30 px instead of 38 for a primary button in a row of others, 38 for an outlined one that ends a dock.
    void setTall(bool tall);
    /// A text button without room at its sides: its words stand where other words begin.
    void setFlush(bool flush);
    /// Disabled with the reason as tooltip; an empty reason enables it.
    void setDisabledBecause(const QString& reason);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    struct Look;
    Look look() const;
    QFont textFont() const;
    QString hintText() const;
    int contentWidth() const;
    void paintContent(QPainter& painter, const Look& look) const;
    void restyle();

    ButtonKind kind_;
    QString icon_name_;
    QKeySequence shortcut_;
    QString enabled_tooltip_;
    bool tall_, flush_ = false;
};

/// `icon`: a name of resources/icons, may be empty.
Button* makeButton(ButtonKind kind, const QString& text, const QString& icon = {},
                   const QKeySequence& shortcut = {}, QWidget* parent = nullptr);

}  // namespace noctule::ui
