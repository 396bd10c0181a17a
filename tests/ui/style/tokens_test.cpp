// SPDX-License-Identifier: Apache-2.0
// The colours keep the promises of the style guide: WCAG contrast in all themes, a ramp that also works in
// grey.
#include "ui/style/tokens.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "ui/style/resources.h"

namespace noctule::ui {
namespace {

double linear(double srgb) {
    return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& color) {
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

double contrast(const QColor& a, const QColor& b) {
    const double la = luminance(a), lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

double lightness(const QColor& color) {
    const double y = luminance(color);
    return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

class TokensTest : public testing::TestWithParam<ColorSet> {
protected:
    Tokens tokens = readTokens(resourceBytes("style/tokens.json"), GetParam());
};

TEST_P(TokensTest, textHasContrastOnEverySurface) {
    for (const QColor& text :
         {tokens.t1, tokens.t2, tokens.t3, tokens.acc, tokens.ok, tokens.warn, tokens.err})
        for (const QColor& surface : {tokens.panel, tokens.raised, tokens.ctl, tokens.sel})
            EXPECT_GE(contrast(text, surface), 4.5)
                << text.name().toStdString() << " on " << surface.name().toStdString();
}

TEST_P(TokensTest, textHasContrastOnItsOwnColour) {
    EXPECT_GE(contrast(tokens.onacc, tokens.acc), 4.5);
    EXPECT_GE(contrast(Qt::white, tokens.rec), 4.5);
    EXPECT_GE(contrast(tokens.ok, tokens.okbg), 4.5);
    EXPECT_GE(contrast(tokens.warn, tokens.warnbg), 4.5);
    EXPECT_GE(contrast(tokens.err, tokens.errbg), 4.5);
}

TEST_P(TokensTest, edgesAndCurvesCanBeSeen) {
    for (const QColor& surface :
         {tokens.bg, tokens.panel, tokens.raised, tokens.ctl, tokens.sel, tokens.view})
        EXPECT_GE(contrast(tokens.edge, surface), 3.0) << surface.name().toStdString();
    for (const QColor& curve : {tokens.x, tokens.y, tokens.z, tokens.acc, tokens.ref})
        EXPECT_GE(contrast(curve, tokens.panel), 3.0) << curve.name().toStdString();
    EXPECT_GE(contrast(tokens.figure, tokens.bg), 1.3) << "a quiet surface below marks that have edges";
}

TEST_P(TokensTest, confidenceRampIsMonotonicInLightness) {
    const auto ramp = confidenceRamp(tokens.confidence);
    EXPECT_EQ(QColor(ramp.front()), tokens.confidence.front());
    EXPECT_EQ(QColor(ramp.back()), tokens.confidence.back());
    const double direction = GetParam() == ColorSet::kLight ? -1 : 1;
    for (size_t i = 1; i < ramp.size(); ++i)
        EXPECT_GT(direction * (lightness(QColor(ramp[i])) - lightness(QColor(ramp[i - 1]))), 0) << i;
}

INSTANTIATE_TEST_SUITE_P(Schemes, TokensTest,
                         testing::Values(ColorSet::kDark, ColorSet::kLight, ColorSet::kContrast),
                         [](const auto& set) {
                             return set.param == ColorSet::kDark    ? "dark"
                                    : set.param == ColorSet::kLight ? "light"
                                                                    : "contrast";
                         });

/// WCAG's enhanced contrast.
TEST(HighContrast, TextAndEdgesStandOut) {
    const Tokens tokens = readTokens(resourceBytes("style/tokens.json"), ColorSet::kContrast);
    for (const QColor& text :
         {tokens.t1, tokens.t2, tokens.t3, tokens.acc, tokens.ok, tokens.warn, tokens.err, tokens.edge})
        for (const QColor& surface :
             {tokens.bg, tokens.panel, tokens.raised, tokens.ctl, tokens.sel, tokens.view})
            EXPECT_GE(contrast(text, surface), 7)
                << text.name().toStdString() << " on " << surface.name().toStdString();
}

TEST(ReadTokens, namesTheColourThatIsMissing) {
    QByteArray json = resourceBytes("style/tokens.json");
    json.replace("\"okbg\"", "\"okgb\"");
    try {
        readTokens(json, ColorSet::kDark);
        FAIL() << "a missing colour went unnoticed";
    } catch (const std::logic_error& error) {
        EXPECT_NE(std::string(error.what()).find("okbg"), std::string::npos) << error.what();
    }
}

TEST(ReadTokens, namesWhatIsNoColour) {
    QByteArray json = resourceBytes("style/tokens.json");
    json.replace("#0E1116", "#0E11");
    json.replace("#151920", "blueish");
    EXPECT_THROW(readTokens(json, ColorSet::kDark), std::logic_error);
}

TEST(ReadTokens, understandsTransparency) {
    const Tokens dark = readTokens(resourceBytes("style/tokens.json"), ColorSet::kDark);
    EXPECT_EQ(dark.scrim.red(), 6);
    EXPECT_NEAR(dark.scrim.alphaF(), 0.62, 0.01);
}

}  // namespace
}  // namespace noctule::ui
