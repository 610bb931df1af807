#include "algebra/knot/p_data_store.h"

#include <cstring>

namespace tact::knot {
namespace {

constexpr int kMostShortColumns = 63;

uint64_t Hash(const uint8_t* bytes, size_t count) {  // FNV-1a, mixed once more
  uint64_t hash = 0xcbf29ce484222325u;
  for (size_t i = 0; i < count; ++i) hash = (hash ^ bytes[i]) * 0x100000001b3u;
  return hash ^ hash >> 32;
}

}  // namespace

void PDataStore::Encode(const PData& p) const {
  encoded_.clear();
  const bool wide = p.columns() > kMostShortColumns;
  if (wide) encoded_.push_back(0);  // a short code has none: column 1 is not its own mate
  for (int i = 1; i <= p.columns(); ++i) {
    const auto code = static_cast<uint32_t>(p.sigma(i) - 1) << 2 | static_cast<uint32_t>(p.attr(i) - 1);
    encoded_.push_back(static_cast<uint8_t>(code));
    if (!wide) continue;
    encoded_.push_back(static_cast<uint8_t>(code >> 8));
    encoded_.push_back(static_cast<uint8_t>(code >> 16));
  }
}

size_t PDataStore::LengthOf(uint32_t number) const {
  const size_t next = number + size_t{1};
  return (next < starts_.size() ? starts_[next] : bytes_.size()) - starts_[number];
}

size_t PDataStore::Place() const {
  const size_t mask = table_.size() - 1;
  size_t place = Hash(encoded_.data(), encoded_.size()) & mask;
  for (; table_[place] != kNone; place = (place + 1) & mask) {
    const uint32_t number = table_[place];
    if (LengthOf(number) == encoded_.size() &&
        std::memcmp(bytes_.data() + starts_[number], encoded_.data(), encoded_.size()) == 0)
      break;
  }
  return place;
}

void PDataStore::Grow() {
  const size_t size = table_.empty() ? 64 : 2 * table_.size(), mask = size - 1;
  table_.assign(size, kNone);
  for (uint32_t number = 0; number < starts_.size(); ++number) {
    size_t place = Hash(bytes_.data() + starts_[number], LengthOf(number)) & mask;
    while (table_[place] != kNone) place = (place + 1) & mask;
    table_[place] = number;
  }
}

std::pair<uint32_t, bool> PDataStore::Insert(const PData& p) {
  if (3 * (starts_.size() + 1) > 2 * table_.size()) Grow();
  Encode(p);
  const size_t place = Place();
  if (table_[place] != kNone) return {table_[place], false};
  const auto number = static_cast<uint32_t>(starts_.size());
  table_[place] = number;
  starts_.push_back(bytes_.size());
  bytes_.insert(bytes_.end(), encoded_.begin(), encoded_.end());
  return {number, true};
}

uint32_t PDataStore::Find(const PData& p) const {
  if (table_.empty()) return kNone;
  Encode(p);
  return table_[Place()];
}

PData PDataStore::Get(uint32_t number) const {
  const uint8_t* code = bytes_.data() + starts_[number];
  const size_t length = LengthOf(number);
  // A short code's first byte names the mate of column 1, which is not column 1.
  const bool wide = length > 0 && code[0] < 4;
  const size_t step = wide ? 3 : 1;
  const size_t columns = wide ? (length - 1) / 3 : length;
  PDataBuilder p(static_cast<int>(columns));
  for (size_t i = 0; i < columns; ++i) {
    const uint8_t* at = code + (wide ? 1 : 0) + i * step;
    uint32_t value = at[0];
    if (wide) value |= static_cast<uint32_t>(at[1]) << 8 | static_cast<uint32_t>(at[2]) << 16;
    p.Add(static_cast<int>(value >> 2) + 1, static_cast<int>(value & 3) + 1);
  }
  return p.Take();
}

}  // namespace tact::knot
