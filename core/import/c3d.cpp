// SPDX-License-Identifier: Apache-2.0
// C3D: 512-byte blocks of header, parameters and frames, in three processors' numbers and as integers or
// floats. Header and parameters often disagree: parameters are believed first, then the header, then the
// length of the file, and what was done is said. Source: c3d.org, "The C3D File Format".
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>

#include "core/formats/number_text.h"
#include "core/import/markers.h"
#include "core/import/sensor_rows.h"

namespace noctule {

namespace {

constexpr size_t kBlock = 512;
constexpr size_t kMostPoints = 10'000;
constexpr double kFarthestMarker_m = 1000;
enum class Processor { kIntel = 84, kDec = 85, kSgi = 86 };

/// Bytes at offsets, in one processor's order; beyond the end they are 0.
class C3dBytes {
public:
    explicit C3dBytes(std::string_view bytes) : bytes_(bytes) {}
    void processor(Processor processor) { processor_ = processor; }
    size_t size() const { return bytes_.size(); }

    uint8_t byte(size_t at) const { return at < bytes_.size() ? static_cast<uint8_t>(bytes_[at]) : 0; }
    int signedByte(size_t at) const { return static_cast<int8_t>(byte(at)); }
    uint16_t word(size_t at) const {
        const auto [low, high] = processor_ == Processor::kSgi ? std::array<size_t, 2>{at + 1, at}
                                                               : std::array<size_t, 2>{at, at + 1};
        return static_cast<uint16_t>(byte(low) | byte(high) << 8);
    }
    int integer(size_t at) const { return static_cast<int16_t>(word(at)); }
    double real(size_t at) const {
        std::array<uint8_t, 4> b{byte(at), byte(at + 1), byte(at + 2), byte(at + 3)};
        if (processor_ == Processor::kSgi)
            std::reverse(b.begin(), b.end());
        if (processor_ == Processor::kDec)
            b = {b[2], b[3], b[0], b[1]};
        const uint32_t bits =
            uint32_t(b[0]) | uint32_t(b[1]) << 8 | uint32_t(b[2]) << 16 | uint32_t(b[3]) << 24;
        float value;
        std::memcpy(&value, &bits, sizeof value);
        return processor_ == Processor::kDec ? double(value) / 4 : double(value);
    }
    std::string text(size_t at, size_t length) const {
        if (at >= bytes_.size())
            return "";
        std::string found(bytes_.substr(at, length));
        std::erase(found, '\0');
        return std::string(trimmed(found));
    }

private:
    std::string_view bytes_;
    Processor processor_ = Processor::kIntel;
};

/// Names of groups and parameters do not depend on case.
std::string inCapitals(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::toupper(c)); });
    return text;
}

struct C3dParameter {
    int type = 0;  ///< -1 text, 1 byte, 2 integer, 4 float
    std::vector<size_t> dimensions;
    size_t data = 0;  ///< offset

    size_t count() const {
        size_t product = 1;
        for (const size_t d : dimensions)
            product *= d;
        return product;
    }
};

class C3dReader {
public:
    C3dReader(std::string_view bytes, const std::string& where) : bytes_(bytes), where_(where) {}

    Result<MarkerRecording> read(const JobContext& job) {
        if (bytes_.size() < 2 * kBlock || bytes_.byte(1) != 0x50)
            return damaged("is no C3D file: its second byte is not 50 (hexadecimal)");
        readParameters();
        if (Status known = readShape(); !known)
            return known.error();
        return readFrames(job);
    }

private:
    Error damaged(const std::string& what) const {
        return {ErrorKind::kUnreadable, where_ + ": " + what, "Export the markers again"};
    }

