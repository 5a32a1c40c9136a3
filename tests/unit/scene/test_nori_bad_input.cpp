// Every fault of a Nori file: exit code 2 and one line with file, line and column, what is wrong and what
// would be right.

#include "unit/scene/nori_check.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

struct BadNori {
  const char* name;
  std::string xml;
  std::string expected; ///< how the message starts
};

void PrintTo(const BadNori& bad, std::ostream* out) { *out << bad.name; }

class BadNoriTest : public testing::TestWithParam<BadNori> {};

TEST_P(BadNoriTest, IsOneLineWithFileLineAndColumn) {
  const std::string what = NoriFolder().error(GetParam().xml);
  EXPECT_TRUE(what.starts_with(GetParam().expected)) << "message: " << what;
}

std::string camera(const std::string& inside) {
  return noriScene("<camera type='perspective'>\n " + inside + "</camera>", false);
}
std::string toWorld(const std::string& step) {
  return noriScene("<mesh type='obj'><string name='filename' value='square.obj'/>\n"
                   "<transform name='toWorld'>\n " +
                       step + "</transform></mesh>",
                   true, false);
}
std::string bsdf(const std::string& type, const std::string& property) {
  return noriScene("<mesh type='obj'><string name='filename' value='square.obj'/>\n<bsdf type='" + type +
                       "'>\n " + property + "</bsdf></mesh>",
                   true, false);
}
std::string light(const std::string& type, const std::string& property) {
  return noriScene("<emitter type='" + type + "'>\n " + property + "</emitter>");
}

const std::vector<BadNori> kSyntax{
    {"Empty", "", "scene.xml: no elements; a Nori file is a <scene> or a <test>"},
    {"OnlyRemarks", "<!-- nothing -->", "scene.xml: no elements"},
    {"NoXml", "hello\n", "scene.xml:1:1: text 'hello?' between elements"},
    {"NotClosed", "<scene>\n  <mesh>\n</scene>", "scene.xml:3:3: no XML: an element is not closed"},
    {"CutShort", "<scene>\n", "scene.xml:1:8: no XML: an element is not closed"},
    {"CutTag", "<scene>\n <mesh type=", "scene.xml:2:12: no XML: a broken attribute; write name=\"value\""},
    {"NoQuotes", "<scene>\n <mesh type=obj/></scene>", "scene.xml:2:13: no XML: a broken attribute"},
    {"BrokenTag", "<scene>\n<mesh /type='obj'></scene>", "scene.xml:2:8: no XML: a broken tag"},
    {"Comment", "<scene>\n <!-- ", "scene.xml:2:6: no XML: a comment is not closed; end it with -->"},
    {"Lonely", "<scene>\n < </scene>", "scene.xml:2:3: no XML: '<' is followed by no name"},
    {"Text", "<scene>\n\n  mesh = 1\n<mesh/></scene>",
     "scene.xml:3:3: text 'mesh = 1?' between elements; values stand in attributes"},
    {"TwoRoots", "<scene/>\n <scene/>", "scene.xml:2:2: a second root element, <scene>; a file has one"},
    {"TwoAttributes", "<scene>\n<mesh type='obj' type='ply'/></scene>",
     "scene.xml:2:1: <mesh> has two attributes 'type'; keep one"},
    {"ZeroByte", std::string("<scene>\n\0</scene>", 17), "scene.xml:2:1: a zero byte; a scene file is text"},
    {"OtherRoot", "\n<Scene/>", "scene.xml:2:1: unknown root element <Scene>; a Nori scene is a <scene>"},
};

