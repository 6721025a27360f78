#pragma once
/// Saves and loads the persistent data of a run by one description.

#include "archive/Record.hpp"
#include "base/Types.hpp"
#include "parallel/Ranks.hpp"

#include <array>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace Rhegma
{

/// Writes numbers, texts, lists and views by name to a record, or reads them from one. A class with
/// persistent data lists them once,
///
///     void serialize(Archive& archive)
///     {
///       archive("gap", gap_);
///       archive("dissipated", dissipated_);
///     }
///
/// so that saved and loaded data can't differ. Lists and views get the saved size. Names are free text within
/// a group; loading throws std::invalid_argument where a name is missing or has another type or shape.
///
/// With several ranks all of them save and load together into the record of the first rank: data that are
/// equal on all ranks as above, data divided among the ranks by `parts` or `together`.
class Archive
{
public:
  /// Saves to a record; its other tables stay.
  static Archive saving(Record& to, const Ranks& ranks = {});
  /// Loads from a record, which must outlive this and be the same on all ranks.
  static Archive loading(const Record& from, const Ranks& ranks = {});

  bool loads() const { return from_ != nullptr; }
  const Ranks& ranks() const { return ranks_; }

  /// Numbers of which each rank has a part: their sum is saved; on loading the first rank gets it, all others
  /// zero. Collective.
  void parts(const std::string& name, double& value);
  template <int D>
  void parts(const std::string& name, Vector<D>& vector)
  {
    const Vector<D> own = vector;
    if (!loads())
      ranks_.sum(vector.c, D);
    (*this)(name, vector);
    if (!loads())
      vector = own;
    else if (ranks_.rank() > 0)
      vector = Vector<D>{};
  }

  /// A list of which each rank has rows: they are saved one after another, and every rank loads all of them.
  /// Collective. \param columns numbers of a row
  template <class T>
  void together(const std::string& name, std::vector<T>& list, std::size_t columns = 1)
  {
    if (loads())
      return (*this)(name, list, columns);
    std::vector<T> all = ranks_.gather(list);
    (*this)(name, all, columns);
  }

  /// Whether particles and nodes have the order of the saved run, so that caches by row are valid. Otherwise
  /// caches are not loaded.
  bool sameOrder() const { return sameOrder_; }
  void setSameOrder(bool same) { sameOrder_ = same; }

  /// During its lifetime names belong to a group, nested in those that exist already.
  class Group
  {
  public:
    Group(Archive& archive, const std::string& name) : archive_(archive), length_(archive.path_.size())
    {
      archive_.path_ += name + "/";
    }
    ~Group() { archive_.path_.resize(length_); }
    Group(const Group&) = delete;
    Group& operator=(const Group&) = delete;

  private:
    Archive& archive_;
    std::size_t length_;
  };

  void operator()(const std::string& name, double& value) { number(name, value); }
  void operator()(const std::string& name, int& value) { number(name, value); }
  void operator()(const std::string& name, long& value) { number(name, value); }
  void operator()(const std::string& name, bool& value);
  void operator()(const std::string& name, std::string& text);
  void operator()(const std::string& name, std::vector<std::string>& texts);

  /// A list. \param columns numbers of a row of the table that it becomes
  template <class T>
  void operator()(const std::string& name, std::vector<T>& list, std::size_t columns = 1)
  {
    std::vector<std::size_t> extent{list.size() / columns};
    if (columns > 1)
      extent.push_back(columns);
    const RecordTable* from = begin(name, typeOf<T>(), extent);
    if (from == nullptr)
      return save(name, list.data());
    if (from->extent.size() != extent.size() || (columns > 1 && from->extent.back() != columns))
      refuse(name, "has another shape");
    list.resize(from->bytes.size() / sizeof(T));
    if (!list.empty())
      std::memcpy(list.data(), from->bytes.data(), from->bytes.size());
  }

  template <int D>
  void operator()(const std::string& name, Vector<D>& vector)
  {
    fixed(name, vector.c, D);
  }

  /// Numbers of a fixed count.
  template <class T, std::size_t N>
  void operator()(const std::string& name, T (&numbers)[N])
  {
    fixed(name, numbers, N);
  }

  template <class T, std::size_t N>
  void operator()(const std::string& name, std::array<T, N>& numbers)
  {
    fixed(name, numbers.data(), N);
  }

  /// A view with one or two extents that are not fixed, or none.
  template <class Data>
  void operator()(const std::string& name, Kokkos::View<Data, Kokkos::LayoutRight, MemorySpace>& view)
  {
    using AnyView = Kokkos::View<Data, Kokkos::LayoutRight, MemorySpace>;
    using T = typename AnyView::non_const_value_type;
    constexpr int rank = static_cast<int>(AnyView::rank), free = static_cast<int>(AnyView::rank_dynamic);
    static_assert(free <= 2, "no view of the state has more");
    if constexpr (free == 0)
      if (view.data() == nullptr)
        view = AnyView(name);
    std::vector<std::size_t> extent(rank);
    for (int r = 0; r < rank; ++r)
      extent[r] = view.extent(r);
    const RecordTable* from = begin(name, typeOf<T>(), extent);
    if (from == nullptr)
    {
      const auto host = onHost(view);
      return save(name, host.data());
    }
    bool same = from->extent.size() == extent.size();
    for (int r = free; r < rank; ++r)
      if (!same || from->extent[r] != extent[r])
        refuse(name, "has another shape");
    if (!same)
      refuse(name, "has another shape");
    for (int r = 0; r < free; ++r)
      same = same && from->extent[r] == extent[r];
    if (!same)
    {
      if constexpr (free == 1)
        view = AnyView(labelOf(view, name), from->extent[0]);
      else if constexpr (free == 2)
        view = AnyView(labelOf(view, name), from->extent[0], from->extent[1]);
    }
    const auto host = Kokkos::create_mirror_view(view);
    if (!from->bytes.empty())
      std::memcpy(host.data(), from->bytes.data(), from->bytes.size());
    Kokkos::deep_copy(view, host);
  }

private:
  Archive() = default;

  template <class T>
  static constexpr RecordTable::Type typeOf()
  {
    if constexpr (std::is_same_v<T, double>)
      return RecordTable::Type::Real;
    else if constexpr (std::is_same_v<T, char>)
      return RecordTable::Type::Byte;
    else
    {
      static_assert(std::is_integral_v<T> && (sizeof(T) == 4 || sizeof(T) == 8),
                    "write the name of an entry in it");
      return sizeof(T) == 4 ? RecordTable::Type::Integer : RecordTable::Type::Long;
    }
  }

  template <class AnyView>
  static std::string labelOf(const AnyView& view, const std::string& name)
  {
    return view.label().empty() ? name : view.label();
  }

  template <class T>
  void number(const std::string& name, T& value)
  {
    const RecordTable* from = begin(name, typeOf<T>(), {});
    if (from == nullptr)
      return save(name, &value);
    if (!from->extent.empty())
      refuse(name, "has another shape");
    std::memcpy(&value, from->bytes.data(), sizeof(T));
  }

  template <class T>
  void fixed(const std::string& name, T* numbers, std::size_t count)
  {
    const RecordTable* from = begin(name, typeOf<T>(), {count});
    if (from == nullptr)
      return save(name, numbers);
    if (from->extent != std::vector<std::size_t>{count})
      refuse(name, "has another shape");
    std::memcpy(numbers, from->bytes.data(), count * sizeof(T));
  }

  /// The table to load from, of this type; when saving it makes the table and returns null.
  const RecordTable* begin(const std::string& name, RecordTable::Type type,
                           const std::vector<std::size_t>& extent);
  /// Fills the table made by begin.
  void save(const std::string& name, const void* values);
  [[noreturn]] void refuse(const std::string& name, const std::string& what) const;

  Record* to_ = nullptr;
  const Record* from_ = nullptr;
  Ranks ranks_;
  std::string path_;
  bool sameOrder_ = true;
};

} // namespace Rhegma
