/// @file
/// JSON text as values, and strict access to them: what is not as expected is refused at its place.
/// Exact   a number is an integer: a JSON integer up to 2^53 or a string of digits; nothing is ever rounded.
/// Errors  Refused: everything, with the value it is about.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tact::check {

inline constexpr std::size_t kMaxBytes = std::size_t{64} << 20;
inline constexpr std::size_t kMaxDepth = 32;
inline constexpr std::size_t kMaxDigits = 100000;

struct Value;
struct Member;
using Array = std::vector<Value>;
using Object = std::vector<Member>;  // in the text's order; keys are distinct

/// A JSON number that is no integer of at most 2^53.
struct OtherNumber {
  std::string text;
};

struct Value {
  std::variant<std::nullptr_t, bool, std::int64_t, OtherNumber, std::string, Array, Object> data;
};

struct Member {
  std::string key;
  Value value;
};

/// Why a text is refused, and the value that is to blame (null: the text as a whole).
class Refused : public std::runtime_error {
 public:
  Refused(const Value* where, const std::string& why) : std::runtime_error(why), where_(where) {}
  const Value* where() const { return where_; }

 private:
  const Value* where_;
};

/// Refused: no JSON, a key twice in one object, or beyond a limit above.
Value ParseJson(std::string_view text);

/// Where a value stands below root, as `relation.contacts[3].planes[0]`; empty for the root and for others.
std::string PathOf(const Value& root, const Value* where);

/// Text from outside as it may be printed: in quotation marks, escaped, cut after some characters.
std::string Quote(std::string_view text);

const Array& AsArray(const Value& value);
const Object& AsObject(const Value& value);
const std::string& AsString(const Value& value);
bool AsBool(const Value& value);
mpz_class AsInteger(const Value& value);
/// An index below size.
std::size_t AsIndex(const Value& value, std::size_t size);
/// A list of exactly size integers.
std::vector<mpz_class> AsIntegers(const Value& value, std::size_t size);

/// Refuses an object with a key missing or with one that is in neither list.
void ExpectKeys(const Value& object, std::initializer_list<std::string_view> required,
                std::initializer_list<std::string_view> optional = {});
/// The member of that name; null if there is none.
const Value* Find(const Value& object, std::string_view key);
/// The member of that name; refuses if there is none.
const Value& At(const Value& object, std::string_view key);

}  // namespace tact::check