const std::vector<BadNori> kObjects{
    {"UnknownElement", noriScene(" <messh type='obj'/>"),
     "scene.xml:2:2: unknown element <messh> in <scene>, which holds mesh, "},
    {"NearestElement", noriScene("<emiter type='area'/>"),
     "scene.xml:2:1: unknown element <emiter> in <scene>, which holds mesh, emitter, luminaire, camera, "
     "sampler, "
     "integrator, evaluator, boolean, integer, float, string, point, vector, color, transform, did you mean "
     "'emitter'?"},
    {"Misplaced", noriScene("<bsdf type='diffuse'/>"), "scene.xml:2:1: misplaced <bsdf> in <scene>"},
    {"Medium", noriScene("<medium type='homogeneous'/>"),
     "scene.xml:2:1: <medium>: vkpt renders no participating media; leave it out"},
    {"UnknownAttribute", noriScene("<mesh typ='obj'/>"),
     "scene.xml:2:1: <mesh> has an unknown attribute 'typ'; it has type, name, did you mean 'type'?"},
    {"NoType", noriScene("<mesh/>"), "scene.xml:2:1: <mesh> has no attribute 'type'; give it"},
    {"MeshType", noriScene("<mesh type='ply'/>"), "scene.xml:2:1: unknown mesh type 'ply'; vkpt knows obj"},
    {"BsdfType", bsdf("difuse", ""),
     "scene.xml:3:1: unknown bsdf type 'difuse'; vkpt knows diffuse, phong, mirror, dielectric, microfacet, "
     "conductor, roughconductor, roughdielectric, did you mean 'diffuse'?"},
    {"LightType", light("spot", ""), "scene.xml:2:1: unknown emitter type 'spot'; vkpt knows area, point, "},
    {"CameraType", noriScene("<camera type='thinlens'/>", false),
     "scene.xml:2:1: unknown camera type 'thinlens'; vkpt knows perspective"},
    {"FilterType", camera("<rfilter type='sinc'/>"),
     "scene.xml:3:2: unknown rfilter type 'sinc'; vkpt knows gaussian, mitchell, tent, box"},
    {"SamplerType", noriScene("<sampler type='halton'/>"),
     "scene.xml:2:1: unknown sampler type 'halton'; vkpt knows independent"},
    {"IntegratorType", noriScene("<integrator type='path_mus'/>"),
     "scene.xml:2:1: unknown integrator type 'path_mus'; vkpt knows path, path_mats, "},
    {"NoTransport", noriScene("<integrator type='ao'/>"),
     "scene.xml:2:1: vkpt does not render 'ao'; it renders light transport: path, path_mats, path_ems, "
     "path_mis, "
     "direct, "},
    {"Normals", noriScene("<integrator type='normals'/>"), "scene.xml:2:1: vkpt does not render 'normals'"},
    {"Depth", noriScene("<integrator type='depth'/>"), "scene.xml:2:1: vkpt does not render 'depth'"},
    {"NoCamera", noriScene("", false),
     "scene.xml:1:1: a scene without a camera; give <camera type=\"perspective\">"},
    {"NoMesh", noriScene("", true, false), "scene.xml:1:1: a scene without a mesh; give at least one"},
    {"TwoCameras", noriScene("<camera type='perspective'/>"),
     "scene.xml:3:1: a second <camera>, the first is at line 2; keep one"},
    {"TwoIntegrators", noriScene("<integrator type='path'/>\n<integrator type='path'/>"),
     "scene.xml:3:1: a second <integrator>, the first is at line 2; keep one"},
    {"TwoSamplers", noriScene("<sampler type='independent'/>\n<sampler type='independent'/>"),
     "scene.xml:3:1: a second <sampler>"},
    {"TwoFilters", camera("<rfilter type='box'/>\n<rfilter type='box'/>"),
     "scene.xml:4:1: a second <rfilter>"},
    {"TwoBsdfs", noriScene(noriMesh("square.obj", "\n<bsdf type='mirror'/>\n<bsdf type='mirror'/>")),
     "scene.xml:4:1: a second <bsdf>, the first is at line 3; keep one"},
    {"TwoLights", noriScene(noriMesh("square.obj", "\n<emitter type='area'/>\n<luminaire type='area'/>")),
     "scene.xml:4:1: a second <luminaire>"},
    {"AreaLightOutside", light("area", ""),
     "scene.xml:2:1: an area light outside a mesh; move it into the <mesh>"},
    {"PointLightInside", noriScene(noriMesh("square.obj", "\n<emitter type='point'/>")),
     "scene.xml:3:1: a light of type point in a mesh; move it out, into <scene>"},
    {"NoFile", noriScene("<mesh type='obj'/>"), "scene.xml:2:1: a mesh without a file; give <string"},
    {"MissingFile", noriScene("<mesh type='obj'>\n <string name='filename' value='sub/../gone.obj'/></mesh>"),
     "scene.xml:3:2: there is no file 'sub/../gone.obj' that can be read; names are relative to the scene's "
     "folder"},
    {"FileIsAFolder", noriScene("<mesh type='obj'>\n <string name='filename' value='.'/></mesh>"),
     "scene.xml:3:2: there is no file"},
    {"BadMesh", noriScene(noriMesh("scene.xml")), "scene.xml: no faces"},
};

