#include "enumerators/dof_counts_text.h"

#include <charconv>

#include "algebra/error.h"
#include "enumerators/dof_class.h"
#include "enumerators/run_folder.h"

namespace tact::enumerators {
namespace {

using algebra::MotionDof;

template <typename Number>
std::string List(const std::vector<Number>& numbers) {
  std::string text = "[";
  for (const Number n : numbers) text += (text.size() > 1 ? "," : "") + std::to_string(n);
  return text + "]";
}

// The indices that follow from the ten.
MotionDof FromValues(const std::vector<int>& v) {
  MotionDof dof;
  dof.translation = {v[0], v[1], v[2], 3 - v[0]};
  dof.rotation = {v[3], v[4] + v[5], v[4], v[5], v[6], 3 - v[3]};
  dof.all = {v[7], v[8], v[9], 6 - v[7]};
  return dof;
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  DofCounts Read() {
    DofCounts counts;
    Expect("[");
    while (!Take("]")) {
      Expect(counts.empty() ? "\n{\"values\":" : ",\n{\"values\":");
      DofCount count;
      const std::vector<int> values = Numbers<int>();
      if (values.size() != DofDefinitions().back().indices.size()) Refuse("ten DOF indices");
      count.dof = FromValues(values);
      Expect(",\"count\":");
      count.count = Number<uint64_t>();
      Expect(",\"witness\":");
      count.witness = Numbers<size_t>();
      Expect("}");
      if (!counts.empty() && !(counts.back().dof < count.dof)) Refuse("classes by increasing DOFs");
      counts.push_back(std::move(count));
    }
    if (at_ != text_.size()) Refuse("the end");
    return counts;
  }

 private:
  bool Take(std::string_view expected) {
    if (text_.substr(at_, expected.size()) != expected) return false;
    at_ += expected.size();
    return true;
  }
  void Expect(std::string_view expected) {
    if (!Take(expected)) Refuse("'" + std::string(expected) + "'");
  }
  template <typename T>
  T Number() {
    T number{};
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), number);
    if (error != std::errc() || number < T{0}) Refuse("a count");
    at_ = static_cast<size_t>(end - text_.data());
    return number;
  }
  template <typename T>
  std::vector<T> Numbers() {
    std::vector<T> numbers;
    Expect("[");
    while (!Take("]")) {
      if (!numbers.empty()) Expect(",");
      numbers.push_back(Number<T>());
    }
    return numbers;
  }
  [[noreturn]] void Refuse(const std::string& expected) const {
    throw InputError("byte " + std::to_string(at_ + 1) + " of the counts: expected " + expected + ", got '" +
                     std::string(text_.substr(at_, 20)) + "'");
  }

  std::string_view text_;
  size_t at_ = 0;
};

}  // namespace

std::string ToText(const DofCounts& counts) {
  std::string text = "[";
  for (const DofCount& c : counts) {
    text += text.size() > 1 ? ",\n" : "\n";
    text += "{\"values\":" + List(IndexValues(c.dof, DofDefinitions().back())) +
            ",\"count\":" + std::to_string(c.count) + ",\"witness\":" + List(c.witness) + "}";
  }
  return text + "]";
}

DofCounts ParseDofCounts(std::string_view text) { return Reader(text).Read(); }

std::string DescribeCensus(const DofCensus& census, const std::string& world, const std::string& version) {
  std::string contacts;
  for (const algebra::Contact& contact : census.world().contacts) {
    for (const algebra::Vector3& v : {contact.point, contact.planes[0]})
      contacts += v.x.ToString() + " " + v.y.ToString() + " " + v.z.ToString() + "\n";
  }
  return R"({"kind":"dof-classes","version":")" + version + R"(","world":")" + world + R"(","contacts":)" +
         std::to_string(census.world().contacts.size()) + R"(,"contacts_digest":")" + Digest(contacts) +
         R"(","largest":)" + std::to_string(census.world().largest) + R"(,"relations":)" +
         std::to_string(census.relations()) + R"(,"relations_in_a_unit":)" +
         std::to_string(DofCensus::kUnitSize) + "}";
}

}  // namespace tact::enumerators
