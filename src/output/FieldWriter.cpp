#include "output/FieldWriter.hpp"

#include "archive/Archive.hpp"
#include "base/OutputError.hpp"
#include "files/Sync.hpp"
#include "files/TextFile.hpp"
#include "output/Hdf5.hpp"
#include "output/Xdmf.hpp"
#include "parallel/FirstRank.hpp"

#include <cstdio>

namespace Rhegma
{

/// The pair of files, of either dimension.
template <int D>
class FieldWriter<D>::Files
{
public:
  Files(const std::string& folder, const Ranks& ranks)
      : data_(folder + "/fields.h5"), guide_(folder + "/fields.xdmf")
  {
    onFirstRank<OutputError>(ranks,
                             [&]
                             {
                               // An XDMF file without its data would mislead ParaView.
                               std::remove(guide_.c_str());
                               createHdf5(data_);
                             });
  }

  Files(const std::string& folder, Archive& archive)
      : data_(folder + "/fields.h5"), guide_(folder + "/fields.xdmf")
  {
    serialize(archive);
    onFirstRank<OutputError>(archive.ranks(),
                             [&]
                             {
                               // First the guide, which must not list what a kill leaves out.
                               replaceFile(guide_, document_.text());
                               keepSnapshots(data_, written_);
                             });
  }

  void serialize(Archive& archive)
  {
    archive("written", written_);
    document_.serialize(archive);
  }

  void sync() const
  {
    if (written_ > 0)
      syncFile(data_);
  }

  void write(const Snapshot& snapshot, const Ranks& ranks)
  {
    const std::string group = snapshotName(written_);
    appendSnapshot(data_, group, snapshot, ranks);
    document_.add(snapshot, group);
    onFirstRank<OutputError>(ranks, [&] { replaceFile(guide_, document_.text()); });
    ++written_;
  }

private:
  std::string data_;
  std::string guide_;
  XdmfDocument document_{"fields.h5"};
  int written_ = 0;
};

template <int D>
FieldWriter<D>::FieldWriter(const std::string& folder, const Ranks& ranks)
    : files_(std::make_unique<Files>(folder, ranks))
{
}

template <int D>
FieldWriter<D>::FieldWriter(const std::string& folder, Archive& archive)
    : files_(std::make_unique<Files>(folder, archive))
{
  archive("last_time", lastTime_);
}

template <int D>
void FieldWriter<D>::serialize(Archive& archive)
{
  files_->serialize(archive);
  archive("last_time", lastTime_);
}

template <int D>
void FieldWriter<D>::sync() const
{
  files_->sync();
}

template <int D>
FieldWriter<D>::~FieldWriter() = default;
template <int D>
FieldWriter<D>::FieldWriter(FieldWriter&&) noexcept = default;
template <int D>
FieldWriter<D>& FieldWriter<D>::operator=(FieldWriter&&) noexcept = default;

template <int D>
void FieldWriter<D>::write(const State<D>& state, const RequestedFields& requested)
{
  if (state.clock.time == lastTime_)
    return;
  lastTime_ = state.clock.time;
  files_->write(partOfAll(state.ranks, makeSnapshot(state, requested)), state.ranks);
}

template class FieldWriter<2>;
template class FieldWriter<3>;

} // namespace Rhegma
