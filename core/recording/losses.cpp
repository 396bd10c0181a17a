// SPDX-License-Identifier: Apache-2.0
#include "core/recording/losses.h"

#include <map>

#include "core/body/text.h"
#include "core/recording/schema.h"

namespace noctule {
namespace {

/// A table by the name that a screen has for what is in it.
std::string contentsOf(const std::string& table) {
    static const std::map<std::string, std::string> kContents{
        {"meta", "the take's details"},
        {"suit", "the suit's description"},
        {"calibration", "the list of calibrations"},
        {"actor", "the body measures"},
        {"adc_block", "the sound"},
        {"pulse", "the sources' pulses"},
        {"status", "the box's reports"},
        {"gap", "the list of gaps"},
        {"marker", "the list of markers"},
        {"note", "the list of notes"},
        {"derived", "the list of results"},
        {"inertial", "the inertial readings"},
        {"range", "the measured distances"},
        {"pose", "the computed poses"},
        {"orientation", "the boards' orientations"},
        {"clock", "the clocks' offsets"},
        {"relative", "the places of performers among each other"},
        {"contact", "the ground contacts"},
        {"reference", "the reference motion"},
        {"external_root", "the external root"},
        {"robot_drive", "the list of robot drives"},
        {"robot_command", "the robot's commands"},
        {"robot_state", "the robot's states"},
    };
    return kContents.at(table);
}

std::string partOf(const TableLoss& loss, const TakeLosses& losses) {
    const std::string contents = contentsOf(loss.table);
    if (loss.table == "adc_block" && losses.sound_s)
        return text::number(*losses.sound_s, 2) + " s of " + text::number(losses.whole_sound_s, 2) +
               " s of the sound";
    if (loss.saved == 0)
        return "nothing of " + contents;
    if (!loss.lost)
        return "an unknown part of " + contents;
    const auto saved = static_cast<double>(loss.saved), lost = static_cast<double>(*loss.lost);
    return "about " + text::percent(saved / (saved + lost)) + " of " + contents;
}

std::string readText(const TakeLosses& losses) {
    if (losses.empty())
        return "All of it could be read";
    std::string parts;
    for (const TableLoss& loss : losses.tables)
        parts += (parts.empty() ? "" : ", ") + partOf(loss, losses);
    const std::string saved = parts.empty() ? "All that was found could be read"
                                            : "Saved of it: " + parts + "; everything else is complete";
    return losses.may_have_had_more ? saved + ". The list of what it had is damaged too, so more may be lost"
                                    : saved;
}

}  // namespace

std::string savedText(const TakeLosses& losses) {
    const std::string saved = readText(losses);
    return losses.mended_texts > 0
               ? saved + ". Characters that could not be read were replaced in so many texts: " +
                     std::to_string(losses.mended_texts)
               : saved;
}

}  // namespace noctule
