// SPDX-License-Identifier: Apache-2.0
#include "ui/style/theme.h"

#include <QFontDatabase>
#include <QPalette>
#include <QStyleHints>
#include <algorithm>
#include <stdexcept>

#include "ui/style/focus_ring.h"
#include "ui/style/icons.h"
#include "ui/style/resources.h"
#include "ui/style/studio_style.h"
#include "ui/style/tokens.h"

namespace noctule::ui {

namespace {

Theme* the_theme = nullptr;

constexpr char kFamily[] = "Roboto";

int pixelSize(TextRole role) {
    switch (role) {
        case TextRole::kCaption:
            return 11;
        case TextRole::kSecondary:
            return 12;
        case TextRole::kBody:
            return 13;
        case TextRole::kSection:
            return 15;
        case TextRole::kPage:
            return 20;
        case TextRole::kVerdict:
            return 26;
        case TextRole::kInstruction:
            return 34;
        case TextRole::kClock:
            return 44;
    }
    return 13;
}

QPalette paletteOf(const Tokens& tokens) {
    QPalette palette;
    palette.setColor(QPalette::Window, tokens.panel);
    palette.setColor(QPalette::Base, tokens.raised);
    palette.setColor(QPalette::AlternateBase, tokens.raised);
    palette.setColor(QPalette::Button, tokens.ctl);
    palette.setColor(QPalette::WindowText, tokens.t1);
    palette.setColor(QPalette::Text, tokens.t1);
    palette.setColor(QPalette::ButtonText, tokens.t1);
    palette.setColor(QPalette::BrightText, tokens.onacc);
    palette.setColor(QPalette::PlaceholderText, tokens.t3);
    palette.setColor(QPalette::Highlight, tokens.sel);
    palette.setColor(QPalette::HighlightedText, tokens.t1);
    palette.setColor(QPalette::Link, tokens.acc);
    palette.setColor(QPalette::LinkVisited, tokens.acc);
    palette.setColor(QPalette::ToolTipBase, tokens.raised);
    palette.setColor(QPalette::ToolTipText, tokens.t1);
    palette.setColor(QPalette::Light, tokens.raised);
    palette.setColor(QPalette::Midlight, tokens.ctlh);
    palette.setColor(QPalette::Mid, tokens.line);
    palette.setColor(QPalette::Dark, tokens.edge);
    palette.setColor(QPalette::Shadow, tokens.bg);
    for (const auto role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText})
        palette.setColor(QPalette::Disabled, role, tokens.t3);
    palette.setColor(QPalette::Disabled, QPalette::Base, tokens.panel);
    return palette;
}

}  // namespace

Theme& Theme::get() {
    if (!the_theme)
        throw std::logic_error("Theme::install() comes before the first widget");
    return *the_theme;
}

void Theme::install(QApplication& application) {
    if (!the_theme)
        the_theme = new Theme(application);
}

Theme::Theme(QApplication& application)
    : QObject(&application),
      application_(application),
      desktop_is_dark_(application.palette().color(QPalette::Window).lightness() < 128),
      // The one wish for calm that Qt 5 passes on from a desktop is the caret that does not blink.
      reduce_motion_(application.styleHints()->cursorFlashTime() == 0) {
    for (const char* weight : {"Light", "Regular", "Medium", "Bold"}) {
        const QByteArray data = resourceBytes(QString("fonts/Roboto-%1.ttf").arg(weight));
        if (QFontDatabase::addApplicationFontFromData(data) < 0)
            throw std::logic_error("a font of the program cannot be read");
    }
    application.setEffectEnabled(Qt::UI_AnimateCombo, false);
    new FocusRing(*this, application);
    apply();
}

Theme::~Theme() {
    the_theme = nullptr;
}

void Theme::setScheme(Scheme scheme) {
    if (scheme == scheme_)
        return;
    scheme_ = scheme;
    apply();
}

void Theme::setScale(double scale) {
    scale = std::clamp(scale, 0.75, 1.5);
    if (scale == scale_)
        return;
    scale_ = scale;
    apply();
}

void Theme::setReduceMotion(bool reduce) {
    reduce_motion_ = reduce;
}

int Theme::px(double at_100_percent) const {
    const int scaled = qRound(at_100_percent * scale_);
    return at_100_percent > 0 ? std::max(scaled, 1) : scaled;
}

QFont Theme::font(TextRole role, bool medium) const {
    QFont font(kFamily);
    font.setPixelSize(px(pixelSize(role)));
    const bool light = role == TextRole::kClock && !medium;
    font.setWeight(medium ? QFont::Medium : light ? QFont::Light : QFont::Normal);
    return font;
}

QColor Theme::confidence(double w) const {
    // Also sends what is no number to the first colour.
    return QColor(confidence_[w > 0 ? static_cast<size_t>(std::min(w, 1.0) * 255 + 0.5) : 0]);
}

QPixmap Theme::pixmap(const QString& name, int size_px, const QColor& color) const {
    return drawIcon(name, size_px, color, application_.devicePixelRatio());
}

QIcon Theme::icon(const QString& name) const {
    return makeIcon(name, {tokens_.t2, tokens_.t1, tokens_.acc, tokens_.t3});
}

QIcon Theme::icon(const QString& name, const QColor& color) const {
    return makeIcon(name, {color, color, color, tokens_.t3});
}

void Theme::apply() {
    const bool has_contrast = scheme_ == Scheme::kContrast;
    dark_ = has_contrast || scheme_ == Scheme::kDark || (scheme_ == Scheme::kDesktop && desktop_is_dark_);
    tokens_ = readTokens(resourceBytes("style/tokens.json"), has_contrast ? ColorSet::kContrast
                                                             : dark_      ? ColorSet::kDark
                                                                          : ColorSet::kLight);
    confidence_ = confidenceRamp(tokens_.confidence);
    // The font first: a new style makes every widget ask for its sizes again, and combo boxes keep the least
    // size of the font that they then have.
    application_.setFont(font(TextRole::kBody));
    application_.setStyle(new StudioStyle(*this));
    QPalette palette = paletteOf(tokens_);
    application_.setPalette(palette);
    palette.setColor(QPalette::Base, tokens_.panel);
    application_.setPalette(palette, "QAbstractItemView");
    application_.setFont(font(TextRole::kBody));  // layouts ask once more, with the sizes of the new style
    emit changed();
}

}  // namespace noctule::ui
