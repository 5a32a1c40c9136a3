#include "decode/crc32.h"
#include "unit/scene/image_bytes.h"
#include "unit/scene/scene_check.h"

#include "scene/texture_arguments.h"
#include "scene/texture_file.h"

#include <random>

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

/// kSquare with a texture coordinate at each corner, which is its position.
constexpr std::string_view kMapped = "mtllib scene.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                     "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
const std::vector<std::uint8_t> kFour{255, 0, 10, 11, 128, 200, 1, 2, 3, 254, 77, 33};

/// A folder with scene.mtl of the material m and an image "a.png" of 2x2 texels, and what kMapped becomes.
class Textures : public testing::Test {
protected:
  Textures() { m_folder.write("a.png", imageBytes("png", 2, 2, kFour)); }
  Loaded loadMapped(std::string_view body, std::string_view obj = kMapped) {
    m_folder.write("scene.mtl", "newmtl m\n" + std::string(body));
    return load({m_folder.write("scene.obj", obj)});
  }
  TempFolder m_folder;
};

void expectTexel(const Vec3f& texel, const Vec3d& expected, double tolerance = 1e-7) {
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(texel[c], expected[c], tolerance);
  }
}

TEST_F(Textures, AreDecodedFromSrgbRowByRowFromTheTop) {
  const auto [scene, report] = loadMapped("Kd .5 .6 .7\nmap_Kd a.png\nillum 1\n");
  EXPECT_TRUE(report.warnings.empty());
  ASSERT_EQ(scene.textures.size(), 1U);
  EXPECT_EQ(scene.materials.at(0).texture, 0U);
  EXPECT_EQ(scene.materials.at(0).bsdf, BsdfType::Diffuse);
  EXPECT_EQ(scene.materials.at(0).reflectance, Vec3f(0.5F, 0.6F, 0.7F)) << "Kd itself";
  const Texture& texture = scene.textures[0];
  EXPECT_EQ(texture.width, 2);
  EXPECT_EQ(texture.height, 2);
  EXPECT_TRUE(texture.name.ends_with("a.png")) << texture.name;
  EXPECT_TRUE(texture.where.text().ends_with("scene.mtl:3")) << texture.where.text();
  ASSERT_EQ(texture.texels.size(), 4U);
  // By IEC 61966-2-1: 10 is the last byte on the straight piece.
  expectTexel(texture.texels[0], {1.0, 0.0, 0.0030352698});
  expectTexel(texture.texels[1], {0.0033465358, 0.2158605, 0.5775804});
  expectTexel(texture.texels[2], {0.000303527, 0.000607054, 0.000910581});
  expectTexel(texture.texels[3], {0.9911021, 0.0742136, 0.0152085});
}

TEST_F(Textures, OfHdrAreLinear) {
  m_folder.write("a.hdr", hdrRow(2, {128, 64, 32, 129, 1, 2, 4, 138}));
  const auto [scene, report] = loadMapped("Kd 1 1 1\nmap_Kd a.hdr\nillum 1\n");
  ASSERT_EQ(scene.textures.size(), 1U);
  EXPECT_EQ(scene.textures[0].texels, (std::vector<Vec3f>{{1, 0.5F, 0.25F}, {4, 8, 16}}));
  ASSERT_EQ(report.warnings.size(), 1U);
  EXPECT_TRUE(anyContains(report.warnings, "Kd times map_Kd 4 8 16 is above 1")) << report.warnings[0];
}

TEST_F(Textures, MayBeJpegBmpOrTga) {
  const std::vector<std::uint8_t> grey{200, 200, 200, 50, 50, 50};
  for (const std::string format : {"jpg", "bmp", "tga"}) {
    m_folder.write("x." + format, imageBytes(format, 2, 1, grey));
    const auto [scene, report] = loadMapped("map_Kd x." + format + "\nillum 1\n");
    EXPECT_TRUE(report.warnings.empty()) << format;
    ASSERT_EQ(scene.textures.size(), 1U) << format;
    expectTexel(scene.textures[0].texels.at(0), Vec3d(0.5775804), 0.02); // JPEG loses a little
    expectTexel(scene.textures[0].texels.at(1), Vec3d(0.0318960), 0.02);
  }
}

