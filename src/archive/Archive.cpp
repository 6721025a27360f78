#include "archive/Archive.hpp"

namespace Rhegma
{

Archive Archive::saving(Record& to, const Ranks& ranks)
{
  Archive archive;
  archive.to_ = &to;
  archive.ranks_ = ranks;
  return archive;
}

Archive Archive::loading(const Record& from, const Ranks& ranks)
{
  Archive archive;
  archive.from_ = &from;
  archive.ranks_ = ranks;
  return archive;
}

void Archive::parts(const std::string& name, double& value)
{
  const double own = value;
  if (!loads())
    value = ranks_.sum(value);
  (*this)(name, value);
  if (!loads())
    value = own;
  else if (ranks_.rank() > 0)
    value = 0.0;
}

void Archive::operator()(const std::string& name, bool& value)
{
  int whole = value ? 1 : 0;
  number(name, whole);
  value = whole != 0;
}

void Archive::operator()(const std::string& name, std::string& text)
{
  std::vector<char> letters(text.begin(), text.end());
  (*this)(name, letters);
  text.assign(letters.begin(), letters.end());
}

void Archive::operator()(const std::string& name, std::vector<std::string>& texts)
{
  const Group group(*this, name);
  int count = static_cast<int>(texts.size());
  (*this)("count", count);
  texts.resize(count);
  for (int k = 0; k < count; ++k)
    (*this)(std::to_string(k), texts[k]);
}

const RecordTable* Archive::begin(const std::string& name, RecordTable::Type type,
                                  const std::vector<std::size_t>& extent)
{
  if (from_ == nullptr)
  {
    RecordTable& table = (*to_)[path_ + name];
    table.type = type;
    table.extent = extent;
    table.bytes.resize(table.size());
    return nullptr;
  }
  const auto found = from_->find(path_ + name);
  if (found == from_->end())
    refuse(name, "is missing");
  if (found->second.type != type)
    refuse(name, "is of another type");
  if (found->second.bytes.size() != found->second.size())
    refuse(name, "has another size than its header says");
  return &found->second;
}

void Archive::save(const std::string& name, const void* values)
{
  RecordTable& table = (*to_)[path_ + name];
  if (!table.bytes.empty())
    std::memcpy(table.bytes.data(), values, table.bytes.size());
}

void Archive::refuse(const std::string& name, const std::string& what) const
{
  throw std::invalid_argument("\"" + path_ + name + "\" " + what);
}

} // namespace Rhegma
