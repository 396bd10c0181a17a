// SPDX-License-Identifier: Apache-2.0
// Look of the studio: colours by meaning (values in resources/style/tokens.json), type, sizes and icons, dark
// or light, at 75 to 150 percent. Widgets ask here and redraw on changed(); nobody writes a colour or a size
// in pixels elsewhere.
#pragma once

#include <QApplication>
#include <QColor>
#include <QFont>
#include <QIcon>
#include <QObject>
#include <QPixmap>
#include <array>

namespace noctule::ui {

enum class Scheme { kDark, kLight, kDesktop, kContrast };

/// Names as in tokens.json.
struct Tokens {
    QColor bg, panel, raised, ctl, ctlh, line, edge, t1, t2, t3, acc, onacc, sel, ok, warn, err, rec, view,
        view2, figure, grid, scrim, okbg, warnbg, errbg, ref, x, y, z;
    std::array<QColor, 5> confidence;
    std::array<QColor, 5> performers;  ///< A, B, C ...; the sixth begins anew
};

enum class TextRole { kCaption, kSecondary, kBody, kSection, kPage, kVerdict, kInstruction, kClock };

class Theme : public QObject {
    Q_OBJECT
public:
    /// The application's one theme; lives from install() to the application's end.
    static Theme& get();
    /// Loads fonts and tokens from the resources, sets palette, style and font of the application.
    static void install(QApplication& application);
    ~Theme() override;

    const Tokens& tokens() const { return tokens_; }
    bool isDark() const { return dark_; }
    Scheme scheme() const { return scheme_; }
    void setScheme(Scheme scheme);
    /// 0.75 .. 1.5, of all type and sizes.
    double scale() const { return scale_; }
    void setScale(double scale);
    /// Animations last this long in ms; 0 with "reduce motion".
    int motion_ms(int normal_ms) const { return reduce_motion_ ? 0 : normal_ms; }
    /// At first what the desktop wishes.
    void setReduceMotion(bool reduce);
    bool reduceMotion() const { return reduce_motion_; }

    /// A length of the style guide (pixels at 100 percent) at the present scale.
    int px(double at_100_percent) const;
    QFont font(TextRole role, bool medium = false) const;
    /// Ramp of the style guide, 256 steps; w 0..1.
    QColor confidence(double w) const;

    /// From resources/icons (name of the symbol: "board", "play"), in one colour, sharp at the screen's
    /// ratio.
    QPixmap pixmap(const QString& name, int size_px, const QColor& color) const;
    /// Normal t2, active t1, checked acc, disabled t3; follows the theme when asked for again on changed().
    QIcon icon(const QString& name) const;
    QIcon icon(const QString& name, const QColor& color) const;

signals:
    void changed();

private:
    explicit Theme(QApplication& application);
    void apply();

    QApplication& application_;
    Tokens tokens_;
    Scheme scheme_ = Scheme::kDark;
    bool desktop_is_dark_;
    bool dark_ = true;
    bool reduce_motion_;
    double scale_ = 1;
    std::array<QRgb, 256> confidence_{};
};

}  // namespace noctule::ui