const std::vector<BadNori> kProperties{
    {"NoName", camera("<float value='1'/>"), "scene.xml:3:2: <float> has no attribute 'name'; give it"},
    {"NoValue", camera("<float name='fov'/>"), "scene.xml:3:2: <float> has no attribute 'value'; give it"},
    {"ChildOfAProperty", camera("<float name='fov' value='1'>\n<float/></float>"),
     "scene.xml:4:1: <float> in a <float>, which holds no elements"},
    {"AttributeOfAProperty", camera("<float name='fov' valu='1'/>"),
     "scene.xml:3:2: <float> has an unknown attribute 'valu'; it has name, value, did you mean 'value'?"},
    {"NoNumber", camera("<float name='fov' value='wide'/>"), "scene.xml:3:2: fov: 'wide' is no number"},
    {"EmptyNumber", camera("<float name='fov' value=' '/>"),
     "scene.xml:3:2: fov: ' ' is 0 numbers; give one"},
    {"DecimalComma", camera("<float name='fov' value='39,3'/>"),
     "scene.xml:3:2: fov: '39,3' is 2 numbers; give one, with a point for its decimals"},
    {"Nan", camera("<float name='fov' value='nan'/>"),
     "scene.xml:3:2: fov: 'nan' is not finite; give a number"},
    {"Infinite", camera("<float name='fov' value='-1e999'/>"), "scene.xml:3:2: fov: '-1e999' is not finite"},
    {"BeyondFloat", bsdf("phong", "<float name='n' value='1e39'/>"),
     "scene.xml:4:2: n: '1e39' is beyond the range of float"},
    {"Trailing", camera("<float name='fov' value='30deg'/>"), "scene.xml:3:2: fov: '30deg' is no number"},
    {"Fraction", camera("<integer name='width' value='3.5'/>"),
     "scene.xml:3:2: width: '3.5' is no integer of 32 bits"},
    {"HugeInteger", camera("<integer name='width' value='99999999999'/>"),
     "scene.xml:3:2: width: '99999999999' is no integer of 32 bits"},
    {"FloatForInteger", camera("<float name='width' value='3'/>"),
     "scene.xml:3:2: width is given as <float>; write <integer>"},
    {"TextForNumber", camera("<string name='fov' value='30'/>"),
     "scene.xml:3:2: fov is given as <string>; write <float>"},
    {"TwoOfAColour", bsdf("diffuse", "<color name='albedo' value='.5 .5'/>"),
     "scene.xml:4:2: albedo: '.5 .5' is 2 numbers; give three, r g b"},
    {"OneOfAColour", bsdf("diffuse", "<color name='albedo' value='.5'/>"),
     "scene.xml:4:2: albedo: '.5' is 1 number; give three"},
    {"FourOfAColour", bsdf("diffuse", "<color name='albedo' value='1 1 1 1'/>"),
     "scene.xml:4:2: albedo: '1 1 1 1' is 4 numbers"},
    {"NegativeAlbedo", bsdf("diffuse", "<color name='albedo' value='.5 -.1 .5'/>"),
     "scene.xml:4:2: albedo is -0.1; give 0 to 1e12"},
    {"NegativeSpecular", bsdf("phong", "<color name='ks' value='-1 0 0'/>"),
     "scene.xml:4:2: ks is -1; give 0"},
    {"Exponent", bsdf("phong", "<float name='n' value='2e6'/>"), "scene.xml:4:2: n is 2e+06; give 0 to 1e6"},
    {"Ior", bsdf("dielectric", "<float name='intIOR' value='0'/>"),
     "scene.xml:4:2: intIOR is 0; give 1e-6 to 1e6; glass has 1.5"},
    {"OuterIor", bsdf("microfacet", "<float name='extIOR' value='-1'/>"),
     "scene.xml:4:2: extIOR is -1; give"},
    {"Absorption", bsdf("dielectric", "<color name='absorption' value='0 0 -1'/>"),
     "scene.xml:4:2: absorption is -1; give 0"},
    {"Alpha", bsdf("microfacet", "<float name='alpha' value='0'/>"),
     "scene.xml:4:2: alpha is 0; give 1e-4 to 10"},
    {"NegativeAlpha", bsdf("roughdielectric", "<float name='alpha' value='-.1'/>"),
     "scene.xml:4:2: alpha is -0.1; give 0"},
    {"CoatAboveOne", bsdf("microfacet", "<color name='kd' value='1.5 0 0'/>"),
     "scene.xml:4:2: kd is 1.5; give 0 to 1: the rest is specular"},
    {"Distribution", bsdf("roughdielectric", "<string name='distribution' value='beckman'/>"),
     "scene.xml:4:2: unknown distribution 'beckman'; give ggx or beckmann, did you mean 'beckmann'?"},
    {"NoMetal", bsdf("conductor", ""),
     "scene.xml:3:1: which metal? give either material (silver, gold, copper) or both eta and k"},
    {"TwoMetals",
     bsdf("conductor", "<string name='material' value='gold'/><color name='eta' value='1 1 1'/>"),
     "scene.xml:3:1: which metal?"},
    {"HalfAMetal", bsdf("roughconductor", "<color name='eta' value='1 1 1'/>"),
     "scene.xml:3:1: which metal?"},
    {"UnknownMetal", bsdf("conductor", "<string name='material' value='golt'/>"),
     "scene.xml:4:2: unknown material 'golt'; vkpt knows silver, gold, copper, did you mean 'gold'?; or give "
     "eta"},
    {"NegativeExtinction",
     bsdf("conductor", "<color name='eta' value='1 1 1'/>\n<color name='k' value='1 -1 1'/>"),
     "scene.xml:5:1: k is -1; give 0 to 1e6"},
    {"NoRadiance", noriScene(noriMesh("square.obj", "\n<emitter type='area'/>")),
     "scene.xml:3:1: a light without radiance; give <color name=\"radiance\""},
    {"NegativeRadiance",
     noriScene(
         noriMesh("square.obj", "<emitter type='area'>\n<color name='radiance' value='1 1 -1'/></emitter>")),
     "scene.xml:3:1: radiance is -1; give 0 to 1e12"},
    {"HugeRadiance", light("constant", "<color name='radiance' value='1e30 0 0'/>"),
     "scene.xml:3:2: radiance is 1e+30; give 0 to 1e12"},
    {"PointWithoutPower", light("point", "<point name='position' value='0 0 0'/>"),
     "scene.xml:2:1: a point light needs its power (W) or its intensity (W/sr); give one"},
    {"PointOfBoth",
     light("point", "<color name='power' value='1 1 1'/><color name='intensity' value='1 1 1'/>"),
     "scene.xml:2:1: a point light needs its power"},
    {"PointNowhere", light("point", "<color name='power' value='1 1 1'/>"),
     "scene.xml:2:1: a light without position; give <point name=\"position\""},
    {"PointFarOff",
     light("point", "<point name='position' value='0 1e20 0'/><color name='power' value='1 1 1'/>"),
     "scene.xml:3:2: position is beyond 1e+18"},
    {"NoDirection",
     light("directional", "<vector name='direction' value='0 0 0'/><color name='irradiance' value='1 1 1'/>"),
     "scene.xml:3:2: direction has length 0"},
    {"NoIrradiance", light("directional", "<vector name='direction' value='0 0 1'/>"),
     "scene.xml:2:1: a light without irradiance"},
    {"NoEnvironment", light("envmap", ""), "scene.xml:2:1: a light without filename"},
    {"MissingEnvironment", light("envmap", "<string name='filename' value='gone.exr'/>"),
     "scene.xml:3:2: there is no file 'gone.exr'; names are relative to the scene's folder"},
    {"EnvironmentOfAnotherKind", light("envmap", "<string name='filename' value='square.obj'/>"),
     "scene.xml:3:2: 'square.obj' is no environment map; give an .hdr or .exr file"},
    {"TwoConstants",
     noriScene("<emitter type='constant'><color name='radiance' value='1 1 1'/></emitter>\n"
               "<emitter type='constant'><color name='radiance' value='1 1 1'/></emitter>"),
     "scene.xml:3:1: a second light of this type"},
    {"ZeroWidth", camera("<integer name='width' value='0'/>"), "scene.xml:3:2: width is 0; give 1 or more"},
    {"NegativeHeight", camera("<integer name='height' value='-1'/>"), "scene.xml:3:2: height is -1; give 1"},
    {"ZeroFov", camera("<float name='fov' value='0'/>"),
     "scene.xml:3:2: fov is 0; give more than 0 and less than 180 degrees"},
    {"FlatFov", camera("<float name='fov' value='180'/>"), "scene.xml:3:2: fov is 180; give more than 0"},
    {"ZeroRadius", camera("<rfilter type='box'><float name='radius' value='0'/></rfilter>"),
     "scene.xml:3:22: radius is 0; give more than 0, at most 100 pixels"},
    {"ZeroStddev", camera("<rfilter type='gaussian'><float name='stddev' value='0'/></rfilter>"),
     "scene.xml:3:27: stddev is 0; give more than 0"},
    {"NoSamples",
     noriScene("<sampler type='independent'>\n<integer name='sampleCount' value='0'/></sampler>"),
     "scene.xml:3:1: sampleCount is 0; give 1 or more"},
};

