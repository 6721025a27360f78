#pragma once
/// Numbers of keys on the host, for sets and maps that are made anew whenever cells change.

#include <cstdint>
#include <vector>

namespace Rhegma
{

/// Numbers keys in the order in which they are added: 0, 1, ... One table of slots without nodes of its own
/// (open addressing), so that adding a key allocates no memory and a search reads one line of cache.
class KeyNumbers
{
public:
  /// The number of a key, which is added where it is new. \param key below 2^63
  int add(std::uint64_t key)
  {
    if (2 * (keys_.size() + 1) > slots_.size())
      grow();
    std::size_t at = slotOf(key);
    for (; slots_[at] >= 0; at = (at + 1) & (slots_.size() - 1))
      if (keys_[slots_[at]] == key)
        return slots_[at];
    slots_[at] = size();
    keys_.push_back(key);
    return slots_[at];
  }

  /// The number of a key, or -1.
  int find(std::uint64_t key) const
  {
    if (keys_.empty())
      return -1;
    for (std::size_t at = slotOf(key); slots_[at] >= 0; at = (at + 1) & (slots_.size() - 1))
      if (keys_[slots_[at]] == key)
        return slots_[at];
    return -1;
  }

  int size() const { return static_cast<int>(keys_.size()); }

  /// The keys by their numbers.
  const std::vector<std::uint64_t>& keys() const { return keys_; }

  /// Whether both have the same keys, in any order.
  bool sameKeys(const KeyNumbers& other) const
  {
    if (size() != other.size())
      return false;
    for (const std::uint64_t key : keys_)
      if (other.find(key) < 0)
        return false;
    return true;
  }

private:
  /// Highest bits of the product with 2^64 divided by the golden ratio: neighbouring cells are spread over
  /// the slots.
  std::size_t slotOf(std::uint64_t key) const
  {
    return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ULL) >> (64 - bits_));
  }

  void grow()
  {
    bits_ = slots_.empty() ? 6 : bits_ + 1;
    slots_.assign(std::size_t(1) << bits_, -1);
    for (int i = 0; i < size(); ++i)
    {
      std::size_t at = slotOf(keys_[i]);
      while (slots_[at] >= 0)
        at = (at + 1) & (slots_.size() - 1);
      slots_[at] = i;
    }
  }

  std::vector<std::uint64_t> keys_;
  std::vector<int> slots_; ///< number of a key, -1 where empty; a power of two of them
  int bits_ = 0;
};

} // namespace Rhegma
