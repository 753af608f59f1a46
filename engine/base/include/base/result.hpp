// A value or the reason why there is none. Used for everything a user's file, device or call can get wrong;
// our own bugs use TY_ASSERT instead.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace tyndall {

/// Who is to blame, which decides the program's exit status.
enum class ErrorKind {
  kFailed,   ///< the call was right, the work failed: exit status 1
  kBadCall,  ///< the call itself was wrong (unknown option, id, level; value out of range): exit status 2
  kUnread,   ///< whoever read the results has gone: exit status 1, and no line, since nobody waits for one
};

/// One line: "<subject>: <what is wrong>; <what would be right>".
struct Error {
  std::string message;
  ErrorKind kind = ErrorKind::kFailed;
};

inline Error failed(std::string message) { return {std::move(message), ErrorKind::kFailed}; }
inline Error badCall(std::string message) { return {std::move(message), ErrorKind::kBadCall}; }

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }
  T& value() { return std::get<0>(state_); }
  const T& value() const { return std::get<0>(state_); }
  T& operator*() { return value(); }
  const T& operator*() const { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  const Error& error() const { return std::get<1>(state_); }
  /// Moves the value out.
  T take() { return std::move(std::get<0>(state_)); }

 private:
  std::variant<T, Error> state_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}

  bool ok() const { return !error_; }
  explicit operator bool() const { return ok(); }
  const Error& error() const { return *error_; }

 private:
  std::optional<Error> error_;
};

}  // namespace tyndall