    void readParameters() {
        const size_t section = (size_t(std::max<uint8_t>(bytes_.byte(0), 1)) - 1) * kBlock;
        const uint8_t processor = bytes_.byte(section + 3);
        if (processor >= 84 && processor <= 86)
            bytes_.processor(static_cast<Processor>(processor));
        const size_t end =
            std::min(bytes_.size(), section + kBlock * std::max<size_t>(bytes_.byte(section + 2), 1));
        std::map<int, std::string> groups;
        std::vector<std::tuple<int, std::string, C3dParameter>> found;
        for (size_t at = section + 4; at + 2 < end;) {
            const size_t length = size_t(std::abs(bytes_.signedByte(at)));
            const int id = bytes_.signedByte(at + 1);
            if (length == 0 || id == 0)
                break;
            const std::string name = inCapitals(bytes_.text(at + 2, length));
            const size_t offset_at = at + 2 + length;
            if (id < 0)
                groups[-id] = name;
            else
                found.emplace_back(id, name, parameterAt(offset_at + 2));
            const size_t offset = bytes_.word(offset_at);
            if (offset == 0)
                break;
            at = offset_at + offset;
        }
        for (const auto& [group, name, parameter] : found)
            parameters_[groups[group] + ":" + name] = parameter;
    }

    C3dParameter parameterAt(size_t at) const {
        C3dParameter parameter;
        parameter.type = bytes_.signedByte(at);
        const size_t dimensions = std::min<size_t>(bytes_.byte(at + 1), 7);
        for (size_t d = 0; d < dimensions; ++d)
            parameter.dimensions.push_back(bytes_.byte(at + 2 + d));
        parameter.data = at + 2 + dimensions;
        return parameter;
    }

    std::optional<double> number(const char* name, size_t index = 0) const {
        const auto found = parameters_.find(name);
        if (found == parameters_.end() || index >= found->second.count())
            return std::nullopt;
        const C3dParameter& p = found->second;
        const double value = p.type == 4   ? bytes_.real(p.data + 4 * index)
                             : p.type == 2 ? double(bytes_.word(p.data + 2 * index))
                                           : std::nan("");
        return std::isfinite(value) ? std::optional(value) : std::nullopt;
    }

    std::vector<std::string> texts(const std::string& name) const {
        std::vector<std::string> list;
        const auto found = parameters_.find(name);
        if (found == parameters_.end() || found->second.type != -1 || found->second.dimensions.empty())
            return list;
        const size_t length = found->second.dimensions[0];
        const size_t count = length > 0 ? std::min(found->second.count() / length, kMostPoints) : 0;
        for (size_t i = 0; i < count && found->second.data + i * length < bytes_.size(); ++i)
            list.push_back(bytes_.text(found->second.data + i * length, length));
        return list;
    }

    /// What the parameters say, else the header; a difference is said.
    double chosen(const char* name, const char* what, double header, bool header_is_usable) {
        const auto parameter = number(name);
        if (parameter && header_is_usable && std::abs(*parameter - header) > 1e-3 * std::abs(header) + 1e-9)
            markers_.warnings.push_back(where_ + ": the header states " + std::to_string(header) + " " +
                                        what + ", the parameters " + std::to_string(*parameter) +
                                        "; the parameters were believed");
        return parameter.value_or(header);
    }

