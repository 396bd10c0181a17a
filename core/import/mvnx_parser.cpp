// SPDX-License-Identifier: Apache-2.0
// expat calls back for every element; nothing but the wanted children of frames is kept.
#include <expat.h>

#include <algorithm>
#include <memory>
#include <set>

#include "core/formats/number_text.h"
#include "core/import/column_text.h"
#include "core/import/mvnx.h"

namespace noctule {

namespace {

constexpr int kPieceBytes = 1 << 20;
constexpr size_t kMostSegments = 256, kMostNames = 1024;
constexpr size_t kLongestElement = size_t{1} << 20;
constexpr size_t kMostMvnxFrames = 20'000'000;

/// "mvnx:frame" -> "frame".
std::string_view localName(const char* name) {
    const std::string_view whole(name);
    const size_t colon = whole.rfind(':');
    return colon == std::string_view::npos ? whole : whole.substr(colon + 1);
}

std::string attributeOf(const char** attributes, std::string_view name) {
    for (; *attributes; attributes += 2)
        if (localName(attributes[0]) == name)
            return std::string(attributes[1]).substr(0, 200);
    return "";
}

double numberOf(const std::string& text, double otherwise) {
    double value = 0;
    return parseFiniteNumber(trimmed(text), value) ? value : otherwise;
}

std::string segmentOf(const std::string& connector) {
    return connector.substr(0, connector.find('/'));
}

class MvnxReader {
public:
    explicit MvnxReader(const std::string& where) : where_(where) {}

    void begin(std::string_view name, const char** attributes) {
        text_.clear();
        if (name == "mvnx") {
            is_mvnx_ = true;
            file_.version = attributeOf(attributes, "version");
        } else if (name == "subject") {
            file_.rate_hz = numberOf(attributeOf(attributes, "frameRate"), 0);
        } else if (name == "segments" || name == "sensors" || name == "joints") {
            list_ = name;
        } else if (name == "segment" && list_ == "segments") {
            file_.segments.push_back(attributeOf(attributes, "label"));
        } else if (name == "sensor" && list_ == "sensors") {
            file_.sensors.push_back(attributeOf(attributes, "label"));
        } else if (name == "joint" && list_ == "joints") {
            file_.joints.push_back({attributeOf(attributes, "label"), "", ""});
        } else if (name == "frame") {
            in_frame_ = true;
            frame_ = {};
            frame_.type = attributeOf(attributes, "type");
            frame_.index = numberOf(attributeOf(attributes, "index"), -1);
            frame_.time_ms = numberOf(attributeOf(attributes, "time"), -1);
        }
        wants_text_ = (in_frame_ && target(name)) || isConnector(name);
        if (file_.segments.size() > kMostSegments || file_.sensors.size() > kMostSegments ||
            file_.joints.size() > kMostNames || file_.frames.size() > kMostMvnxFrames)
            fail("it has more segments, sensors, joints or frames than any suit");
    }

    void characters(const char* text, int length) {
        if (!wants_text_)
            return;
        text_.append(text, static_cast<size_t>(length));
        if (text_.size() > kLongestElement)
            fail("an element of frame " + std::to_string(file_.frames.size()) + " never ends");
    }

    void end(std::string_view name) {
        if (isConnector(name) && !file_.joints.empty())
            (name == "connector1" ? file_.joints.back().parent : file_.joints.back().child) =
                segmentOf(text_);
        else if (name == list_)
            list_.clear();
        else if (name == "frame")
            endFrame();
        else if (in_frame_)
            endElement(name);
        wants_text_ = false;
    }

    void fail(const std::string& what) {
        if (problem_.empty())
            problem_ = what;
        if (parser_)
            XML_StopParser(parser_, XML_FALSE);
    }
    Error error(const std::string& what) const {
        return {ErrorKind::kUnreadable, where_ + ": " + what, "Export the recording as MVNX again"};
    }

    Result<MvnxFile> parse(std::string_view bytes, const JobContext& job);

private:
    bool isConnector(std::string_view name) const {
        return list_ == "joints" && (name == "connector1" || name == "connector2");
    }
    std::vector<double>* target(std::string_view name) {
        return name == "orientation"              ? &frame_.orientation
               : name == "position"               ? &frame_.position
               : name == "sensorOrientation"      ? &frame_.sensor_orientation
               : name == "sensorFreeAcceleration" ? &frame_.free_acceleration
               : name == "sensorMagneticField"    ? &frame_.magnetic_field
                                                  : nullptr;
    }

