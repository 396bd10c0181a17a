// SPDX-License-Identifier: Apache-2.0
// Expected trouble as a value. An Error says what happened, to which thing by name, and what to do about it;
// its kind is the exit code of the command line. Broken promises of our own throw instead (job/contract.h).
#pragma once

#include <string>
#include <utility>
#include <variant>

#include "core/job/contract.h"

namespace noctule {

/// The value is the documented exit code of `noctule --batch`.
enum class ErrorKind {
    kInternal = 1,    ///< a mistake of ours
    kUsage = 2,       ///< the command line or an argument is wrong
    kUnreadable = 3,  ///< input cannot be read or is not what it should be
    kUnusable = 4,    ///< input is readable but cannot be used for this
    kDevice = 5,
    kDisk = 6,  ///< output cannot be written
    kCancelled = 130,
};

struct Error {
    ErrorKind kind = ErrorKind::kInternal;
    std::string
        message;         ///< what happened, to which thing by name: "take_001.noctule: no board is described"
    std::string remedy;  ///< what to do about it, one sentence; empty only when cancelled
    bool is_damage = false;  ///< a take's database is torn: part of it may still be readable

    /// "message. remedy" as one line for people.
    std::string text() const { return remedy.empty() ? message : message + ". " + remedy; }
};

/// A value or an Error. value() on an error is a broken promise and throws.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::move(value)) {}
    Result(Error error) : content_(std::move(error)) {}

    bool ok() const { return std::holds_alternative<T>(content_); }
    explicit operator bool() const { return ok(); }

    const Error& error() const {
        require(!ok(), "Result::error() without an error");
        return std::get<Error>(content_);
    }
    T& value() & {
        require(ok(), "Result::value() on an error");
        return std::get<T>(content_);
    }
    const T& value() const& {
        require(ok(), "Result::value() on an error");
        return std::get<T>(content_);
    }
    T&& value() && {
        require(ok(), "Result::value() on an error");
        return std::get<T>(std::move(content_));
    }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

private:
    std::variant<T, Error> content_;
};

/// Success without a value.
struct Done {};
using Status = Result<Done>;

}  // namespace noctule