const std::vector<BadNori> kTransforms{
    {"UnknownStep", toWorld("<shear value='1 1 1'/>"),
     "scene.xml:4:2: unknown element <shear>; a <transform> holds translate, scale, rotate, lookat, matrix"},
    {"NearestStep", toWorld("<rotat axis='0 0 1' angle='1'/>"),
     "scene.xml:4:2: unknown element <rotat>; a "
     "<transform> holds translate, scale, rotate, lookat, "
     "matrix, did you mean 'rotate'?"},
    {"StepAttribute", toWorld("<rotate axis='0 0 1' degrees='1'/>"),
     "scene.xml:4:2: <rotate> has an unknown attribute 'degrees'; it has axis, angle"},
    {"NoStepAttribute", toWorld("<rotate axis='0 0 1'/>"),
     "scene.xml:4:2: <rotate> has no attribute 'angle'"},
    {"StepInAStep", toWorld("<scale value='1 1 1'>\n<scale/></scale>"),
     "scene.xml:5:1: <scale> in a <scale>, which holds no elements"},
    {"TwoOfAVector", toWorld("<scale value='2 2'/>"),
     "scene.xml:4:2: scale value: '2 2' is 2 numbers; give three, x y z"},
    {"NoAxis", toWorld("<rotate axis='0 0 0' angle='1'/>"),
     "scene.xml:4:2: rotate about an axis of length 0"},
    {"Singular", toWorld("<scale value='1 0 1'/>"), "scene.xml:3:1: the transform is singular"},
    {"SingularMatrix", toWorld("<matrix value='1 2 3 0  2 4 6 0  0 0 1 0  0 0 0 1'/>"),
     "scene.xml:3:1: the transform is singular"},
    {"Overflow",
     toWorld("<scale value='1e38 1e38 1e38'/>"
             "<scale value='1e38 1e38 1e38'/><scale value='1e38 1e38 1e38'/>"
             "<scale value='1e38 1e38 1e38'/><scale value='1e38 1e38 1e38'/>"),
     "scene.xml:3:1: the transform is not finite"},
    {"FarOff", toWorld("<translate value='0 0 1e19'/>"),
     "scene.xml:3:1: toWorld moves a vertex beyond 1e+18"},
    {"ShortMatrix", toWorld("<matrix value='1 2 3'/>"),
     "scene.xml:4:2: a matrix of 3 numbers; give 16, four rows of four"},
    {"Projection", toWorld("<matrix value='1 0 0 0  0 1 0 0  0 0 1 0  0 0 1 0'/>"),
     "scene.xml:4:2: the matrix is a projection; its last row must be 0 0 0 1"},
    {"ValueAndSteps",
     noriScene(noriMesh("square.obj",
                        "\n<transform name='toWorld' value='1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1'>"
                        "<scale value='1 1 1'/></transform>")),
     "scene.xml:3:1: a transform with a value and with steps; give one of them"},
    {"UpAlongTheView",
     camera("<transform name='toWorld'>\n<lookat origin='0 0 0' target='0 5 0' up='0 1 0'/>"
            "</transform>"),
     "scene.xml:4:1: lookat: up is 0 or parallel to the view; give another one"},
    {"NoUp", toWorld("<lookat origin='0 0 0' target='0 5 0' up='0 0 0'/>"),
     "scene.xml:4:2: lookat: up is 0 or parallel"},
    {"NoView", toWorld("<lookat origin='1 2 3' target='1 2 3' up='0 1 0'/>"),
     "scene.xml:4:2: lookat from a point to itself"},
    {"StretchedCamera", camera("<transform name='toWorld'><scale value='1 2 1'/></transform>"),
     "scene.xml:3:2: the camera's toWorld distorts the picture"},
    {"ShearedCamera",
     camera("<transform name='toWorld'><matrix value='1 .6 0 0  0 .8 0 0  0 0 1 0  0 0 0 1'/></transform>"),
     "scene.xml:3:2: the camera's toWorld distorts the picture"},
    {"CameraFarOff", camera("<transform name='toWorld'><translate value='1e20 0 0'/></transform>"),
     "scene.xml:3:2: the camera is beyond 1e+18"},
};

