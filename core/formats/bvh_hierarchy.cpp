// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/formats/bvh_reader.h"
#include "core/formats/bvh_words.h"
#include "core/formats/number_text.h"
#include "core/job/outside_text.h"

namespace noctule {

Status BvhReader::readHierarchy() {
    if (Status begun = expect("HIERARCHY"); !begun)
        return begun;
    if (Status begun = expect("ROOT"); !begun)
        return begun;
    if (Status opened = openJoint("ROOT"); !opened)
        return opened;
    while (!open_.empty()) {
        const std::string_view keyword = scan_.word();
        if (keyword.empty())
            return error("the file ends inside joint " + innermost().name, kExportAgain);
        if (Status read = readJointLine(keyword); !read)
            return read;
    }
    if (scan_.accept("ROOT"))
        return error("a second ROOT " + inQuotes(scan_.name()) + " begins", "Keep one figure per file");
    return Done{};
}

Status BvhReader::readJointLine(std::string_view keyword) {
    BvhJoint& joint = innermost();
    if (keyword == "}")
        return closeJoint();
    if (sameWord(keyword, "JOINT"))
        return openJoint("JOINT");
    if (sameWord(keyword, "OFFSET")) {
        has_offset_[static_cast<size_t>(open_.back())] = true;
        return readVector(joint.name, joint.offset);
    }
    if (sameWord(keyword, "CHANNELS"))
        return readChannels(joint);
    if (sameWord(keyword, "End"))
        return readEndSite(joint);
    if (sameWord(keyword, "MOTION") || sameWord(keyword, "ROOT"))
        return error(std::string(keyword) + " begins inside joint " + joint.name,
                     "Close every joint with a }");
    return error("joint " + joint.name + " has " + inQuotes(keyword) + " where a keyword should stand",
                 "Use OFFSET, CHANNELS, JOINT, End Site or }; a space may be missing");
}

Status BvhReader::openJoint(const char* keyword) {
    const std::string name = visibleText(scan_.name());  // what is no UTF-8 could be written nowhere
    if (name.empty())
        return error(std::string(keyword) + " has no name",
                     "Write the joint's name behind it on the same line");
    BvhJoint joint;
    joint.name = uniqueName(name);
    joint.parent = open_.empty() ? -1 : open_.back();
    joint.first_channel = document_.channel_count;
    open_.push_back(static_cast<int>(document_.joints.size()));
    document_.joints.push_back(std::move(joint));
    has_offset_.push_back(false);
    return expect("{");
}

Status BvhReader::closeJoint() {
    if (!has_offset_[static_cast<size_t>(open_.back())])
        return error("joint " + innermost().name + " has no OFFSET",
                     "Add a line OFFSET with the joint's place in its parent");
    open_.pop_back();
    return Done{};
}

/// Names must tell joints apart; a repeated one gets a number.
std::string BvhReader::uniqueName(std::string_view name) {
    std::string unique(name);
    for (int n = 2; !names_.insert(unique).second; ++n)
        unique = std::string(name) + "_" + std::to_string(n);
    if (unique != name)
        warn(scan_.line(),
             "a second joint is named " + inQuotes(name) + "; it is called " + unique + " here");
    return unique;
}

Status BvhReader::readChannels(BvhJoint& joint) {
    if (!joint.channels.empty())
        return error("joint " + joint.name + " has CHANNELS twice", "Keep one of the two lines");
    const std::string_view count_text = scan_.word();
    double count = -1;
    if (!parseFiniteNumber(count_text, count) || count != std::floor(count) || count < 0 || count > 6)
        return error("joint " + joint.name + " has " + inQuotes(count_text) + " CHANNELS",
                     "Write a count from 0 to 6, a space and the channels' names");
    joint.first_channel = document_.channel_count;
    for (int n = 0; n < static_cast<int>(count); ++n) {
        const std::string_view text = scan_.word();
        const std::optional<BvhChannel> channel = channelFromText(text);
        if (!channel)
            return error(
                "joint " + joint.name + " has the channel " + inQuotes(text),
                "Use as many of Xposition, Yposition, Zposition, Xrotation, Yrotation and Zrotation as "
                "CHANNELS says");
        if (std::count(joint.channels.begin(), joint.channels.end(), *channel))
            return error("joint " + joint.name + " has the channel " + toText(*channel) + " twice",
                         "Name every channel once");
        joint.channels.push_back(*channel);
    }
    document_.channel_count += joint.channels.size();
    return Done{};
}

Status BvhReader::readEndSite(BvhJoint& joint) {
    if (Status site = expect("Site"); !site)
        return site;
    const size_t line = scan_.line();
    scan_.name();  // some programs name end sites; nobody refers to them
    if (Status opened = expect("{"); !opened)
        return opened;
    Vector3d offset;
    if (!scan_.accept("OFFSET"))
        return errorAt(line, "the End Site of " + joint.name + " has no OFFSET",
                       "Write OFFSET and three numbers into it, and nothing else");
    if (Status read = readVector("the End Site of " + joint.name, offset); !read)
        return read;
    if (joint.end_site)
        warn(line, "joint " + joint.name + " has a second End Site, which is left out");
    else
        joint.end_site = offset;
    return expect("}");
}

Status BvhReader::readVector(const std::string& owner, Vector3d& v) {
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view found = scan_.wordOfRow();
        if (found.empty())
            return error("the OFFSET of " + owner + " has " + std::to_string(axis) + " of 3 numbers",
                         "Write OFFSET and three numbers on one line");
        if (!parseFiniteNumber(found, v[axis]) || !isPlausible(v[axis]))
            return error("the OFFSET of " + owner + " has " + inQuotes(found) + " for a number",
                         numberRemedy(found));
    }
    if (!scan_.atEndOfRow() && *scan_.position() != '}')
        return error("the OFFSET of " + owner + " has more than 3 numbers", "Write OFFSET and three numbers");
    return Done{};
}

}  // namespace noctule
