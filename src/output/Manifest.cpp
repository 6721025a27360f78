#include "output/Manifest.hpp"

#include "files/Sync.hpp"
#include "files/TextFile.hpp"
#include "output/OutputFolder.hpp"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>
#include <zlib.h>

namespace Rhegma
{

namespace
{

constexpr double secondsBetween = 1.0;

unsigned long crcOf(const std::string& text)
{
  return crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()));
}

double wallClock()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

nlohmann::json checksumOf(const std::string& path)
{
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) // to open a pipe may wait for ever
    return nullptr;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file)
    return nullptr;
  unsigned long crc = 0;
  long long bytes = 0;
  std::vector<unsigned char> piece(1 << 16);
  while (const std::size_t got = std::fread(piece.data(), 1, piece.size(), file.get()))
  {
    crc = crc32(crc, piece.data(), static_cast<uInt>(got));
    bytes += static_cast<long long>(got);
  }
  return {{"bytes", bytes}, {"crc32", crc}};
}

Manifest::Manifest(const std::string& folder, const std::string& scene)
    : folder_(folder), scene_(checksumOf(scene))
{
  std::error_code none;
  if (scene_.is_object())
    scene_["path"] = std::filesystem::absolute(scene, none).string();
}

bool Manifest::isDue() const { return wallClock() - last_ >= secondsBetween; }

void Manifest::write(const HistorySoFar& history, bool ended)
{
  nlohmann::json content = {{"ended", ended}, {"scene", scene_}};
  content["files"]["history.csv"] = {{"bytes", history.bytes}, {"crc32", history.crc}};
  if (ended)
    for (const std::string& name : resultNames())
      if (const std::string path = folder_ + "/" + name;
          name != "manifest.json" && std::filesystem::exists(path))
      {
        syncFile(path); // before it is said to be complete
        if (name == "history.csv")
          continue; // what the run has written counts, not what the disk holds
        // Files of HDF5 have checksums of their own.
        const bool text = name.find(".h5") == std::string::npos;
        content["files"][name] =
            text ? checksumOf(path) : nlohmann::json{{"bytes", std::filesystem::file_size(path)}};
      }
  std::string text = content.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
  text.replace(text.rfind('\n'), std::string::npos, ",\n");
  // Each second without waiting for the disk.
  (ended ? replaceFile : replaceFileUnsynced)(
      folder_ + "/manifest.json", text + "  \"manifest_crc32\": " + std::to_string(crcOf(text)) + "\n}\n");
  last_ = wallClock();
}

} // namespace Rhegma
