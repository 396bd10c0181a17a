// SPDX-License-Identifier: Apache-2.0
#include "core/formats/bvh_scanner.h"

#include <algorithm>

#include "core/formats/number_text.h"

namespace noctule {
namespace {

char lowered(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool standsAlone(char c) {
    return c == '{' || c == '}' || c == ':';
}

std::string_view between(const char* begin, const char* end) {
    return {begin, static_cast<size_t>(end - begin)};
}

}  // namespace

void BvhScanner::skipSpace() {
    for (; at_ != end_ && (isBlank(*at_) || isLineEnd(*at_)); ++at_)
        if (*at_ == '\n' || (*at_ == '\r' && (at_ + 1 == end_ || at_[1] != '\n')))
            ++line_;
}

std::string_view BvhScanner::word() {
    skipSpace();
    const char* begin = at_;
    if (at_ != end_ && standsAlone(*at_))
        ++at_;
    else
        at_ = std::find_if(at_, end_, [](char c) { return isBlank(c) || isLineEnd(c) || standsAlone(c); });
    return between(begin, at_);
}

std::string_view BvhScanner::name() {
    const char* begin = at_;
    at_ = std::find_if(at_, end_, [](char c) { return isLineEnd(c) || c == '{'; });
    return trimmed(between(begin, at_));
}

bool BvhScanner::accept(std::string_view expected) {
    const BvhScanner before = *this;
    if (sameWord(word(), expected))
        return true;
    *this = before;
    return false;
}

bool BvhScanner::toNextRow() {
    skipSpace();
    return at_ != end_;
}

std::string_view BvhScanner::wordOfRow() {
    if (atEndOfRow())
        return {};
    const char* begin = at_;
    at_ = std::find_if(at_, end_, [](char c) { return isBlank(c) || isLineEnd(c) || c == '}'; });
    return between(begin, at_);
}

bool sameWord(std::string_view a, std::string_view b) {
    return a.size() == b.size() &&
           std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) { return lowered(x) == lowered(y); });
}

}  // namespace noctule
