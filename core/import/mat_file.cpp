// SPDX-License-Identifier: Apache-2.0
#include "core/import/mat_file.h"

#include <zlib.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

namespace noctule {

namespace {

enum MatType {
    kInt8 = 1,
    kUint8 = 2,
    kInt16 = 3,
    kUint16 = 4,
    kInt32 = 5,
    kUint32 = 6,
    kSingle = 7,
    kDouble = 9,
    kInt64 = 12,
    kUint64 = 13,
    kMatrix = 14,
    kCompressed = 15
};

constexpr uint32_t kStructClass = 2, kFirstNumericClass = 6, kLastNumericClass = 15;
constexpr uint32_t kComplexFlag = 0x0800;
constexpr size_t kHeaderBytes = 128;

/// What is wrong in the file; becomes the error of parseMat.
struct MatFault {
    std::string what;
};

struct MatElement {
    uint32_t type = 0;
    std::string_view data;
};

/// Goes through elements one after the other. `swap`: the file was written on a machine of the other byte
/// order.
class MatCursor {
public:
    MatCursor(std::string_view bytes, bool swap) : bytes_(bytes), swap_(swap) {}

    bool atEnd() const { return bytes_.size() - at_ < 8; }

    MatElement next() {
        const uint32_t first = number<uint32_t>(at_);
        if (first >> 16 != 0)
            return small(first);
        const uint32_t size = number<uint32_t>(at_ + 4);
        if (size > bytes_.size() - at_ - 8)
            throw MatFault{"an element of " + std::to_string(size) + " bytes is cut off"};
        const MatElement element{first, bytes_.substr(at_ + 8, size)};
        const size_t padding = first == kCompressed ? 0 : (8 - size % 8) % 8;
        at_ = std::min(bytes_.size(), at_ + 8 + size + padding);
        return element;
    }

    bool swap() const { return swap_; }

private:
    template <class T>
    T number(size_t at) const {
        if (at > bytes_.size() || bytes_.size() - at < sizeof(T))
            throw MatFault{"an element's header is cut off"};
        std::array<char, sizeof(T)> raw;
        std::memcpy(raw.data(), bytes_.data() + at, sizeof(T));
        if (swap_)
            std::reverse(raw.begin(), raw.end());
        return std::bit_cast<T>(raw);
    }
    MatElement small(uint32_t first) {
        const size_t size = first >> 16;
        if (size > 4 || bytes_.size() - at_ < 8)
            throw MatFault{"a small element claims " + std::to_string(size) + " bytes; at most 4 fit"};
        const MatElement element{first & 0xFFFF, bytes_.substr(at_ + 4, size)};
        at_ += 8;
        return element;
    }

    std::string_view bytes_;
    size_t at_ = 0;
    bool swap_;
};

template <class T>
void appendNumbers(std::string_view data, bool swap, std::vector<double>& out) {
    for (size_t i = 0; i + sizeof(T) <= data.size(); i += sizeof(T)) {
        std::array<char, sizeof(T)> raw;
        std::memcpy(raw.data(), data.data() + i, sizeof(T));
        if (swap)
            std::reverse(raw.begin(), raw.end());
        out.push_back(static_cast<double>(std::bit_cast<T>(raw)));
    }
}

std::vector<double> numbersOf(const MatElement& element, bool swap) {
    std::vector<double> out;
    switch (element.type) {
        case kInt8:
            appendNumbers<int8_t>(element.data, swap, out);
            break;
        case kUint8:
            appendNumbers<uint8_t>(element.data, swap, out);
            break;
        case kInt16:
            appendNumbers<int16_t>(element.data, swap, out);
            break;
        case kUint16:
            appendNumbers<uint16_t>(element.data, swap, out);
            break;
        case kInt32:
            appendNumbers<int32_t>(element.data, swap, out);
            break;
        case kUint32:
            appendNumbers<uint32_t>(element.data, swap, out);
            break;
        case kSingle:
            appendNumbers<float>(element.data, swap, out);
            break;
        case kDouble:
            appendNumbers<double>(element.data, swap, out);
            break;
        case kInt64:
            appendNumbers<int64_t>(element.data, swap, out);
            break;
        case kUint64:
            appendNumbers<uint64_t>(element.data, swap, out);
            break;
        default:
            throw MatFault{"numbers of the unknown type " + std::to_string(element.type)};
    }
    return out;
}

class MatReader {
public:
    MatReader(const MatLimits& limits, bool swap) : limits_(limits), swap_(swap) {}

    MatArrays read(std::string_view bytes) {
        MatCursor cursor(bytes, swap_);
        while (!cursor.atEnd())
            readElement(cursor.next(), "", 0);
        return std::move(arrays_);
    }

private:
    void readElement(const MatElement& element, const std::string& prefix, int depth) {
        if (element.type == kCompressed) {
            const std::string unpacked = inflateAll(element.data);
            MatCursor inner(unpacked, swap_);
            if (!inner.atEnd())
                readElement(inner.next(), prefix, depth);
        } else if (element.type == kMatrix && !element.data.empty()) {
            readMatrix(element.data, prefix, depth);
        }
    }

