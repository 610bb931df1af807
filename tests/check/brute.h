/// @file
/// Whether a small certificate is right, by brute force: ranks as sizes of the largest non-zero minor, 64-bit
/// numbers. Shares nothing with the checker. Numbers may be wrong here, the shape may not.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace tact::check::brute {

using nlohmann::json;
using Row = std::vector<long long>;
using Rows = std::vector<Row>;

inline long long Minor(const Rows& m, const std::vector<int>& rows, const std::vector<int>& columns) {
  if (rows.empty()) return 1;
  long long sum = 0, sign = 1;
  const std::vector<int> below(rows.begin() + 1, rows.end());
  for (std::size_t i = 0; i < columns.size(); ++i, sign = -sign) {
    std::vector<int> others = columns;
    others.erase(others.begin() + static_cast<long>(i));
    if (m[rows[0]][columns[i]] != 0) sum += sign * m[rows[0]][columns[i]] * Minor(m, below, others);
  }
  return sum;
}

inline std::vector<std::vector<int>> Subsets(int n, int size) {
  std::vector<std::vector<int>> subsets;
  for (int bits = 0; bits < (1 << n); ++bits) {
    std::vector<int> subset;
    for (int i = 0; i < n; ++i) {
      if (bits >> i & 1) subset.push_back(i);
    }
    if (static_cast<int>(subset.size()) == size) subsets.push_back(subset);
  }
  return subsets;
}

inline int Rank(const Rows& m) {
  if (m.empty()) return 0;
  const int height = static_cast<int>(m.size()), width = static_cast<int>(m[0].size());
  for (int rank = std::min(height, width); rank > 0; --rank) {
    for (const auto& rows : Subsets(height, rank)) {
      for (const auto& columns : Subsets(width, rank)) {
        if (Minor(m, rows, columns) != 0) return rank;
      }
    }
  }
  return 0;
}

inline Row PlaneRow(const Row& p, const Row& n) {
  return {p[1] * n[2] - p[2] * n[1],
          p[2] * n[0] - p[0] * n[2],
          p[0] * n[1] - p[1] * n[0],
          p[3] * n[0],
          p[3] * n[1],
          p[3] * n[2]};
}

inline Rows RightHalf(const Rows& m) {
  Rows half;
  for (const Row& row : m) half.push_back({row[3], row[4], row[5]});
  return half;
}

/// Whether x, y is strictly complementary for the rows; which of them are implicit equalities.
inline bool PairIsRight(const Row& x, const Row& y, const Rows& rows, std::vector<int>& implicit) {
  Row sum(x.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    long long product = 0;
    for (std::size_t j = 0; j < x.size(); ++j) {
      product += rows[i][j] * x[j];
      sum[j] += y[i] * rows[i][j];
    }
    if (!(product > 0 && y[i] == 0) && !(product == 0 && y[i] > 0)) return false;
    if (y[i] > 0) implicit.push_back(static_cast<int>(i));
  }
  return sum == Row(x.size());
}

/// The "dof" that evidence shows for the contacts; null if contacts or evidence are wrong.
inline json DofOf(const json& contacts, const json& all, const json& translation) {
  Rows a, every;
  bool singular = false;
  for (const json& contact : contacts) {
    const Row point = contact["point"];
    if (point[3] <= 0) return nullptr;
    for (const json& plane : contact["planes"]) {
      if (plane == json{0, 0, 0}) return nullptr;
      every.push_back(PlaneRow(point, plane));
    }
    if (contact["planes"].size() == 1) a.push_back(every.back());
    singular = singular || contact["planes"].size() > 1;
  }
  std::vector<int> ia, it;
  if (!PairIsRight(all["x"], all["y"], a, ia)) return nullptr;
  if (!PairIsRight(translation["x"], translation["y"], RightHalf(a), it)) return nullptr;
  Rows a_ia, a_it;
  for (int i : ia) a_ia.push_back(a[i]);
  for (int i : it) a_it.push_back(a[i]);
  const int ma = 6 - Rank(a), ca = Rank(a_ia), mt = 3 - Rank(RightHalf(a)), ct = Rank(RightHalf(a_it));
  const int mr = ma - mt, cr = ca - Rank(RightHalf(a_ia)), dr1 = 3 - (Rank(a_it) - ct) - mr, dr = 3 - mr - cr;
  const int ra = Rank(every), rt = Rank(RightHalf(every));
  return {
      {"singular", singular},
      {"translation",
       {{"maintaining", mt}, {"detaching", 3 - mt - ct}, {"constraining", ct}, {"restricted", rt}}},
      {"rotation",
       {{"maintaining", mr},
        {"detaching", dr},
        {"detaching_type1", dr1},
        {"detaching_type2", dr - dr1},
        {"constraining", cr},
        {"restricted", ra - rt}}},
      {"all", {{"maintaining", ma}, {"detaching", 6 - ma - ca}, {"constraining", ca}, {"restricted", ra}}}};
}