TEST_F(Textures, CoordinatesFollowTheCorners) {
  const auto [scene, report] =
      loadMapped("map_Kd a.png\n",
                 "mtllib scene.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\n"
                 "vt 9 9\nvt 0.25 -3.5 7\nvt 2\nf 2/3/1 3/2/1 1/-1/1\nf 1/4 3/2 4/5\nvt 5 6\nvt 7 8\n");
  ASSERT_EQ(scene.triangles.size(), 2U);
  const auto uv = [&](std::size_t t, std::size_t corner) {
    return scene.uvs.at(scene.triangles[t].uv[corner]);
  };
  EXPECT_EQ(uv(0, 0), Vec2f(2, 0)) << "v absent: 0";
  EXPECT_EQ(uv(0, 1), Vec2f(0.25F, -3.5F));
  EXPECT_EQ(uv(0, 2), Vec2f(2, 0)) << "negative index";
  EXPECT_EQ(uv(1, 0), Vec2f(5, 6)) << "an index may point forward";
  EXPECT_EQ(uv(1, 1), Vec2f(0.25F, -3.5F));
  EXPECT_EQ(uv(1, 2), Vec2f(7, 8));
  EXPECT_EQ(scene.uvs.size(), 4U) << "only those that are used, each once";
  EXPECT_TRUE(report.warnings.empty());
}

TEST_F(Textures, CoordinatesAreKeptOnlyUnderATexture) {
  const auto [scene, report] = loadMapped("map_Kd a.png\nnewmtl plain\nKd .5 .5 .5\n",
                                          std::string(kMapped) + "usemtl plain\nf 1/2 2/3 3/4\nf 1/1 3 4\n");
  ASSERT_EQ(scene.triangles.size(), 4U);
  EXPECT_EQ(scene.uvs.size(), 4U);
  const std::array<std::uint32_t, 3> none{kNoUv, kNoUv, kNoUv};
  for (const Triangle& t : trianglesOf(scene, "plain")) {
    EXPECT_EQ(t.uv, none);
  }
  EXPECT_TRUE(report.warnings.empty());
  EXPECT_TRUE(loadMapped("Kd .5 .5 .5\n").scene.uvs.empty());
}

TEST_F(Textures, TrianglesWithoutCoordinatesAreOneWarningAFile) {
  m_folder.write("other.obj", "mtllib scene.mtl\nusemtl m\n" + std::string(kSquare));
  m_folder.write("scene.mtl", "newmtl m\nmap_Kd a.png\n");
  const auto [scene, report] =
      load({m_folder.write("scene.obj", std::string(kMapped) + "f 1/1 2/2 3\nf 1 2 4\n"),
            m_folder.path() / "other.obj"});
  ASSERT_EQ(report.warnings.size(), 2U);
  EXPECT_TRUE(anyContains(report.warnings,
                          "scene.obj:12: 2 triangles with a texture but no texture coordinates, the first "
                          "here; taken as 0 0"))
      << report.warnings[0];
  EXPECT_TRUE(anyContains(report.warnings, "other.obj:7: 2 triangles with a texture but no"));
  for (std::size_t t = 2; t < 6; ++t) {
    for (const std::uint32_t uv : scene.triangles.at(t).uv) {
      EXPECT_EQ(scene.uvs.at(uv), Vec2f(0.0F)) << "all three or none: " << t;
    }
  }
  EXPECT_EQ(scene.uvs.size(), 6U);
}