    void readMatrix(std::string_view bytes, const std::string& given_name, int depth) {
        if (depth > limits_.nesting)
            throw MatFault{"structs are nested deeper than " + std::to_string(limits_.nesting)};
        MatCursor cursor(bytes, swap_);
        const auto flags = numbersOf(cursor.next(), swap_);
        const auto dimensions = numbersOf(cursor.next(), swap_);
        const std::string own_name(cursor.next().data);
        if (flags.empty() || dimensions.size() < 2)
            throw MatFault{"an array without flags or dimensions"};
        const std::string name = given_name.empty() ? own_name : given_name;
        const uint32_t kind = static_cast<uint32_t>(flags[0]) & 0xFF;
        if (kind == kStructClass)
            readStruct(cursor, dimensions, name, depth);
        else if (kind >= kFirstNumericClass && kind <= kLastNumericClass &&
                 !(static_cast<uint32_t>(flags[0]) & kComplexFlag))
            arrays_[name] = matrixOf(numbersOf(cursor.next(), swap_), dimensions, name);
    }

    static Eigen::MatrixXd matrixOf(const std::vector<double>& values, const std::vector<double>& dimensions,
                                    const std::string& name) {
        double count = 1;
        for (const double d : dimensions)
            count *= d;
        if (count != static_cast<double>(values.size()))
            throw MatFault{"array " + name + " holds " + std::to_string(values.size()) +
                           " numbers, its dimensions ask for another count"};
        const auto rows = static_cast<Eigen::Index>(dimensions[0]);
        if (rows == 0)
            return {};
        return Eigen::Map<const Eigen::MatrixXd>(values.data(), rows, Eigen::Index(values.size()) / rows);
    }

    void readStruct(MatCursor& cursor, const std::vector<double>& dimensions, const std::string& name,
                    int depth) {
        const auto length = numbersOf(cursor.next(), swap_);
        const std::string_view names = cursor.next().data;
        if (length.empty() || length[0] < 1 || dimensions[0] * dimensions[1] != 1)
            return;  // arrays of structs have no one name
        const auto each = static_cast<size_t>(length[0]);
        for (size_t at = 0; at + each <= names.size() && !cursor.atEnd(); at += each) {
            const std::string member(names.substr(at, std::min(each, names.substr(at).find('\0'))));
            readElement(cursor.next(), name.empty() ? member : name + "." + member, depth + 1);
        }
    }

    std::string inflateAll(std::string_view packed) {
        z_stream stream{};
        if (inflateInit(&stream) != Z_OK)
            throw MatFault{"the decompressor does not start"};
        std::string out;
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
        stream.avail_in = static_cast<uInt>(packed.size());
        int state = Z_OK;
        while (state == Z_OK && unpacked_ <= limits_.unpacked_bytes) {
            std::array<char, 1 << 16> piece;
            stream.next_out = reinterpret_cast<Bytef*>(piece.data());
            stream.avail_out = piece.size();
            state = inflate(&stream, Z_NO_FLUSH);
            out.append(piece.data(), piece.size() - stream.avail_out);
            unpacked_ += piece.size() - stream.avail_out;
        }
        inflateEnd(&stream);
        if (unpacked_ > limits_.unpacked_bytes)
            throw MatFault{"it unpacks to more than " + std::to_string(limits_.unpacked_bytes >> 20) +
                           " MiB"};
        if (state != Z_STREAM_END)
            throw MatFault{"a compressed array is damaged or cut off"};
        return out;
    }

    MatLimits limits_;
    bool swap_;
    size_t unpacked_ = 0;
    MatArrays arrays_;
};

Error matError(const std::string& name, const std::string& what, const std::string& remedy) {
    return {ErrorKind::kUnreadable, name + ": " + what, remedy};
}

}  // namespace

Result<MatArrays> parseMat(std::string_view bytes, const std::string& name, const MatLimits& limits) {
    const std::string save_again = "Save it again in MATLAB or Octave with -v7";
    if (bytes.substr(0, 4) == "\x89HDF" || (bytes.size() > 516 && bytes.substr(512, 4) == "\x89HDF"))
        return matError(name, "this is a MATLAB file of version 7.3 (HDF5), which is not read", save_again);
    if (bytes.size() < kHeaderBytes)
        return matError(name, "this is no MATLAB file: it is too short", "Choose a .mat file of level 5");
    const std::string_view order = bytes.substr(126, 2);
    const bool little = order == "IM", big = order == "MI";
    if (!little && !big)
        return matError(name, "this is no MATLAB file of level 5: the byte order mark is missing",
                        save_again);
    const bool swap = big == (std::endian::native == std::endian::little);
    try {
        return MatReader(limits, swap).read(bytes.substr(kHeaderBytes));
    } catch (const MatFault& fault) {
        return matError(name, fault.what, "Copy the file again, or save it again with -v7");
    }
}

}  // namespace noctule
