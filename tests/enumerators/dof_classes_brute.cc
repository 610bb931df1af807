/// @file
/// The DOF classes of a small world by brute force, compared with `tact enumerate dof-classes --json`. Shares no code
/// with tact: own worlds, own elimination, and no formula of tact's but the thesis' definitions.
/// Model   Rows [ p x n | n ] generate the cone W of wrenches. A positive circuit is a smallest set of vectors with a positive
///         combination that vanishes; the lineality space of a cone is spanned by those of its generators that lie in one.
///         The legal turning axes P are the shadow of the legal motions, dual to the pure torques in W, which the positive
///         circuits of the normals generate. So, with q the rank of these torques and l that of those in positive circuits:
///         c_r = l, m_r + d_r1 = dim lin P = 3 - q.
/// Usage   dof_classes_brute TACT cube|axis|diagonal CONTACTS
/// Exit    0: every list, count and witness agrees; 1: something does not; 2: it could not be tried.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace {

using Row = std::vector<int64_t>;
using Set = std::vector<int>;  // increasing numbers of contacts

int64_t Checked(__int128 value) {
  if (value > INT64_MAX || value < INT64_MIN) throw std::runtime_error("a number beyond 64 bits");
  return static_cast<int64_t>(value);
}

void DivideByCommonFactor(Row& row) {
  int64_t factor = 0;
  for (const int64_t a : row) factor = std::gcd(factor, a);
  if (factor > 1) {
    for (int64_t& a : row) a /= factor;
  }
}

// Gauss without fractions, to a form whose pivot columns are zero but for the pivots. Returns those columns.
std::vector<size_t> Eliminate(std::vector<Row>& rows) {
  std::vector<size_t> pivots;
  for (size_t column = 0; !rows.empty() && column < rows[0].size(); ++column) {
    const size_t top = pivots.size();
    size_t found = top;
    while (found < rows.size() && rows[found][column] == 0) ++found;
    if (found == rows.size()) continue;
    std::swap(rows[top], rows[found]);
    for (size_t i = 0; i < rows.size(); ++i) {
      if (i == top || rows[i][column] == 0) continue;
      const int64_t a = rows[top][column], b = rows[i][column];
      for (size_t k = 0; k < rows[i].size(); ++k)
        rows[i][k] = Checked(static_cast<__int128>(a) * rows[i][k] - static_cast<__int128>(b) * rows[top][k]);
      DivideByCommonFactor(rows[i]);
    }
    pivots.push_back(column);
  }
  return pivots;
}

int Rank(std::vector<Row> rows) { return static_cast<int>(Eliminate(rows).size()); }

// Weights, all positive, if the vectors are a positive circuit.
std::optional<Row> PositiveCircuit(const std::vector<Row>& vectors) {
  std::vector<Row> columns(vectors[0].size(), Row(vectors.size()));
  for (size_t i = 0; i < vectors.size(); ++i) {
    for (size_t k = 0; k < vectors[i].size(); ++k) columns[k][i] = vectors[i][k];
  }
  const std::vector<size_t> pivots = Eliminate(columns);
  if (pivots.size() + 1 != vectors.size()) return std::nullopt;
  size_t free = 0;
  while (free < pivots.size() && pivots[free] == free) ++free;
  // pivot_i * x_i + a_i * x_free = 0: every ratio -a_i / pivot_i must be positive.
  int64_t common = 1;
  for (size_t i = 0; i < pivots.size(); ++i) common = std::lcm(common, columns[i][pivots[i]]);
  Row weights(vectors.size());
  weights[free] = common;
  for (size_t i = 0; i < pivots.size(); ++i)
    weights[pivots[i]] = Checked(-static_cast<__int128>(columns[i][free]) * (common / columns[i][pivots[i]]));
  for (const int64_t w : weights) {
    if (w <= 0) return std::nullopt;
  }
  return weights;
}