inline bool RelationIsRight(const json& relation) {
  const json dof = DofOf(relation["contacts"], relation["all"], relation["translation"]);
  return !dof.is_null() && dof == relation["dof"];
}

inline bool AssertsHold(const json& certificate, const json& dof) {
  for (const json& assertion : certificate.value("asserts", json::array())) {
    long long sum = 0;
    for (const auto& [name, coefficient] : assertion["sum"].items()) {
      const auto dot = name.find('.');
      const long long index =
          name == "constant" ? 1 : dof[name.substr(0, dot)][name.substr(dot + 1)].get<long long>();
      sum += coefficient.get<long long>() * index;
    }
    const std::string is = assertion["is"];
    if (is == "zero" ? sum != 0 : is == "positive" ? sum <= 0 : true) return false;
  }
  return true;
}

inline bool BasisIsRight(const json& c) {
  Rows both = c["vectors"], reduced = c["reduced"], angular;
  const int size = static_cast<int>(both.size());
  if (Rank(both) != size || Rank(reduced) != size) return false;
  for (const Row& row : reduced) {
    both.push_back(row);
    if (row[0] != 0 || row[1] != 0 || row[2] != 0) angular.push_back({row[0], row[1], row[2]});
  }
  return Rank(both) == size && Rank(angular) == static_cast<int>(angular.size()) &&
         c["translations"] == size - static_cast<int>(angular.size());
}

/// In rational arithmetic with one common denominator: the velocities of the ends and of the point between,
/// times it.
inline bool IllReducedIsRight(const json& c) {
  const Row p = c["ends"][0], q = c["ends"][1], m = c["motion"], st = c["between"];
  const Rows planes = c["planes"];
  if (p[3] <= 0 || q[3] <= 0 || st[0] <= 0 || st[1] <= 0) return false;
  const long long s = st[0] + st[1];
  const Row middle = {st[0] * p[0] * q[3] + st[1] * q[0] * p[3], st[0] * p[1] * q[3] + st[1] * q[1] * p[3],
                      st[0] * p[2] * q[3] + st[1] * q[2] * p[3], s * p[3] * q[3]};
  const auto speed = [&](const Row& point, const Row& n) {
    const Row row = PlaneRow(point, n);
    long long sum = 0;
    for (std::size_t i = 0; i < 6; ++i) sum += row[i] * m[i];
    return sum;
  };
  for (const Row& n : planes) {
    if (n == Row(3) || speed(middle, n) >= 0) return false;
    for (std::size_t i = 0, along = 0; i < 3; ++i) {
      along += static_cast<std::size_t>(n[i] * (q[i] * p[3] - p[i] * q[3]));
      if (i == 2 && along != 0) return false;
    }
  }
  return std::max(speed(p, planes[0]), speed(p, planes[1])) >= 0 &&
         std::max(speed(q, planes[0]), speed(q, planes[1])) >= 0;
}

/// The hand-made certificates of this folder.
inline std::string Text(const std::string& name) {
  std::ifstream in(std::string(TACT_SOURCE_DIR) + "/tests/check/certificates/" + name + ".json");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}
inline json Certificate(const std::string& name) { return json::parse(Text(name)); }
inline const std::vector<std::string> kAll = {"edge_on_face", "opposed_points", "held_edge",
                                              "edge_on_edge", "free_object",    "census",
                                              "transitions",  "basis",          "ill_reduced_edges"};
/// With those of motions, whose changed numbers tests/provers/path_certificate_test.cc tries against the engines.
inline const std::vector<std::string> kAllAndPaths = [] {
  std::vector<std::string> all = kAll;
  all.insert(all.end(), {"tip_leaves", "face_lies_down"});
  return all;
}();

}  // namespace tact::check::brute