TEST_F(Textures, CoordinatesThatAreNoneAreZero) {
  const auto [scene, report] =
      loadMapped("map_Kd a.png\n", "mtllib scene.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                                   "vt nan 1\nvt 1 1e30\nvt .5 .5\nf 1/1 2/2 3/3\n");
  ASSERT_EQ(report.warnings.size(), 1U);
  EXPECT_TRUE(anyContains(report.warnings, "scene.obj:6: 2 texture coordinates are not finite"))
      << report.warnings[0];
  EXPECT_EQ(scene.uvs, (std::vector<Vec2f>{{0, 0}, {0, 0}, {0.5F, 0.5F}}));
}

TEST_F(Textures, ThatAreConstantAreColours) {
  m_folder.write("one.png", imageBytes("png", 1, 1, {255, 128, 0}));
  m_folder.write("same.png", imageBytes("png", 2, 1, {255, 128, 0, 255, 128, 0}));
  for (const char* name : {"one.png", "same.png"}) {
    const auto [scene, report] = loadMapped(std::string("Kd .5 .5 .5\nmap_Kd ") + name + "\n");
    EXPECT_EQ(scene.materials.at(0).texture, kNoTexture);
    expectTexel(scene.materials.at(0).reflectance, {0.5, 0.5 * 0.2158605, 0.0});
    EXPECT_TRUE(scene.textures.empty());
    EXPECT_TRUE(scene.uvs.empty());
    EXPECT_TRUE(report.warnings.empty());
  }
  m_folder.write("red.png", imageBytes("png", 2, 1, {255, 128, 0, 0, 128, 0}));
  const auto varies = loadMapped("Kd .5 .5 .5\nmap_Kd red.png\n");
  EXPECT_EQ(varies.scene.textures.size(), 1U);
  const auto masked = loadMapped("Kd 0 .5 .5\nmap_Kd red.png\n");
  EXPECT_TRUE(masked.scene.textures.empty()) << "it varies only where Kd is 0";
  expectTexel(masked.scene.materials.at(0).reflectance, {0.0, 0.5 * 0.2158605, 0.0});
}

TEST_F(Textures, ThatCannotBeReadLeaveKdAndAWarning) {
  const std::string png = imageBytes("png", 2, 2, kFour);
  m_folder.write("cut.png", png.substr(0, png.size() - 20));
  std::string changed = png;
  changed[png.size() - 20] = static_cast<char>(changed[png.size() - 20] ^ 1);
  m_folder.write("changed.png", changed);
  m_folder.write("text.jpg", "no image at all");
  m_folder.write("empty.png", "");
  m_folder.write("endless.hdr", hdrRow(2, {9, 0, 0, 255, 1, 2, 3, 1}, "EXPOSURE=1e-30\n"));
  fs::create_directory(m_folder.path() / "folder.png");
  for (const auto& [name, reason] : {std::pair{"none.png", "no such file"},
                                     {"cut.png", "broken PNG: the file ends too soon"},
                                     {"changed.png", "broken PNG: a chunk's CRC is wrong"},
                                     {"text.jpg", "broken image: "},
                                     {"empty.png", "broken image: "},
                                     {"endless.hdr", "holds values beyond the range of float"},
                                     {"folder.png", "is no regular file"}}) {
    const auto [scene, report] = loadMapped(std::string("Kd .1 .2 .3\nillum 1\nmap_Kd ") + name + "\n");
    EXPECT_EQ(scene.materials.at(0).reflectance, Vec3f(0.1F, 0.2F, 0.3F)) << name;
    EXPECT_EQ(scene.materials.at(0).texture, kNoTexture) << name;
    EXPECT_TRUE(scene.textures.empty()) << name;
    EXPECT_TRUE(scene.uvs.empty()) << name;
    ASSERT_EQ(report.warnings.size(), 1U) << name;
    const std::string& warning = report.warnings[0];
    EXPECT_NE(warning.find("scene.mtl:4: map_Kd: "), std::string::npos) << warning;
    EXPECT_NE(warning.find(std::string(name) + ": " + reason), std::string::npos) << warning;
    EXPECT_TRUE(warning.ends_with("; Kd holds everywhere")) << warning;
  }
}

TEST_F(Textures, OfOneFileAreOneTexture) {
  m_folder.write("b.png", imageBytes("png", 1, 2, {1, 2, 3, 4, 5, 6}));
  m_folder.write("sub/c.mtl", "newmtl c\nmap_Kd ../a.png\nnewmtl e\nmap_Kd ../none.png\n");
  const auto [scene, report] =
      loadMapped("map_Kd a.png\nnewmtl b\nmap_Kd b.png\nnewmtl d\nKd .1 .1 .1\nmap_Kd ./sub/../a.png\n"
                 "newmtl f\nmap_Kd none.png\n",
                 std::string(kMapped) + "mtllib sub/c.mtl\nusemtl b\nf 1/1 2/2 3/3\nusemtl c\nf 1/1 2/2 3/3\n"
                                        "usemtl d\nf 1/1 2/2 3/3\nusemtl e\nf 1 2 3\nusemtl f\nf 1 2 3\n");
  EXPECT_EQ(scene.textures.size(), 2U);
  const std::uint32_t a = materialNamed(scene, "m").texture;
  EXPECT_EQ(materialNamed(scene, "c").texture, a) << "relative to its own MTL file";
  EXPECT_EQ(materialNamed(scene, "d").texture, a);
  EXPECT_NE(materialNamed(scene, "b").texture, a);
  EXPECT_EQ(scene.textures.at(a).texels.size(), 4U);
  EXPECT_EQ(countContaining(report.warnings, "none.png: no such file"), 1U);
  EXPECT_EQ(report.warnings.size(), 1U);
}

TEST_F(Textures, NamesMayHoldBlanksBackslashesAndHashes) {
  m_folder.write("sub/my  wood #1.png", imageBytes("png", 2, 2, kFour));
  for (const char* name : {"sub/my  wood #1.png", "sub\\my  wood #1.png", "-s 1 1 1 sub/my  wood #1.png"}) {
    const auto [scene, report] = loadMapped(std::string("map_Kd ") + name + "\n");
    EXPECT_EQ(scene.textures.size(), 1U) << name;
    EXPECT_TRUE(report.warnings.empty()) << name;
  }
}

TEST_F(Textures, OptionsWarnOncePerOptionUnlessNeutral) {
  const auto [scene, report] =
      loadMapped("map_Kd -s 2 2 2 -o 0 0 0 -clamp on a.png\nnewmtl b\nmap_Kd -s 3 a.png\nnewmtl c\nmap_Kd\n",
                 std::string(kMapped) + "usemtl b\nf 1/1 2/2 3/3\nusemtl c\nf 1 2 3\n");
  EXPECT_EQ(materialNamed(scene, "m").texture, 0U);
  EXPECT_EQ(materialNamed(scene, "b").texture, 0U);
  EXPECT_EQ(materialNamed(scene, "c").texture, kNoTexture);
  EXPECT_EQ(countContaining(report.warnings, "scene.mtl:2: map_Kd -s: this option is not used"), 1U);
  EXPECT_EQ(countContaining(report.warnings, "scene.mtl:2: map_Kd -clamp: this option is not used"), 1U);
  EXPECT_EQ(countContaining(report.warnings, "scene.mtl:6: map_Kd names no file"), 1U);
  EXPECT_EQ(report.warnings.size(), 3U);
}

TEST_F(Textures, GoWithPhongAndNotWithOtherShaders) {
  const auto phong = loadMapped("Kd .5 .5 .5\nKs .5 .5 .5\nNs 9\nillum 2\nmap_Kd a.png\n");
  EXPECT_EQ(phong.scene.materials.at(0).bsdf, BsdfType::Phong);
  EXPECT_EQ(phong.scene.materials.at(0).texture, 0U);
  EXPECT_TRUE(phong.report.warnings.empty());
  for (const char* illum : {"3", "4"}) {
    const auto [scene, report] = loadMapped(std::string("map_Kd a.png\nillum ") + illum + "\n");
    EXPECT_TRUE(scene.textures.empty());
    EXPECT_TRUE(scene.uvs.empty());
    ASSERT_EQ(report.warnings.size(), 1U);
    EXPECT_TRUE(anyContains(report.warnings, "scene.mtl:2: material 'm': illum " + std::string(illum) +
                                                 " has no texture; map_Kd is not used"))
        << report.warnings[0];
  }
}

TEST(TextureArguments, OptionsEndWhereTheNameBegins) {
  struct Case {
    const char* arguments;
    const char* file;
    std::vector<std::string_view> options;
  };
  for (const Case& c : {Case{"a.png", "a.png", {}},
                        {"a b.png", "a b.png", {}},
                        {"-s 2 a b.png", "a b.png", {"-s"}},
                        {"-s 2 3 4 5.png", "5.png", {"-s"}},
                        {"-s 2 3 4", "4", {"-s"}},
                        {"-o 0 -t 0 0 1 -s 1 1 1 a.png", "a.png", {"-t"}},
                        {"-mm 0 1 a.png", "a.png", {}},
                        {"-mm 1 1 a.png", "a.png", {"-mm"}},
                        {"-clamp off -blendu on -blendv off a.png", "a.png", {"-blendv"}},
                        {"-new 3 a.png", "-new 3 a.png", {}},
                        {"-s 2 #1.png", "#1.png", {"-s"}},
                        {"-s", "", {}},
                        {"", "", {}}}) {
    const TextureArguments parsed = parseTextureArguments(c.arguments);
    EXPECT_EQ(parsed.file, c.file) << c.arguments;
    EXPECT_EQ(parsed.unusedOptions, c.options) << c.arguments;
  }
}

/// No image does any harm: it is read or refused.
class BrokenImages : public testing::TestWithParam<const char*> {
protected:
  void read(std::string_view bytes) {
    try {
      const ImageFile image = readImageFile(m_folder.write("x", bytes));
      EXPECT_EQ(image.texels.size(),
                static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    } catch (const SceneError& error) {
      EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos) << error.what();
    } catch (const std::bad_alloc&) {
      // a size that no machine holds
    }
  }
  TempFolder m_folder;
};

TEST_P(BrokenImages, AreReadOrRefused) {
  std::mt19937 random(7);
  std::vector<std::uint8_t> rgb(3 * 24 * 17);
  for (std::uint8_t& sample : rgb) {
    sample = static_cast<std::uint8_t>(random());
  }
  const std::string whole = imageBytes(GetParam(), 24, 17, rgb);
  for (std::size_t length = 0; length < whole.size(); length += 1 + length / 40) {
    read(std::string_view(whole).substr(0, length));
  }
  constexpr int kRounds = 300;
  for (int round = 0; round < kRounds; ++round) {
    std::string changed = whole;
    const std::size_t reach = round % 2 == 0 ? std::min<std::size_t>(whole.size(), 200) : whole.size();
    changed[random() % reach] = static_cast<char>(random());
    read(changed);
  }
}

/// Of an image in memory, by its error.
std::string refusal(const std::string& bytes) {
  const TempFolder folder;
  try {
    readImageFile(folder.write("x", bytes));
  } catch (const SceneError& error) {
    return error.what();
  }
  return {};
}

TEST(BrokenImage, SizesThatTheFileCannotHoldAreRefused) {
  // TGA: bytes 12 to 15 are width and height.
  std::string tga = imageBytes("tga", 2, 1, {1, 2, 3, 4, 5, 6});
  tga.replace(12, 4, "\xff\x0f\xff\x0f");
  EXPECT_TRUE(refusal(tga).ends_with("broken image: the file ends too soon")) << refusal(tga);
  tga.replace(12, 4, "\xff\xff\xff\xff");
  EXPECT_TRUE(refusal(tga).ends_with("too many pixels")) << refusal(tga);
  // PNG: bytes 16 to 19 are the width; the CRC of the header stands at 29.
  std::string png = imageBytes("png", 2, 1, {1, 2, 3, 4, 5, 6});
  png.replace(16, 4, std::string("\0\xff\0\0", 4));
  const std::uint32_t crc = decode::crc32({reinterpret_cast<const unsigned char*>(png.data()) + 12, 17});
  for (std::size_t i = 0; i < 4; ++i)
    png[29 + i] = static_cast<char>(crc >> (24 - 8 * i));
  EXPECT_TRUE(refusal(png).ends_with("broken PNG: it ends too soon for its size")) << refusal(png);
}

TEST(BrokenImage, JpegTablesOfTooManyCodesAreRefused) {
  std::string jpg = imageBytes("jpg", 2, 1, {1, 2, 3, 200, 5, 6});
  const auto tables = jpg.find("\xff\xc4");
  ASSERT_NE(tables, std::string::npos);
  EXPECT_EQ(refusal(jpg), "");
  jpg.replace(tables + 5, 2, "\xff\xff"); // of the lengths 1 and 2
  EXPECT_TRUE(refusal(jpg).ends_with("broken JPEG: a Huffman table of more than 256 codes")) << refusal(jpg);
  jpg.resize(tables + 7); // the file ends in the table
  EXPECT_TRUE(refusal(jpg).ends_with("broken JPEG: a Huffman table of more than 256 codes")) << refusal(jpg);
  EXPECT_TRUE(refusal('\xff' + imageBytes("jpg", 2, 1, {1, 2, 3, 200, 5, 6})).ends_with("FF D8"));
  // The bytes of such a table in a comment are none.
  std::string comment = imageBytes("jpg", 2, 1, {1, 2, 3, 200, 5, 6});
  comment.insert(2, std::string("\xff\xfe\0\x18\xff\xc4\0\x14", 8) + std::string(18, '\xff'));
  EXPECT_EQ(refusal(comment), "");
}

INSTANTIATE_TEST_SUITE_P(Formats, BrokenImages, testing::Values("png", "jpg", "bmp", "tga"));

} // namespace
} // namespace vkpt::test