// Calls visit with each set of `size` of the numbers 0 ... n - 1.
template <typename Visit>
void ForEachSet(int n, int size, const Visit& visit) {
  Set set(static_cast<size_t>(size));
  std::iota(set.begin(), set.end(), 0);
  while (true) {
    visit(set);
    int i = size - 1;
    while (i >= 0 && set[static_cast<size_t>(i)] == n - size + i) --i;
    if (i < 0) return;
    ++set[static_cast<size_t>(i)];
    for (size_t j = static_cast<size_t>(i) + 1; j < set.size(); ++j) set[j] = set[j - 1] + 1;
  }
}

// Rank of the vectors, and of those in positive circuits.
struct ConeSize {
  int span = 0, lineality = 0;
};

// The cone of vectors in three dimensions; a circuit has at most four.
ConeSize SizeInSpace(const std::set<Row>& generators) {
  const std::vector<Row> vectors(generators.begin(), generators.end());
  const int n = static_cast<int>(vectors.size());
  std::vector<bool> in_circuit(vectors.size());
  for (int size = 1; size <= std::min(n, 4); ++size) {
    ForEachSet(n, size, [&](const Set& set) {
      std::vector<Row> chosen;
      bool useful = false;
      for (const int i : set) {
        chosen.push_back(vectors[static_cast<size_t>(i)]);
        useful = useful || !in_circuit[static_cast<size_t>(i)];
      }
      if (!useful || !PositiveCircuit(chosen)) return;
      for (const int i : set) in_circuit[static_cast<size_t>(i)] = true;
    });
  }
  std::vector<Row> blocked;
  for (size_t i = 0; i < vectors.size(); ++i) {
    if (in_circuit[i]) blocked.push_back(vectors[i]);
  }
  return {Rank(vectors), Rank(blocked)};
}

// Contacts as rows [ p x n | n ], a line of action once.
std::vector<Row> MakeWorld(const std::string& name) {
  std::vector<Row> rows;
  std::set<Row> seen;
  const int lowest = name == "cube" ? 0 : -1;
  for (int code = 0; code < 729; ++code) {
    const auto digit = [&](int place) { return static_cast<int64_t>(code / place % 3 - 1); };
    const int64_t x = digit(1), y = digit(3), z = digit(9), a = digit(27), b = digit(81), c = digit(243);
    const int64_t length = a * a + b * b + c * c;
    if (std::min({x, y, z}) < lowest || length == 0 || (name != "diagonal" && length > 1)) continue;
    const Row row = {y * c - z * b, z * a - x * c, x * b - y * a, a, b, c};
    if (seen.insert(row).second) rows.push_back(row);
  }
  if (name != "cube" && name != "axis" && name != "diagonal")
    throw std::runtime_error("expected cube, axis or diagonal, got " + name);
  return rows;
}

// The fourteen indices by their names in tact's JSON.
using Dof = std::map<std::string, int>;

class Brute {
 public:
  explicit Brute(std::vector<Row> rows) : rows_(std::move(rows)) {}

  // Relations of a class of all fourteen indices; and the fewest contacts of one.
  struct Class {
    Dof dof;
    uint64_t relations = 0;
    size_t fewest = 0;
  };
  std::map<std::array<int, 10>, Class> Count(int largest) {
    std::map<std::array<int, 10>, Class> classes;
    Masks smaller, masks;
    for (int size = 0; size <= largest; ++size) {
      masks.clear();
      ForEachSet(static_cast<int>(rows_.size()), size, [&](const Set& set) {
        const unsigned mask = InCircuits(set, smaller);
        masks[KeyOf(set)] = mask;
        const std::array<int, 10> dof = Indices(set, mask);
        Class& found = classes.try_emplace(dof, Class{Named(dof), 0, set.size()}).first->second;
        ++found.relations;
      });
      smaller.swap(masks);
    }
    return classes;
  }
  Dof DofOf(const Set& set) {
    unsigned mask = 0;  // every subset that is a positive circuit
    for (unsigned subset = 1; subset < 1u << set.size(); ++subset) {
      std::vector<Row> chosen;
      for (size_t i = 0; i < set.size(); ++i) {
        if (subset >> i & 1) chosen.push_back(rows_[static_cast<size_t>(set[i])]);
      }
      if (PositiveCircuit(chosen)) mask |= subset;
    }
    return Named(Indices(set, mask));
  }

