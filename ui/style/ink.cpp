// SPDX-License-Identifier: Apache-2.0
#include "ui/style/ink.h"

#include "ui/style/theme.h"

namespace noctule::ui {

Ink inkOf(Tone tone) {
    switch (tone) {
        case Tone::kOk:
            return Ink::kOk;
        case Tone::kWarn:
            return Ink::kWarn;
        case Tone::kError:
            return Ink::kError;
        case Tone::kNeutral:
        case Tone::kAccent:
            break;
    }
    return Ink::kHint;
}

QColor colorOf(Ink ink) {
    const Tokens& tokens = Theme::get().tokens();
    switch (ink) {
        case Ink::kValue:
            return tokens.t1;
        case Ink::kLabel:
            return tokens.t2;
        case Ink::kHint:
            return tokens.t3;
        case Ink::kAccent:
            return tokens.acc;
        case Ink::kOnAccent:
            return tokens.onacc;
        case Ink::kOk:
            return tokens.ok;
        case Ink::kWarn:
            return tokens.warn;
        case Ink::kError:
            return tokens.err;
    }
    return tokens.t1;
}

QColor colorOf(Tone tone) {
    const Tokens& tokens = Theme::get().tokens();
    switch (tone) {
        case Tone::kNeutral:
            return tokens.t2;
        case Tone::kAccent:
            return tokens.acc;
        case Tone::kOk:
            return tokens.ok;
        case Tone::kWarn:
            return tokens.warn;
        case Tone::kError:
            return tokens.err;
    }
    return tokens.t2;
}

QColor backgroundOf(Tone tone) {
    const Tokens& tokens = Theme::get().tokens();
    switch (tone) {
        case Tone::kNeutral:
            return tokens.ctl;
        case Tone::kAccent:
            return tokens.sel;
        case Tone::kOk:
            return tokens.okbg;
        case Tone::kWarn:
            return tokens.warnbg;
        case Tone::kError:
            return tokens.errbg;
    }
    return tokens.ctl;
}

QString iconOf(Tone tone) {
    switch (tone) {
        case Tone::kOk:
            return "check";
        case Tone::kWarn:
            return "warn";
        case Tone::kError:
            return "error";
        case Tone::kNeutral:
        case Tone::kAccent:
            break;
    }
    return "info";
}

}  // namespace noctule::ui
