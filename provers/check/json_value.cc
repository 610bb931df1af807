#include "provers/check/json_value.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace tact::check {
namespace {

constexpr std::int64_t kMaxJsonInteger = std::int64_t{1} << 53;
constexpr std::size_t kMaxQuoted = 60;

// Builds the tree from the reader's events; the path from the root to the open container is on the stack.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool null() override { return Put({nullptr}); }
  bool boolean(bool b) override { return Put({b}); }
  bool number_integer(number_integer_t n) override {
    return n < -kMaxJsonInteger ? Put({OtherNumber{std::to_string(n)}}) : Put({std::int64_t{n}});
  }
  bool number_unsigned(number_unsigned_t n) override {
    return n > static_cast<number_unsigned_t>(kMaxJsonInteger) ? Put({OtherNumber{std::to_string(n)}})
                                                               : Put({static_cast<std::int64_t>(n)});
  }
  bool number_float(number_float_t, const string_t& text) override { return Put({OtherNumber{text}}); }
  bool string(string_t& text) override { return Put({std::move(text)}); }
  bool binary(binary_t&) override { return Stop("binary data"); }
  bool start_object(std::size_t) override { return Open({Object()}); }
  bool key(string_t& text) override {
    std::get<Object>(open_.back()->data).push_back({std::move(text), Value{nullptr}});
    return true;
  }
  bool end_object() override {
    const Object& object = std::get<Object>(open_.back()->data);
    std::vector<std::string_view> keys;
    for (const auto& [key, value] : object) keys.push_back(key);
    std::sort(keys.begin(), keys.end());
    const auto twice = std::adjacent_find(keys.begin(), keys.end());
    if (twice != keys.end()) return Stop("the key " + Quote(*twice) + " stands twice in one object");
    open_.pop_back();
    return true;
  }
  bool start_array(std::size_t) override { return Open({Array()}); }
  bool end_array() override {
    open_.pop_back();
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception& error) override {
    const std::string_view what = error.what();  // "[json.exception.parse_error.101] parse error at ..."
    const std::size_t prefix = what.find("] ");
    const std::string_view text = prefix == what.npos ? what : what.substr(prefix + 2);
    std::string printable(text.substr(0, 200));
    for (char& c : printable) c = c >= ' ' && c <= '~' ? c : '?';
    return Stop("no JSON: " + printable);
  }

  Value root{nullptr};
  std::string why;

 private:
  bool Stop(std::string reason) {
    why = std::move(reason);
    return false;
  }
  Value* Place(Value value) {
    if (open_.empty()) {
      root = std::move(value);
      return &root;
    }
    if (Array* array = std::get_if<Array>(&open_.back()->data)) return &array->emplace_back(std::move(value));
    Value& member = std::get<Object>(open_.back()->data).back().value;
    member = std::move(value);
    return &member;
  }
  bool Put(Value value) {
    Place(std::move(value));
    return true;
  }
  bool Open(Value value) {
    if (open_.size() == kMaxDepth) return Stop("nested deeper than " + std::to_string(kMaxDepth) + " levels");
    open_.push_back(Place(std::move(value)));
    return true;
  }

  std::vector<Value*> open_;
};

std::string Describe(const Value& value) {
  static const char* const kNames[] = {"null", "a boolean", "an integer", "", "", "a list", "an object"};
  if (const auto* number = std::get_if<OtherNumber>(&value.data))
    return "the number " + number->text.substr(0, kMaxQuoted);
  if (const auto* text = std::get_if<std::string>(&value.data)) return Quote(*text);
  return kNames[value.data.index()];
}

template <typename T>
const T& As(const Value& value, const char* expected) {
  if (const T* data = std::get_if<T>(&value.data)) return *data;
  throw Refused(&value, std::string("expected ") + expected + ", got " + Describe(value));
}

bool IsDecimal(std::string_view text) {
  if (text == "0") return true;
  if (text.starts_with('-')) text.remove_prefix(1);
  return !text.empty() && text[0] != '0' &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool IsName(std::string_view key) {
  return key.size() <= kMaxQuoted && std::all_of(key.begin(), key.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
         });
}

