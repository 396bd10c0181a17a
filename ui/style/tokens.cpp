// SPDX-License-Identifier: Apache-2.0
#include "ui/style/tokens.h"

#include <QRegularExpression>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace noctule::ui {

namespace {

struct NamedColor {
    const char* name;
    QColor Tokens::*member;
};

constexpr NamedColor kColors[] = {
    {"bg", &Tokens::bg},       {"panel", &Tokens::panel},   {"raised", &Tokens::raised},
    {"ctl", &Tokens::ctl},     {"ctlh", &Tokens::ctlh},     {"line", &Tokens::line},
    {"edge", &Tokens::edge},   {"t1", &Tokens::t1},         {"t2", &Tokens::t2},
    {"t3", &Tokens::t3},       {"acc", &Tokens::acc},       {"onacc", &Tokens::onacc},
    {"sel", &Tokens::sel},     {"ok", &Tokens::ok},         {"warn", &Tokens::warn},
    {"err", &Tokens::err},     {"rec", &Tokens::rec},       {"view", &Tokens::view},
    {"view2", &Tokens::view2}, {"figure", &Tokens::figure}, {"grid", &Tokens::grid},
    {"scrim", &Tokens::scrim}, {"okbg", &Tokens::okbg},     {"warnbg", &Tokens::warnbg},
    {"errbg", &Tokens::errbg}, {"ref", &Tokens::ref},       {"x", &Tokens::x},
    {"y", &Tokens::y},         {"z", &Tokens::z},
};

/// "#0E1116" or, as the web writes it, "rgba(6,8,11,.62)"; throws naming `name`.
QColor readColor(const std::string& text, const std::string& name) {
    static const QRegularExpression rgba(R"(^rgba\((\d+),(\d+),(\d+),([\d.]+)\)$)");
    QColor color;
    if (const auto match = rgba.match(QString::fromStdString(text)); match.hasMatch()) {
        color.setRgb(match.captured(1).toInt(), match.captured(2).toInt(), match.captured(3).toInt());
        color.setAlphaF(match.captured(4).toDouble());
    } else {
        color.setNamedColor(QString::fromStdString(text));
    }
    if (!color.isValid())
        throw std::logic_error("tokens.json: " + name + " is \"" + text + "\", which is no colour");
    return color;
}

using Channels = std::array<double, 3>;  // sRGB, 0..255

double luminanceOf(const Channels& color) {
    const auto linear = [](double channel) {
        const double v = channel / 255;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
}

/// Rounds each channel up or down so that the luminance is met best: plain rounding of neighbours can turn
/// their order of lightness round.
QRgb roundedByLuminance(const Channels& exact) {
    const double wanted = luminanceOf(exact);
    Channels best{};
    double best_error = 2;
    for (int choice = 0; choice < 8; ++choice) {
        Channels candidate{};
        for (int channel = 0; channel < 3; ++channel)
            candidate[channel] =
                choice >> channel & 1 ? std::ceil(exact[channel]) : std::floor(exact[channel]);
        if (const double error = std::abs(luminanceOf(candidate) - wanted); error < best_error) {
            best_error = error;
            best = candidate;
        }
    }
    return qRgb(static_cast<int>(best[0]), static_cast<int>(best[1]), static_cast<int>(best[2]));
}

}  // namespace

Tokens readTokens(const QByteArray& json, ColorSet set) {
    try {
        const auto sets = nlohmann::json::parse(json.begin(), json.end());
        nlohmann::json scheme = sets.at(set == ColorSet::kLight ? "light" : "dark");
        if (set == ColorSet::kContrast)
            scheme.update(sets.at("contrast"));
        Tokens tokens;
        for (const NamedColor& color : kColors)
            tokens.*color.member = readColor(scheme.at(color.name).get<std::string>(), color.name);
        const auto& ramp = scheme.at("confidence");
        for (size_t i = 0; i < tokens.confidence.size(); ++i)
            tokens.confidence[i] = readColor(ramp.at(i).get<std::string>(), "confidence");
        const auto& performers = scheme.at("performers");
        for (size_t i = 0; i < tokens.performers.size(); ++i)
            tokens.performers[i] = readColor(performers.at(i).get<std::string>(), "performers");
        return tokens;
    } catch (const nlohmann::json::exception& exception) {
        throw std::logic_error(std::string("tokens.json: ") + exception.what());
    }
}

std::array<QRgb, 256> confidenceRamp(const std::array<QColor, 5>& colors) {
    std::array<QRgb, 256> ramp{};
    for (int i = 0; i < 256; ++i) {
        const double position = i / 255.0 * 4;
        const int left = std::min(static_cast<int>(position), 3);
        const double t = position - left;
        const QColor &a = colors[left], &b = colors[left + 1];
        const auto mix = [t](int from, int to) { return from + t * (to - from); };
        ramp[i] =
            roundedByLuminance({mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())});
    }
    return ramp;
}

}  // namespace noctule::ui
