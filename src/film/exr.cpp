// OpenEXR: every channel as 32-bit floats, metadata as typed attributes.

#include "film/codecs.h"
#include "film/exr_check.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfVersion.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <type_traits>

namespace vkpt::film {

namespace {

static_assert(std::endian::native == std::endian::little, "the fields of EXR's header are little endian");

class OutStream : public Imf::OStream {
public:
  explicit OutStream(AtomicFile& file) : Imf::OStream("image"), m_file(file) {}
  void write(const char bytes[], int count) override {
    m_file.write({reinterpret_cast<const unsigned char*>(bytes), static_cast<std::size_t>(count)});
  }
  std::uint64_t tellp() override { return m_file.position(); }
  void seekp(std::uint64_t position) override { m_file.seek(position); }

private:
  AtomicFile& m_file;
};

class InStream : public Imf::IStream {
public:
  explicit InStream(ByteView file) : Imf::IStream("image"), m_file(file) {}
  bool read(char bytes[], int count) override {
    const auto n = static_cast<std::size_t>(count);
    if (count < 0 || m_position > m_file.size() || n > m_file.size() - m_position)
      throw FormatError("broken EXR: the file ends too soon");
    std::copy_n(m_file.data() + m_position, n, reinterpret_cast<unsigned char*>(bytes));
    m_position += n;
    return m_position < m_file.size();
  }
  std::uint64_t tellg() override { return m_position; }
  void seekg(std::uint64_t position) override { m_position = position; }

private:
  ByteView m_file;
  std::uint64_t m_position = 0;
};

void insertAttribute(Imf::Header& header, const std::string& name, const Metadata::mapped_type& value) {
  std::visit(
      [&](const auto& v) {
        using T = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<T, std::string>)
          header.insert(name, Imf::StringAttribute(v));
        else if constexpr (std::is_same_v<T, double>)
          header.insert(name, Imf::DoubleAttribute(v));
        else if (v >= std::numeric_limits<int>::min() && v <= std::numeric_limits<int>::max())
          header.insert(name, Imf::IntAttribute(static_cast<int>(v)));
        else
          header.insert(name, Imf::StringAttribute(std::to_string(v)));
      },
      value);
}

/// The first look at a file, before OpenEXR and we allocate for it: a size that the file cannot hold is a
/// broken file's, and shall not cost memory. Gives the size of the data window.
Imf::Header checkedHeader(ByteView file, int& width, int& height) {
  int version = checkExrAttributes(file);
  InStream in(file);
  in.seekg(kFirstExrAttribute);
  Imf::Header header;
  header.readFrom(in, version);
  header.sanityCheck((version & Imf::TILED_FLAG) != 0);

  const Imath::Box2i& window = header.dataWindow();
  const auto w = std::int64_t{window.max.x} - window.min.x + 1;
  const auto h = std::int64_t{window.max.y} - window.min.y + 1;
  constexpr std::int64_t kMostPixelsOfASide = 1 << 28;
  if (w < 1 || h < 1 || std::max(w, h) > kMostPixelsOfASide || !exrFileJustifies(file.size(), header, w, h))
    throw FormatError(fmt::format("broken EXR: {}x{} pixels in a file of {} bytes", w, h, file.size()));
  width = static_cast<int>(w);
  height = static_cast<int>(h);
  return header;
}

/// Which of the file's channels become the image's R, G and B, and which go along.
struct ChannelPlan {
  std::array<std::string, 3> colours;
  std::vector<std::string> others;
};

ChannelPlan planChannels(const Imf::ChannelList& channels) {
  ChannelPlan plan{{"R", "G", "B"}, {}};
  const bool rgb =
      std::ranges::all_of(plan.colours, [&](const auto& n) { return channels.findChannel(n) != nullptr; });
  const bool grey = channels.findChannel("Y") != nullptr && channels.findChannel("RY") == nullptr &&
                    channels.findChannel("BY") == nullptr;
  if (!rgb)
    plan.colours.fill("Y");
  std::string found;
  bool subsampled = false;
  for (auto c = channels.begin(); c != channels.end(); ++c) {
    found += (found.empty() ? "" : ", ") + std::string(c.name());
    subsampled = subsampled || c.channel().xSampling != 1 || c.channel().ySampling != 1;
    if (std::ranges::find(plan.colours, c.name()) == plan.colours.end())
      plan.others.emplace_back(c.name());
  }
  if (!rgb && !grey)
    throw FormatError(fmt::format("EXR with the channels {}; R, G and B or a lone Y are needed",
                                  found.empty() ? "(none)" : found));
  if (subsampled)
    throw FormatError(
        fmt::format("EXR with the channels {}, some of them subsampled; all must be of full size", found));
  return plan;
}

} // namespace

void writeExr(AtomicFile& out, const Image& image, const Metadata& metadata) {
  Imf::Header header(image.width, image.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::FrameBuffer frame;
  const std::size_t stride = sizeof(float), row = stride * static_cast<std::size_t>(image.width);
  for (const Image::Channel& channel : image.channels) {
    header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    char* base = const_cast<char*>(reinterpret_cast<const char*>(channel.values.data())); // only read from
    frame.insert(channel.name, Imf::Slice(Imf::FLOAT, base, stride, row));
  }
  for (const auto& [key, value] : metadata)
    insertAttribute(header, metadataName(key), value);
  OutStream stream(out);
  Imf::OutputFile file(stream, header, 0); // no threads; its destructor writes the table of offsets
  file.setFrameBuffer(frame);
  file.writePixels(image.height);
}

Image decodeExr(ByteView bytes) {
  int width = 0, height = 0;
  const Imf::Header header = checkedHeader(bytes, width, height);
  const ChannelPlan plan = planChannels(header.channels());
  InStream stream(bytes);
  Imf::InputFile file(stream, 0);
  Image image(width, height, {"R", "G", "B"});
  image.channels.reserve(3 + plan.others.size());
  Imf::FrameBuffer frame;
  const auto read = [&](const std::string& name, Image::Channel& channel) {
    frame.insert(name, Imf::Slice::Make(Imf::FLOAT, channel.values.data(), header.dataWindow()));
  };
  const bool grey = plan.colours[1] == plan.colours[0];
  for (std::size_t c = 0; c < (grey ? 1U : 3U); ++c)
    read(plan.colours[c], image.channels[c]);
  for (const std::string& name : plan.others)
    read(name, image.addChannel(name));
  file.setFrameBuffer(frame);
  file.readPixels(header.dataWindow().min.y, header.dataWindow().max.y);
  if (grey)
    image.channels[1].values = image.channels[2].values = image.channels[0].values;
  return image;
}

} // namespace vkpt::film
