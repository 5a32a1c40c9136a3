#include "gpu/pipeline_cache.h"

#include "core/hash.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <array>
#include <cstring>
#include <fstream>
#include <iterator>
#include <unistd.h>

namespace vkpt::gpu {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

/// Drivers check the header of what they are given, and trust the rest: the check of the whole is ours.
struct FileHeader {
  std::array<char, 8> magic{'v', 'k', 'p', 't', 'p', 'i', 'p', '1'};
  std::uint64_t key = 0;
  std::uint64_t bytes = 0; ///< that follow
  std::uint64_t hash = 0;  ///< of these
  bool operator==(const FileHeader&) const = default;
};

template<class T>
std::uint64_t hashOf(std::span<const T> values, std::uint64_t basis) {
  return hashBytes(std::as_bytes(values), basis);
}

FileHeader headerOf(std::uint64_t key, const Bytes& data) {
  FileHeader header;
  header.key = key;
  header.bytes = data.size();
  header.hash = hashOf(std::span<const std::uint8_t>(data), key);
  return header;
}

/// What the driver wrote once; empty where the file is not there or not what was written.
Bytes readData(const fs::path& path, std::uint64_t key) {
  std::ifstream file(path, std::ios::binary);
  const Bytes all{std::istreambuf_iterator<char>(file), {}};
  FileHeader header;
  if (all.size() < sizeof header)
    return {};
  std::memcpy(&header, all.data(), sizeof header);
  Bytes data(all.begin() + sizeof header, all.end());
  if (header == headerOf(key, data))
    return data;
  spdlog::debug("{}: not the pipeline that was written there; it is made again", path.string());
  return {};
}

/// The file is there as a whole or not at all; where it can't be written nothing happens.
void writeData(const fs::path& path, std::uint64_t key, const Bytes& data) {
  std::error_code failed;
  fs::create_directories(path.parent_path(), failed);
  const fs::path temporary = fmt::format("{}.{}.tmp", path.string(), ::getpid());
  const FileHeader header = headerOf(key, data);
  {
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(&header), sizeof header);
    file.write(reinterpret_cast<const char*>(data.data()), static_cast<std::streamsize>(data.size()));
    file.close();
    if (!file) {
      spdlog::debug("{}: can't be written; pipelines are not kept", temporary.string());
      fs::remove(temporary, failed);
      return;
    }
  }
  fs::rename(temporary, path, failed);
  if (failed)
    fs::remove(temporary, failed);
}

} // namespace

std::uint64_t pipelineKey(const Context& context, std::span<const std::uint32_t> spirv,
                          const SpecialisationMap& constants) {
  const vk::PhysicalDeviceProperties& p = context.properties();
  const std::array<std::uint32_t, 4> device{p.vendorID, p.deviceID, p.driverVersion, p.apiVersion};
  std::vector<std::uint32_t> values;
  for (const auto& [id, value] : constants)
    values.insert(values.end(), {id, value});
  std::uint64_t key = hashText(context.info().name + context.info().driver);
  key = hashOf(std::span<const std::uint32_t>(device), key);
  key = hashOf(std::span<const std::uint8_t>(p.pipelineCacheUUID), key);
  key = hashOf(std::span<const std::uint32_t>(values), key);
  return hashOf(spirv, key);
}

PipelineCache::PipelineCache(const Context& context, std::uint64_t pipelineKey) : m_key(pipelineKey) {
  if (context.pipelineCache().empty())
    return;
  m_file = context.pipelineCache() / fmt::format("{:016x}.pipeline", m_key);
  m_read = readData(m_file, m_key);
  m_cache = vk::raii::PipelineCache(
      context.device(),
      vk::PipelineCacheCreateInfo({}, m_read.size(), m_read.empty() ? nullptr : m_read.data()));
}

void PipelineCache::save() const {
  if (m_file.empty())
    return;
  const Bytes data = m_cache.getData();
  if (data != m_read)
    writeData(m_file, m_key, data);
}

} // namespace vkpt::gpu