const auto kNameOfBadFile = [](const auto& info) { return std::string(info.param.name); };
INSTANTIATE_TEST_SUITE_P(Syntax, BadNoriTest, testing::ValuesIn(kSyntax), kNameOfBadFile);
INSTANTIATE_TEST_SUITE_P(Objects, BadNoriTest, testing::ValuesIn(kObjects), kNameOfBadFile);
INSTANTIATE_TEST_SUITE_P(Properties, BadNoriTest, testing::ValuesIn(kProperties), kNameOfBadFile);
INSTANTIATE_TEST_SUITE_P(Transforms, BadNoriTest, testing::ValuesIn(kTransforms), kNameOfBadFile);

TEST(BadNoriFile, EntitiesAreNotExpanded) {
  std::string dtd = "<!DOCTYPE scene [\n<!ENTITY a0 'lol'>\n";
  for (int i = 1; i < 30; ++i) {
    const std::string before = "&a" + std::to_string(i - 1) + ";";
    dtd += "<!ENTITY a" + std::to_string(i) + " '" + before + before + before + before + "'>\n";
  }
  dtd += "]>\n";
  const NoriFolder folder;
  EXPECT_EQ(folder.error(dtd + noriScene("")), "");
  const std::string what = folder.error(dtd + noriScene("<mesh type='&a29;'/>"));
  EXPECT_NE(what.find("unknown mesh type '&a29;'"), std::string::npos) << what;
}

