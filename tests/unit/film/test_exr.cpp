// EXR files of ours read by OpenEXR, and files of OpenEXR's read by us.

#include "unit/film/film_fixtures.h"

#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTiledOutputFile.h>

#include <limits>

namespace vkpt::test {
namespace {

TEST(Exr, MetadataBecomesTypedAttributes) {
  const TemporaryFolder folder;
  const std::int64_t large = std::numeric_limits<std::int64_t>::min();
  const Metadata metadata{{"scene", "box \"\xC3\xBC\"\nline"},
                          {"empty", ""},
                          {"seconds", 0.1},
                          {"tiny", 5e-324},
                          {"frames", std::int64_t{-64}},
                          {"most", std::int64_t{2147483647}},
                          {"more", std::int64_t{2147483648}},
                          {"seed", large},
                          {"a name of more than 31 characters", 1.0}};
  writeImage(folder / "x.exr", noise(3, 2), {}, metadata);
  const Imf::InputFile file((folder / "x.exr").c_str());
  const Imf::Header& header = file.header();
  EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("vkpt.scene").value(), "box \"\xC3\xBC\"\nline");
  EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("vkpt.empty").value(), "");
  EXPECT_EQ(header.typedAttribute<Imf::DoubleAttribute>("vkpt.seconds").value(), 0.1);
  EXPECT_EQ(header.typedAttribute<Imf::DoubleAttribute>("vkpt.tiny").value(), 5e-324);
  EXPECT_EQ(header.typedAttribute<Imf::IntAttribute>("vkpt.frames").value(), -64);
  EXPECT_EQ(header.typedAttribute<Imf::IntAttribute>("vkpt.most").value(), 2147483647);
  EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("vkpt.more").value(), "2147483648");
  EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("vkpt.seed").value(), "-9223372036854775808");
  EXPECT_EQ(header.typedAttribute<Imf::DoubleAttribute>("vkpt.a name of more than 31 characters").value(),
            1.0);
}

TEST(Exr, ChannelsAreFloatsUnderTheirNames) {
  const TemporaryFolder folder;
  writeImage(folder / "x.exr", noise(3, 2, {"R", "G", "B", "stderr.R", "stderr.G", "stderr.B"}), {}, {});
  const Imf::InputFile file((folder / "x.exr").c_str());
  std::set<std::string> layers, names;
  file.header().channels().layers(layers);
  for (auto c = file.header().channels().begin(); c != file.header().channels().end(); ++c) {
    names.insert(c.name());
    EXPECT_EQ(c.channel().type, Imf::FLOAT);
  }
  EXPECT_EQ(layers, std::set<std::string>{"stderr"});
  EXPECT_EQ(names, (std::set<std::string>{"R", "G", "B", "stderr.R", "stderr.G", "stderr.B"}));
}

/// A plane of one sample type with values 1, 2, 3, ... from the top left on.
template<class T>
void writeExr(const fs::path& path, const std::vector<std::string>& names, Imf::PixelType type,
              const Imath::Box2i& window, int sampling = 1) {
  Imf::Header header(Imath::Box2i({0, 0}, {19, 19}), window);
  const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
  std::vector<T> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<T>(static_cast<float>(i + 1));
  Imf::FrameBuffer frame;
  for (const std::string& name : names) {
    header.channels().insert(name, Imf::Channel(type, sampling, sampling));
    frame.insert(name, Imf::Slice::Make(type, values.data(), window, sizeof(T), 0, sampling, sampling));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame);
  file.writePixels(height);
}

void expectCounting(const Image& image, const char* name) {
  const Image::Channel* channel = image.find(name);
  ASSERT_NE(channel, nullptr) << name;
  for (std::size_t i = 0; i < channel->values.size(); ++i)
    EXPECT_EQ(channel->values[i], static_cast<float>(i + 1)) << name;
}

TEST(Exr, ReadsEverySampleTypeAndADataWindowAnywhere) {
  const TemporaryFolder folder;
  const Imath::Box2i windows[] = {{{0, 0}, {6, 4}}, {{5, 3}, {11, 7}}, {{-100, -7}, {-94, -3}}};
  for (const Imath::Box2i& window : windows) {
    writeExr<half>(folder / "half.exr", {"R", "G", "B", "A"}, Imf::HALF, window);
    writeExr<float>(folder / "float.exr", {"B", "G", "R", "Z"}, Imf::FLOAT, window);
    writeExr<unsigned>(folder / "uint.exr", {"B", "G", "R", "id"}, Imf::UINT, window);
    const char* others[] = {"A", "Z", "id"};
    const char* files[] = {"half.exr", "float.exr", "uint.exr"};
    for (std::size_t f = 0; f < 3; ++f) {
      const Image image = readImage(folder / files[f]);
      EXPECT_EQ(image.width, 7);
      EXPECT_EQ(image.height, 5);
      ASSERT_EQ(image.channels.size(), 4U);
      EXPECT_EQ(image.channels[0].name + image.channels[1].name + image.channels[2].name, "RGB");
      for (const char* name : {"R", "G", "B", others[f]})
        expectCounting(image, name);
    }
  }
}

TEST(Exr, ReadsTiles) {
  const TemporaryFolder folder;
  Imf::Header header(37, 21);
  header.setTileDescription(Imf::TileDescription(16, 8));
  std::vector<float> values(37 * 21);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<float>(i + 1);
  Imf::FrameBuffer frame;
  for (const char* name : {"R", "G", "B"}) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    frame.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), header.dataWindow()));
  }
  {
    Imf::TiledOutputFile file((folder / "x.exr").c_str(), header);
    file.setFrameBuffer(frame);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  }
  for (const char* name : {"R", "G", "B"})
    expectCounting(readImage(folder / "x.exr"), name);
}

TEST(Exr, LuminanceIsGrey) {
  const TemporaryFolder folder;
  writeExr<float>(folder / "x.exr", {"A", "Y"}, Imf::FLOAT, {{0, 0}, {3, 3}});
  const Image image = readImage(folder / "x.exr");
  ASSERT_EQ(image.channels.size(), 4U);
  for (const char* name : {"R", "G", "B", "A"})
    expectCounting(image, name);
}

TEST(Exr, OtherChannelSetsAreNamed) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::vector<std::string>& names, int sampling = 1) {
    writeExr<float>(folder / "x.exr", names, Imf::FLOAT, {{0, 0}, {3, 3}}, sampling);
    return messageOf<SceneError>([&] { readImage(folder / "x.exr"); });
  };
  EXPECT_NE(refusal({"depth.Z", "G", "R"}).find("channels G, R, depth.Z; R, G and B or a lone Y"),
            std::string::npos);
  EXPECT_NE(refusal({"BY", "RY", "Y"}).find("channels BY, RY, Y;"), std::string::npos);
  EXPECT_NE(refusal({"RY", "Y"}).find("channels RY, Y;"), std::string::npos);
  EXPECT_NE(refusal({"BY", "Y"}).find("channels BY, Y;"), std::string::npos);
  EXPECT_NE(refusal({"R", "G", "B"}, 2).find("subsampled"), std::string::npos);
}

} // namespace
} // namespace vkpt::test