 private:
  using Masks = std::unordered_map<uint64_t, unsigned>;

  // Digits to the base of one more than the contacts.
  uint64_t KeyOf(const Set& set) const {
    uint64_t key = 0;
    for (const int i : set) {
      if (__builtin_mul_overflow(key, rows_.size() + 1, &key)) throw std::runtime_error("too many contacts");
      key += static_cast<uint64_t>(i + 1);
    }
    return key;
  }

  // Which of the set's rows lie in a positive circuit: the set itself is one, or a subset with one contact less has it.
  unsigned InCircuits(const Set& set, const Masks& smaller) const {
    if (set.empty()) return 0;
    std::vector<Row> chosen;
    for (const int i : set) chosen.push_back(rows_[static_cast<size_t>(i)]);
    const unsigned all = (1u << set.size()) - 1;
    if (PositiveCircuit(chosen)) return all;
    unsigned mask = 0;
    for (size_t out = 0; out < set.size(); ++out) {
      Set subset = set;
      subset.erase(subset.begin() + static_cast<long>(out));
      const unsigned part = smaller.at(KeyOf(subset)), low = part & ((1u << out) - 1);
      mask |= low | (part ^ low) << 1;
    }
    return mask;
  }

  // The torque of a positive circuit of normals, if the set is one.
  const std::optional<Row>& CircuitTorque(const Set& set) {
    const auto [at, is_new] = torques_.try_emplace(KeyOf(set));
    if (!is_new) return at->second;
    std::vector<Row> normals;
    for (const int i : set) {
      const Row& row = rows_[static_cast<size_t>(i)];
      normals.emplace_back(row.begin() + 3, row.end());
    }
    if (const auto weights = PositiveCircuit(normals)) {
      Row torque(3);
      for (size_t i = 0; i < set.size(); ++i) {
        for (size_t k = 0; k < 3; ++k)
          torque[k] = Checked(torque[k] +
                              static_cast<__int128>((*weights)[i]) * rows_[static_cast<size_t>(set[i])][k]);
      }
      DivideByCommonFactor(torque);
      at->second = torque;
    }
    return at->second;
  }

  // m, d, c of translation; m, d_r1, d_r2, c of rotation; m, d, c of all motion.
  std::array<int, 10> Indices(const Set& set, unsigned in_circuits) {
    std::vector<Row> rows, blocked;
    std::set<Row> normals, torques;
    for (size_t i = 0; i < set.size(); ++i) {
      const Row& row = rows_[static_cast<size_t>(set[i])];
      rows.push_back(row);
      if (in_circuits >> i & 1) blocked.push_back(row);
      normals.emplace(row.begin() + 3, row.end());
    }
    const int n = static_cast<int>(set.size());
    for (int size = 2; size <= std::min(n, 4); ++size) {
      ForEachSet(n, size, [&](const Set& places) {
        Set subset;
        for (const int place : places) subset.push_back(set[static_cast<size_t>(place)]);
        if (const auto& torque = CircuitTorque(subset)) torques.insert(*torque);
      });
    }
    torques.erase(Row(3));
    const ConeSize translation = SizeInSpace(normals), turning = SizeInSpace(torques);
    const int rank = Rank(rows);
    const int mt = 3 - translation.span, ct = translation.lineality;
    const int ma = 6 - rank, ca = Rank(blocked);
    const int mr = ma - mt,
              cr = turning.lineality;  // the kernel's shadow has the dimension it has without translations
    const int type1 = 3 - turning.span - mr;
    return {mt, 3 - mt - ct, ct, mr, type1, 3 - mr - type1 - cr, cr, ma, 6 - ma - ca, ca};
  }

  static Dof Named(const std::array<int, 10>& v) {
    return {{"translation.maintaining", v[0]},   {"translation.detaching", v[1]},
            {"translation.constraining", v[2]},  {"rotation.maintaining", v[3]},
            {"rotation.detaching", v[4] + v[5]}, {"rotation.detaching_type1", v[4]},
            {"rotation.detaching_type2", v[5]},  {"rotation.constraining", v[6]},
            {"all.maintaining", v[7]},           {"all.detaching", v[8]},
            {"all.constraining", v[9]}};
  }

