// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/formats/bvh_reader.h"
#include "core/formats/bvh_words.h"
#include "core/formats/number_text.h"

namespace noctule {
namespace {

constexpr double kShortestFrame_s = 1e-6, kLongestFrame_s = 10;

}  // namespace

Status BvhReader::readMotionHeader() {
    if (Status motion = expect("MOTION"); !motion)
        return motion;
    if (Status frames = expect("Frames"); !frames)
        return frames;
    scan_.accept(":");
    const std::string_view count_text = scan_.word();
    frames_line_ = scan_.line();
    double count = -1;
    if (!parseFiniteNumber(count_text, count) || count < 0 || count > 1e15 || count != std::floor(count))
        return error("Frames is " + inQuotes(count_text), "Write the number of rows that follow");
    document_.declared_frames = static_cast<size_t>(count);
    for (const std::string_view expected : {"Frame", "Time"})
        if (Status read = expect(expected); !read)
            return read;
    scan_.accept(":");
    const std::string_view time_text = scan_.word();
    double& frame_time_s = document_.frame_time_s;
    if (!parseFiniteNumber(time_text, frame_time_s) || frame_time_s < kShortestFrame_s ||
        frame_time_s > kLongestFrame_s)
        return error(
            "Frame Time is " + inQuotes(time_text),
            "Write the seconds from one frame to the next, for example 0.00833333 for 120 frames a second");
    return Done{};
}

/// The declared count only guides: never more than the rest of the file can hold (a number and a blank are
/// two bytes), and one row more than declared, since counts that are one too small are common.
void BvhReader::reserveRows() {
    const size_t possible = scan_.bytesLeft() / 2 + 1;
    const size_t declared_rows = std::min(document_.declared_frames, possible) + 1;
    document_.values.reserve(std::min(possible, declared_rows * document_.channel_count));
}

Status BvhReader::readRows() {
    std::vector<double>& values = document_.values;
    reserveRows();
    while (scan_.toNextRow()) {
        if (document_.channel_count == 0)
            return error("a row of numbers follows, but no joint has CHANNELS", kExportAgain);
        const size_t before = values.size();
        bool cut_short = false;
        if (Status read = readRow(cut_short); !read)
            return read;
        if (cut_short) {
            warn(scan_.line(), "the last row has only " + std::to_string(values.size() - before) + " of " +
                                   std::to_string(document_.channel_count) + " numbers and is left out");
            values.resize(before);
            break;
        }
    }
    if (values.capacity() > 2 * values.size())
        values.shrink_to_fit();
    return judgeFrameCount();
}

Status BvhReader::judgeFrameCount() {
    const size_t frames = document_.frameCount();
    const std::string declared = "Frames is " + std::to_string(document_.declared_frames);
    if (frames == 0 && document_.declared_frames > 0)
        return errorAt(frames_line_, declared + ", but no complete row follows", kExportAgain);
    if (frames != document_.declared_frames)
        warn(frames_line_,
             declared + ", but " + std::to_string(frames) + " complete rows follow; these are used");
    return Done{};
}

/// Appends the numbers of one line. `cut_short`: the text ends inside this row.
Status BvhReader::readRow(bool& cut_short) {
    std::vector<double>& values = document_.values;
    const size_t channels = document_.channel_count;
    size_t count = 0;
    for (; !scan_.atEndOfRow(); ++count) {
        if (count == channels)
            return error("this row has more than " + std::to_string(channels) +
                             " numbers, which the channels add up to",
                         "Write one frame per line with one number per channel");
        double value = 0;
        const char* after = parseNumber(scan_.position(), scan_.end(), value);
        const bool whole =
            after && (after == scan_.end() || BvhScanner::isBlank(*after) || BvhScanner::isLineEnd(*after));
        if (!whole || !isPlausible(value)) {
            const std::string_view word = scan_.wordOfRow();
            cut_short = !whole && scan_.atEnd();
            return cut_short ? Status(Done{}) : badNumber(count, word);
        }
        values.push_back(value);
        scan_.moveTo(after);
    }
    if (count == channels)
        return Done{};
    const size_t line = scan_.line();
    BvhScanner rest = scan_;
    cut_short = !rest.toNextRow();
    if (cut_short)
        return Done{};
    return errorAt(line,
                   "this row has " + std::to_string(count) + " numbers, but the channels add up to " +
                       std::to_string(channels),
                   "Write one frame per line with one number per channel");
}

Error BvhReader::badNumber(size_t index, std::string_view word) const {
    const auto owns = [&](const BvhJoint& j) {
        return index >= j.first_channel && index < j.first_channel + j.channels.size();
    };
    const auto joint = std::find_if(document_.joints.begin(), document_.joints.end(), owns);
    require(joint != document_.joints.end(), "every channel belongs to a joint");
    return error(toText(joint->channels[index - joint->first_channel]) + " of " + joint->name + " (number " +
                     std::to_string(index + 1) + " of the row) is " + inQuotes(word),
                 numberRemedy(word));
}

}  // namespace noctule