    Status readShape() {
        const double points = chosen("POINT:USED", "points", bytes_.word(2), true);
        markers_.rate_hz = chosen("POINT:RATE", "frames a second", bytes_.real(20), bytes_.real(20) > 0);
        const double scale = chosen("POINT:SCALE", "as scale", bytes_.real(12), bytes_.real(12) != 0);
        const double start = chosen("POINT:DATA_START", "as first block", bytes_.word(16), true);
        if (!(points >= 1 && points <= double(kMostPoints)))
            return damaged("holds " + std::to_string(points) + " points");
        if (!(markers_.rate_hz >= 1 && markers_.rate_hz <= 100'000))
            return damaged("states no usable rate");
        if (!(start >= 2 && start < 65536) || !std::isfinite(scale) || scale == 0)
            return damaged("does not state where its data begin or their scale");
        points_ = size_t(points);
        scale_ = std::abs(scale);
        floats_ = scale < 0;
        data_ = (size_t(start) - 1) * kBlock;
        frame_bytes_ = (points_ * 4 + bytes_.word(4)) * (floats_ ? 4 : 2);
        readUnit();
        readLabels();
        return Done{};
    }

    void readUnit() {
        const auto units = texts("POINT:UNITS");
        markers_.unit = units.empty() || units[0].empty() ? "mm" : units[0].substr(0, 20);
        if (units.empty() || units[0].empty())
            markers_.warnings.push_back(where_ + ": states no unit; mm was taken");
        metre_ = markers_.unit == "m" ? 1 : markers_.unit == "cm" ? 0.01 : 0.001;
        const auto screen = texts("POINT:Y_SCREEN");
        if (!screen.empty() && screen[0].size() == 2 && screen[0][0] == '+')
            markers_.up = screen[0].substr(1);
    }

    void readLabels() {
        std::vector<std::string> labels = texts("POINT:LABELS");
        for (int more = 2; more <= 40; ++more) {
            const auto next = texts("POINT:LABELS" + std::to_string(more));
            if (next.empty())
                break;
            labels.insert(labels.end(), next.begin(), next.end());
        }
        labels.resize(points_);
        for (size_t i = 0; i < points_; ++i) {
            std::string name = labels[i].substr(labels[i].rfind(':') + 1);
            markers_.names.push_back(name.empty() ? "point " + std::to_string(i + 1) : name);
        }
    }

    size_t statedFrames() const {
        const auto low = number("TRIAL:ACTUAL_END_FIELD"), high = number("TRIAL:ACTUAL_END_FIELD", 1);
        const auto first_low = number("TRIAL:ACTUAL_START_FIELD"),
                   first_high = number("TRIAL:ACTUAL_START_FIELD", 1);
        if (low && first_low) {
            const double last = *low + 65536 * high.value_or(0),
                         first = *first_low + 65536 * first_high.value_or(0);
            if (last >= first)
                return size_t(last - first) + 1;
        }
        for (const char* name : {"POINT:LONG_FRAMES", "POINT:FRAMES"})
            if (const auto frames = number(name); frames && *frames >= 1)
                return size_t(std::min(*frames, 1e9));
        return bytes_.word(8) >= bytes_.word(6) ? size_t(bytes_.word(8) - bytes_.word(6)) + 1 : 0;
    }

    Vector3d pointAt(size_t at) const {
        if (floats_) {
            const double residual = bytes_.real(at + 12);
            const Vector3d p(bytes_.real(at), bytes_.real(at + 4), bytes_.real(at + 8));
            return residual < 0 || !p.allFinite() ? missingVector() : Vector3d(metre_ * p);
        }
        const Vector3d p(bytes_.integer(at), bytes_.integer(at + 2), bytes_.integer(at + 4));
        return bytes_.integer(at + 6) < 0 ? missingVector() : Vector3d(metre_ * scale_ * p);
    }

    Result<MarkerRecording> readFrames(const JobContext& job) {
        const size_t held = bytes_.size() > data_ ? (bytes_.size() - data_) / frame_bytes_ : 0;
        const size_t stated = statedFrames();
        const size_t frames = stated == 0 ? held : std::min(stated, held);
        if (stated != frames)
            markers_.warnings.push_back(where_ + ": states " + std::to_string(stated) + " frames and holds " +
                                        std::to_string(held) + "; " + std::to_string(frames) + " were taken");
        if (frames == 0)
            return damaged("holds no whole frame");
        size_t far = 0;
        for (size_t frame = 0; frame < frames; ++frame) {
            if (frame % 4096 == 0 && job.cancelled())
                return JobContext::cancelledError();
            for (size_t point = 0; point < points_; ++point) {
                Vector3d p = pointAt(data_ + frame * frame_bytes_ + point * 4 * (floats_ ? 4 : 2));
                if (p.allFinite() && p.norm() > kFarthestMarker_m) {
                    p = missingVector();
                    ++far;
                }
                markers_.p_m.push_back(p);
            }
        }
        if (far > 0)
            markers_.warnings.push_back(where_ + ": " + std::to_string(far) +
                                        " places are farther than 1 km and were left out; check the unit");
        return std::move(markers_);
    }

    C3dBytes bytes_;
    const std::string& where_;
    std::map<std::string, C3dParameter> parameters_;
    size_t points_ = 0, data_ = 0, frame_bytes_ = 1;
    double scale_ = 1, metre_ = 0.001;
    bool floats_ = false;
    MarkerRecording markers_;
};

}  // namespace

Result<MarkerRecording> parseC3d(std::string_view bytes, const std::string& where, const JobContext& job) {
    // Some old files have zero bytes before the header.
    const size_t begin = bytes.find_first_not_of('\0');
    if (begin != std::string_view::npos && begin > 0 && begin % kBlock == 0)
        bytes.remove_prefix(begin);
    return C3dReader(bytes, where).read(job);
}

}  // namespace noctule