  std::vector<Row> rows_;
  std::unordered_map<uint64_t, std::optional<Row>> torques_;
};

nlohmann::json AskTact(const std::string& program, const std::string& world, int largest) {
  const std::string command = "'" + program + "' enumerate dof-classes --json --world " + world +
                              " --contacts " + std::to_string(largest);
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string text;
  for (int c; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
  if (pclose(pipe) != 0) throw std::runtime_error(command + " failed");
  return nlohmann::json::parse(text);
}

// Numbers of a witness' contacts in the world.
Set Places(const nlohmann::json& contacts, const std::vector<Row>& world) {
  Set set;
  for (const auto& contact : contacts) {
    const std::array<int64_t, 3> p = contact["point"];
    const std::array<int64_t, 3> n = contact["planes"].at(0);
    const Row row = {
        p[1] * n[2] - p[2] * n[1], p[2] * n[0] - p[0] * n[2], p[0] * n[1] - p[1] * n[0], n[0], n[1], n[2]};
    const auto found = std::find(world.begin(), world.end(), row);
    if (found == world.end() || contact["planes"].size() != 1)
      throw std::runtime_error("a witness with a contact that is not of the world: " + contact.dump());
    set.push_back(static_cast<int>(found - world.begin()));
  }
  std::sort(set.begin(), set.end());
  return set;
}

int Run(const std::string& program, const std::string& world_name, int largest) {
  const std::vector<Row> world = MakeWorld(world_name);
  Brute brute(world);
  const auto classes = brute.Count(largest);
  const nlohmann::json answer = AskTact(program, world_name, largest);
  int differences = 0;
  const auto differ = [&](const std::string& what) {
    std::printf("differs: %s\n", what.c_str());
    ++differences;
  };
  uint64_t relations = 0;
  for (const auto& [indices, found] : classes) relations += found.relations;
  if (answer["relations"] != relations) differ("relations: " + answer["relations"].dump());
  if (answer["definitions"].size() != 11) differ("the number of definitions");
  for (const auto& definition : answer["definitions"]) {
    const std::vector<std::string> names = definition["indices"];
    const auto values_of = [&](const Dof& dof) {
      std::vector<int> values;
      for (const std::string& name : names) values.push_back(dof.at(name));
      return values;
    };
    std::map<std::vector<int>, std::pair<uint64_t, size_t>> expected;  // relations, fewest contacts
    for (const auto& [indices, found] : classes) {
      auto& [count, fewest] = expected.try_emplace(values_of(found.dof), 0, found.fewest).first->second;
      count += found.relations;
      fewest = std::min(fewest, found.fewest);
    }
    if (definition["classes"] != expected.size() || definition["list"].size() != expected.size())
      differ(definition["name"].dump() + " has " + std::to_string(expected.size()) + " classes");
    for (const auto& found : definition["list"]) {
      const auto same = expected.find(found["values"].get<std::vector<int>>());
      if (same == expected.end() || found["count"] != same->second.first) {
        differ(found.dump());
        continue;
      }
      const Set witness = Places(found["witness"]["contacts"], world);
      if (witness.size() != same->second.second || values_of(brute.DofOf(witness)) != same->first)
        differ("the witness of " + found.dump());
    }
  }
  std::printf("%s, at most %d of %zu contacts: %llu relations, %zu classes, %d differences\n",
              world_name.c_str(), largest, world.size(), static_cast<unsigned long long>(relations),
              classes.size(), differences);
  return differences == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 4) throw std::runtime_error("expected TACT cube|axis|diagonal CONTACTS");
    const int largest = std::atoi(argv[3]);
    if (largest < 0 || largest > 9) throw std::runtime_error("expected 0 to 9 contacts");
    return Run(argv[1], argv[2], largest);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "dof_classes_brute: %s\n", error.what());
    return 2;
  }
}