TEST(BadNoriFile, DeepFilesAreRefused) {
  const NoriFolder folder;
  std::string deep;
  for (int i = 0; i < 1000000; ++i) {
    deep += "<scene>";
  }
  EXPECT_TRUE(folder.error(deep).starts_with("scene.xml:1:7000000: no XML: an element is not closed"));
  for (int i = 0; i < 1000000; ++i) {
    deep += "</scene>";
  }
  const std::string what = folder.error(deep);
  EXPECT_TRUE(what.starts_with("scene.xml:1:449: elements in elements, 65 deep")) << what;
}

TEST(BadNoriFile, LongAndOddWordsStayShortAndPrintable) {
  const NoriFolder folder;
  const std::string what =
      folder.error(noriScene("<mesh type='\x1b[31m" + std::string(1000000, 'x') + "'/>"));
  EXPECT_LT(what.size(), 300U);
  EXPECT_EQ(what.find('\x1b'), std::string::npos);
}

TEST(BadNoriFile, ManyElementsAreRead) {
  const NoriFolder folder;
  std::string meshes;
  for (int i = 0; i < 3000; ++i) {
    meshes += noriMesh("square.obj");
  }
  const auto [scene, report] = folder.load(noriScene(meshes));
  EXPECT_EQ(scene.materials.size(), 3001U);
  EXPECT_EQ(report.droppedDuplicates, 6000U) << "3001 squares of two triangles at one place";
}

/// Every object and step once.
const std::string kRich =
    R"(<?xml version='1.0'?><scene><integrator type="path"/><sampler type="independent"/>
<camera type="perspective"><transform name="toWorld"><lookat origin="0,0,5" target="0,0,0" up="0,1,0"/>
</transform><rfilter type="box"/></camera><mesh type="obj"><string name="filename" value="plane.obj"/>
<transform name="toWorld"><scale value="2,-1,2"/><rotate axis="0 0 1" angle="9"/></transform>
<bsdf type="phong"><color name="ks" value=".1 .2 .3"/></bsdf></mesh></scene>)";

TEST(BadNoriFile, EveryCutOfAFileIsAnError) {
  const NoriFolder folder;
  EXPECT_EQ(folder.error(kRich), "");
  for (std::size_t end = 0; end < kRich.size(); ++end) {
    EXPECT_NE(folder.error(kRich.substr(0, end)), "") << end;
  }
}

TEST(BadNoriFile, EveryChangedByteIsAnErrorOrAScene) {
  const NoriFolder folder;
  for (std::size_t i = 0; i < kRich.size(); ++i) {
    for (const char c : {'\0', '<', '"', '9'}) {
      std::string changed = kRich;
      changed[i] = c;
      static_cast<void>(folder.error(changed));
    }
  }
}

} // namespace
} // namespace vkpt::test
