#include "exact/wide_integer.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace oblast::internal::exact {

WideInteger WideInteger::scaled(double value, int shift) {
  WideInteger r;
  if (value == 0) return r;
  r.negative_ = value < 0;
  int exponent;
  auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::fabs(value), &exponent), 53));
  exponent += shift - 53;
  while (exponent < 0) {
    assert((mantissa & 1) == 0);
    mantissa >>= 1;
    ++exponent;
  }
  r.limbs_.assign(static_cast<std::size_t>(exponent / 32), 0);
  const int rest = exponent % 32;
  const std::uint64_t low = (mantissa & 0xffffffff) << rest, high = (mantissa >> 32) << rest;
  const std::uint64_t middle = (low >> 32) + (high & 0xffffffff);
  r.limbs_.push_back(static_cast<std::uint32_t>(low));
  r.limbs_.push_back(static_cast<std::uint32_t>(middle));
  r.limbs_.push_back(static_cast<std::uint32_t>(high >> 32));
  r.trim();
  return r;
}

WideInteger WideInteger::operator-() const {
  WideInteger r = *this;
  r.negative_ = !negative_;
  return r;
}

void WideInteger::trim() {
  while (!limbs_.empty() && limbs_.back() == 0) limbs_.pop_back();
}

bool WideInteger::less(const Limbs& p, const Limbs& q) {
  if (p.size() != q.size()) return p.size() < q.size();
  return std::lexicographical_compare(p.rbegin(), p.rend(), q.rbegin(), q.rend());
}

WideInteger::Limbs WideInteger::sum(const Limbs& p, const Limbs& q) {
  Limbs r(std::max(p.size(), q.size()) + 1);
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    carry += (i < p.size() ? p[i] : 0ULL) + (i < q.size() ? q[i] : 0ULL);
    r[i] = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
  return r;
}

WideInteger::Limbs WideInteger::difference(const Limbs& larger, const Limbs& smaller) {
  Limbs r(larger.size());
  std::int64_t borrow = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    borrow += static_cast<std::int64_t>(larger[i]) - (i < smaller.size() ? static_cast<std::int64_t>(smaller[i]) : 0);
    r[i] = static_cast<std::uint32_t>(borrow);
    borrow >>= 32;
  }
  return r;
}

WideInteger operator+(const WideInteger& p, const WideInteger& q) {
  WideInteger r;
  if (p.negative_ == q.negative_) {
    r.limbs_ = WideInteger::sum(p.limbs_, q.limbs_);
    r.negative_ = p.negative_;
  } else if (WideInteger::less(p.limbs_, q.limbs_)) {
    r.limbs_ = WideInteger::difference(q.limbs_, p.limbs_);
    r.negative_ = q.negative_;
  } else {
    r.limbs_ = WideInteger::difference(p.limbs_, q.limbs_);
    r.negative_ = p.negative_;
  }
  r.trim();
  return r;
}

WideInteger operator*(const WideInteger& p, const WideInteger& q) {
  WideInteger r;
  r.limbs_.assign(p.limbs_.size() + q.limbs_.size(), 0);
  for (std::size_t i = 0; i < p.limbs_.size(); ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < q.limbs_.size() || carry != 0; ++j) {
      carry += r.limbs_[i + j] + (j < q.limbs_.size() ? static_cast<std::uint64_t>(p.limbs_[i]) * q.limbs_[j] : 0);
      r.limbs_[i + j] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
  }
  r.negative_ = p.negative_ != q.negative_;
  r.trim();
  return r;
}

}  // namespace oblast::internal::exact