bool FindPath(const Value& root, const Value* where, std::string& path) {
  if (&root == where) return true;
  const std::size_t length = path.size();
  if (const Array* array = std::get_if<Array>(&root.data)) {
    for (std::size_t i = 0; i < array->size(); ++i) {
      path += "[" + std::to_string(i) + "]";
      if (FindPath((*array)[i], where, path)) return true;
      path.resize(length);
    }
  } else if (const Object* object = std::get_if<Object>(&root.data)) {
    for (const auto& [key, value] : *object) {
      path += (path.empty() ? "" : ".") + (IsName(key) ? key : Quote(key));
      if (FindPath(value, where, path)) return true;
      path.resize(length);
    }
  }
  return false;
}

}  // namespace

Value ParseJson(std::string_view text) {
  if (text.size() > kMaxBytes) {
    throw Refused(nullptr, "longer than " + std::to_string(kMaxBytes) + " bytes");
  }
  if (text.find('\0') != text.npos) {  // the reader would take it for the end and skip the rest
    throw Refused(nullptr, "no JSON: a zero byte");
  }
  TreeBuilder builder;
  if (!nlohmann::json::sax_parse(text.begin(), text.end(), &builder)) throw Refused(nullptr, builder.why);
  return std::move(builder.root);
}

std::string PathOf(const Value& root, const Value* where) {
  std::string path;
  return where != nullptr && FindPath(root, where, path) ? path : "";
}

std::string Quote(std::string_view text) {
  const nlohmann::json quoted = std::string(text.substr(0, kMaxQuoted));
  return quoted.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace) +
         (text.size() > kMaxQuoted ? "..." : "");
}

const Array& AsArray(const Value& value) { return As<Array>(value, "a list"); }
const Object& AsObject(const Value& value) { return As<Object>(value, "an object"); }
const std::string& AsString(const Value& value) { return As<std::string>(value, "a string"); }
bool AsBool(const Value& value) { return As<bool>(value, "true or false"); }

mpz_class AsInteger(const Value& value) {
  if (const auto* number = std::get_if<std::int64_t>(&value.data))
    return mpz_class(static_cast<long>(*number));
  const auto* text = std::get_if<std::string>(&value.data);
  if (text == nullptr || !IsDecimal(*text)) {
    throw Refused(&value, "expected an integer (beyond 2^53: a string of digits), got " + Describe(value));
  }
  if (text->size() > kMaxDigits) {
    throw Refused(&value, "an integer of more than " + std::to_string(kMaxDigits) + " digits");
  }
  return mpz_class(*text, 10);
}

std::size_t AsIndex(const Value& value, std::size_t size) {
  const mpz_class index = AsInteger(value);
  if (index < 0 || index >= size) {
    throw Refused(&value, "expected an index from 0 to " + std::to_string(size) + " exclusive");
  }
  return index.get_ui();
}

std::vector<mpz_class> AsIntegers(const Value& value, std::size_t size) {
  const Array& array = AsArray(value);
  if (array.size() != size) {
    throw Refused(&value,
                  "expected " + std::to_string(size) + " integers, got " + std::to_string(array.size()));
  }
  std::vector<mpz_class> integers;
  integers.reserve(size);
  for (const Value& entry : array) integers.push_back(AsInteger(entry));
  return integers;
}

void ExpectKeys(const Value& object, std::initializer_list<std::string_view> required,
                std::initializer_list<std::string_view> optional) {
  const auto holds = [](const auto& list, std::string_view key) {
    return std::find(list.begin(), list.end(), key) != list.end();
  };
  for (const auto& [key, value] : AsObject(object)) {
    if (!holds(required, key) && !holds(optional, key)) throw Refused(&object, "unknown key " + Quote(key));
  }
  for (std::string_view key : required) At(object, key);
}

const Value* Find(const Value& object, std::string_view key) {
  for (const auto& [name, value] : AsObject(object)) {
    if (name == key) return &value;
  }
  return nullptr;
}

const Value& At(const Value& object, std::string_view key) {
  if (const Value* value = Find(object, key)) return *value;
  throw Refused(&object, "the key " + Quote(key) + " is missing");
}

}  // namespace tact::check