    void endElement(std::string_view name) {
        std::vector<double>* numbers = target(name);
        if (!numbers) {
            if (unread_.size() < kMostNames && unread_.insert(std::string(name)).second)
                file_.unread.emplace_back(name);
            return;
        }
        numbers->clear();
        const char *at = text_.data(), *end = at + text_.size();
        while (true) {
            while (at != end && static_cast<unsigned char>(*at) <= ' ')
                ++at;
            if (at == end)
                break;
            const char* stop = at;
            while (stop != end && static_cast<unsigned char>(*stop) > ' ')
                ++stop;
            double value = 0;
            if (!readCell({at, size_t(stop - at)}, false, value))
                return fail("frame " + std::to_string(file_.frames.size()) + ", " + std::string(name) + ": " +
                            inQuotes({at, size_t(stop - at)}) + " is no number");
            numbers->push_back(value);
            at = stop;
        }
        const bool of_sensors = name.starts_with("sensor");
        const size_t parts = of_sensors ? file_.sensors.size() : file_.segments.size();
        const size_t each = name == "orientation" || name == "sensorOrientation" ? 4 : 3;
        if (!numbers->empty() && numbers->size() != parts * each)
            fail("frame " + std::to_string(file_.frames.size()) + ", " + std::string(name) + ": " +
                 std::to_string(numbers->size()) + " numbers instead of " + std::to_string(parts * each));
    }

    void endFrame() {
        in_frame_ = false;
        if (frame_.type.empty() || frame_.type == "normal")
            file_.frames.push_back(std::move(frame_));
        else if (file_.poses.size() < 16)
            file_.poses.push_back(std::move(frame_));
    }

    const std::string& where_;
    MvnxFile file_;
    MvnxFrame frame_;
    std::string list_;  ///< of the body that is being read: fingers have segments and joints of their own
    std::set<std::string> unread_;
    std::string text_, problem_;
    XML_Parser parser_ = nullptr;
    bool is_mvnx_ = false, in_frame_ = false, wants_text_ = false;
};

void XMLCALL beginElement(void* reader, const XML_Char* name, const XML_Char** attributes) {
    static_cast<MvnxReader*>(reader)->begin(localName(name), attributes);
}
void XMLCALL endElementOf(void* reader, const XML_Char* name) {
    static_cast<MvnxReader*>(reader)->end(localName(name));
}
void XMLCALL charactersOf(void* reader, const XML_Char* text, int length) {
    static_cast<MvnxReader*>(reader)->characters(text, length);
}
void XMLCALL doctypeOf(void* reader, const XML_Char*, const XML_Char*, const XML_Char*, int) {
    static_cast<MvnxReader*>(reader)->fail("it declares a document type, which MVNX files do not have");
}

Result<MvnxFile> MvnxReader::parse(std::string_view bytes, const JobContext& job) {
    const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser(
        XML_ParserCreate(nullptr), &XML_ParserFree);
    parser_ = parser.get();
    XML_SetUserData(parser_, this);
    XML_SetElementHandler(parser_, beginElement, endElementOf);
    XML_SetCharacterDataHandler(parser_, charactersOf);
    XML_SetStartDoctypeDeclHandler(parser_, doctypeOf);
    const size_t all = bytes.size();
    while (true) {
        const std::string_view piece = bytes.substr(0, kPieceBytes);
        bytes.remove_prefix(piece.size());
        const auto status = XML_Parse(parser_, piece.data(), int(piece.size()), bytes.empty());
        if (!problem_.empty())
            return error(problem_);
        if (status != XML_STATUS_OK) {
            const XML_Error code = XML_GetErrorCode(parser_);
            const bool ended = code == XML_ERROR_NO_ELEMENTS || code == XML_ERROR_UNCLOSED_TOKEN ||
                               code == XML_ERROR_PARTIAL_CHAR;
            file_.cut = bytes.empty() && ended && is_mvnx_ && !file_.frames.empty();
            if (!file_.cut)
                return error("line " + std::to_string(XML_GetCurrentLineNumber(parser_)) + ": " +
                             XML_ErrorString(code));
        }
        if (bytes.empty())
            break;
        if (job.cancelled())
            return JobContext::cancelledError();
        job.progress(1 - double(bytes.size()) / double(all), "Reading");
    }
    if (!is_mvnx_)
        return error("it is XML, but no MVNX");
    return std::move(file_);
}

}  // namespace

Result<MvnxFile> parseMvnx(std::string_view bytes, const std::string& where, const JobContext& job) {
    return MvnxReader(where).parse(bytes, job);
}

}  // namespace noctule
