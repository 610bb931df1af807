#include "algebra/exact/integer.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "algebra/error.h"

namespace tact::algebra {
namespace {

// A GMP view of an Integer that allocates nothing for a small one.
class MpzView {
 public:
  explicit MpzView(int64_t value) {
    limb_ = value < 0 ? mp_limb_t{0} - static_cast<mp_limb_t>(value) : static_cast<mp_limb_t>(value);
    view_->_mp_alloc = 1;
    view_->_mp_size = value == 0 ? 0 : (value < 0 ? -1 : 1);
    view_->_mp_d = &limb_;
  }
  mpz_srcptr get() const { return view_; }

 private:
  mp_limb_t limb_;
  mpz_t view_;
};

// Scratch that lives as long as one operation.
class Mpz {
 public:
  Mpz() { mpz_init(z_); }
  ~Mpz() { mpz_clear(z_); }
  Mpz(const Mpz&) = delete;
  Mpz& operator=(const Mpz&) = delete;
  mpz_ptr get() { return z_; }

 private:
  mpz_t z_;
};

template <typename Operation>
Integer BigOperation(const Integer& a, const Integer& b, Operation operation) {
  Mpz x, y, z;
  a.GetMpz(x.get());
  b.GetMpz(y.get());
  operation(z.get(), x.get(), y.get());
  return Integer::FromMpz(z.get());
}

}  // namespace

void Integer::CopyBig(const Integer& other) {
  big_ = new __mpz_struct;
  mpz_init_set(big_, other.big_);
}

void Integer::FreeBig() noexcept {
  mpz_clear(big_);
  delete big_;
  big_ = nullptr;
}

Integer& Integer::operator=(const Integer& other) {
  if (this == &other) return *this;
  if (big_ != nullptr) FreeBig();
  value_ = other.value_;
  if (other.big_ != nullptr) CopyBig(other);
  return *this;
}

Integer& Integer::operator=(Integer&& other) noexcept {
  value_ = other.value_;
  std::swap(big_, other.big_);
  return *this;
}

Integer Integer::FromMpz(mpz_srcptr value) {
  Integer result;
  if (mpz_fits_slong_p(value)) {
    result.value_ = mpz_get_si(value);
  } else {
    result.big_ = new __mpz_struct;
    mpz_init_set(result.big_, value);
  }
  return result;
}

std::optional<Integer> Integer::Parse(std::string_view text) {
  size_t start = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  if (start == text.size()) return std::nullopt;
  for (size_t i = start; i < text.size(); ++i) {
    if (std::isdigit(static_cast<unsigned char>(text[i])) == 0) return std::nullopt;
  }
  const std::string digits(text.substr(text[0] == '+' ? 1 : 0));
  if (text.size() <= 18) return Integer(std::stoll(digits));
  Mpz z;
  mpz_set_str(z.get(), digits.c_str(), 10);
  return FromMpz(z.get());
}

int Integer::sign() const noexcept {
  if (big_ != nullptr) return mpz_sgn(big_);
  return value_ < 0 ? -1 : (value_ > 0 ? 1 : 0);
}

size_t Integer::bits() const noexcept {
  if (sign() == 0) return 0;
  return big_ != nullptr ? mpz_sizeinbase(big_, 2) : mpz_sizeinbase(MpzView(value_).get(), 2);
}

void Integer::GetMpz(mpz_ptr out) const {
  if (big_ != nullptr) {
    mpz_set(out, big_);
  } else {
    mpz_set_si(out, value_);
  }
}

std::string Integer::ToString() const {
  if (big_ == nullptr) return std::to_string(value_);
  std::string text(mpz_sizeinbase(big_, 10) + 2, '\0');
  mpz_get_str(text.data(), 10, big_);
  text.resize(text.find('\0'));
  return text;
}

Integer Integer::operator-() const { return Integer(0) - *this; }

Integer operator+(const Integer& a, const Integer& b) {
  long long sum = 0;
  if (a.is_small() && b.is_small() && !__builtin_add_overflow(a.value_, b.value_, &sum)) return sum;
  return BigOperation(a, b, mpz_add);
}

Integer operator-(const Integer& a, const Integer& b) {
  long long difference = 0;
  if (a.is_small() && b.is_small() && !__builtin_sub_overflow(a.value_, b.value_, &difference)) {
    return difference;
  }
  return BigOperation(a, b, mpz_sub);
}

Integer operator*(const Integer& a, const Integer& b) {
  long long product = 0;
  if (a.is_small() && b.is_small() && !__builtin_mul_overflow(a.value_, b.value_, &product)) return product;
  return BigOperation(a, b, mpz_mul);
}

Integer DivideExactly(const Integer& a, const Integer& b) {
  if (b.sign() == 0) throw PreconditionError("division by zero");
  const bool overflows = b.is_small() && b.value_ == -1;  // -2^63 / -1
  if (a.is_small() && b.is_small() && !overflows) return Integer(a.value_ / b.value_);
  return BigOperation(a, b, mpz_divexact);
}

Integer Gcd(const Integer& a, const Integer& b) {
  constexpr int64_t kMin = std::numeric_limits<int64_t>::min();
  if (a.is_small() && b.is_small() && a.value_ != kMin && b.value_ != kMin) {
    return Integer(std::gcd(a.value_, b.value_));
  }
  return BigOperation(a, b, mpz_gcd);
}

Integer Abs(const Integer& a) { return a.sign() < 0 ? -a : a; }

bool operator==(const Integer& a, const Integer& b) noexcept {
  // A value that fits in 64 bits is never stored large, so the forms agree.
  if (a.is_small() != b.is_small()) return false;
  return a.is_small() ? a.value_ == b.value_ : mpz_cmp(a.big_, b.big_) == 0;
}

std::strong_ordering operator<=>(const Integer& a, const Integer& b) noexcept {
  if (a.is_small() && b.is_small()) return a.value_ <=> b.value_;
  if (a.is_small()) return 0 <=> mpz_sgn(b.big_);
  if (b.is_small()) return mpz_sgn(a.big_) <=> 0;
  return mpz_cmp(a.big_, b.big_) <=> 0;
}

double ToDouble(const Integer& a) {
  if (a.big_ == nullptr) return static_cast<double>(a.value_);
  // The leading 64 bits, the last of them set if any behind it is: they round as the whole does.
  Mpz leading;
  const size_t behind = mpz_sizeinbase(a.big_, 2) - 64;
  mpz_tdiv_q_2exp(leading.get(), a.big_, behind);
  uint64_t bits = mpz_getlimbn(leading.get(), 0);
  if (mpz_scan1(a.big_, 0) < behind) bits |= 1;
  const double magnitude =
      std::ldexp(static_cast<double>(bits), static_cast<int>(std::min<size_t>(behind, 4096)));
  return a.sign() < 0 ? -magnitude : magnitude;
}

}  // namespace tact::algebra
