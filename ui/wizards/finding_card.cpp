// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/finding_card.h"

#include "ui/language/core_words.h"
#include "ui/style/words.h"
#include "ui/widgets/problem_card.h"

namespace noctule::ui {

Tone toneOf(const Finding& finding) {
    return finding.grade == Grade::kNotUsable ? Tone::kError
           : finding.grade == Grade::kGood    ? Tone::kNeutral
                                              : Tone::kWarn;
}

ProblemCard* findingCard(const Finding& finding, Tone tone) {
    return new ProblemCard(
        tone, unbroken(coreWords(finding.what)),
        unbroken(coreWords(finding.remedy.empty() ? std::string() : finding.remedy + ".")));
}

}  // namespace noctule::ui
