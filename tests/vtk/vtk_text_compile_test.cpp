// The same with a driver: what is spliced into every version's text compiles, and what the VTK that runs writes is one
// of the texts that are kept here.
#include <gmock/gmock.h>
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkRenderer.h>
#include <vtkShader.h>
#include <vtkShaderProgram.h>
#include <vtkShaderProperty.h>
#include <vtkSmartPointer.h>
#include <vtkVersion.h>

#include "filters/vtk/surface/vtk_text_forms.h"
#include "tests/support/gpu_window.h"
#include "tests/support/scene_picture.h"
#include "tests/vtk/texts.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;
using testing::HasSubstr;

bool compiles(vtkOpenGLRenderWindow* window, const ShaderSources& sources) {
  std::map<vtkShader::Type, vtkSmartPointer<vtkShader>> kept;
  std::map<vtkShader::Type, vtkShader*> shaders;
  const auto add = [&](vtkShader::Type type, const std::string& source) {
    kept[type] = vtkSmartPointer<vtkShader>::New();
    kept[type]->SetType(type);
    kept[type]->SetSource(source);
    shaders[type] = kept[type];
  };
  add(vtkShader::Vertex, sources.vertex);
  add(vtkShader::Geometry, sources.geometry);
  add(vtkShader::Fragment, sources.fragment);
  const vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(shaders);
  return program != nullptr && const_cast<vtkShaderProgram*>(program)->GetCompiled();
}

TEST(VtkTextCompile, EveryVersionsTextCompilesWithWhatIsSplicedIn) {
  const auto window = makeWindow();
  for (const std::string& version : textVersions()) {
    for (const char* text : {"lamps", "surroundings"}) {
      EXPECT_TRUE(compiles(window, fixture(version, text))) << version << " " << text;
      for (const NamedProgram& wanted : programsFor(text[0] == 'l' ? 2 : 1)) {
        ShaderSources sources = fixture(version, text);
        ASSERT_EQ(splicePbr(sources, wanted.program(), true).failure, "");
        EXPECT_TRUE(compiles(window, sources)) << version << " " << text << " " << wanted.name;
      }
    }
  }
}

TEST(VtkTextCompile, WhatRunsIsOneOfTheTexts) {
  const auto window = makeWindow();
  const auto running = runningText(window);
  for (const char* text : {"lamps", "surroundings"}) {
    std::string fragment = running.at(text).fragment;
    const std::string written = shadingOf(fragment);
    int like = 0;
    for (const std::string& version : textVersions()) like += shadingOf(fixture(version, text).fragment) == written;
    EXPECT_GE(like, 1) << "VTK " << vtkVersion::GetVTKVersion() << " writes a text that is not among the fixtures for "
                       << text << ": see tests/vtk/README.md";
    AnchorEdits edits;
    normalizeForms(fragment, edits);
    std::string reference = fixture("9.1", text).fragment;
    EXPECT_EQ(shadingOf(fragment), shadingOf(reference));
  }
}

// An object that VTK lights, whose program a change of VTK's text has left without any known line.
TEST(VtkTextCompile, AnObjectLitWithoutAMarkIsAnErrorOfTheRenderer) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 32, 32);
  picture.show(picture.scene.cameras.front());
  ASSERT_EQ(picture.renderer->error(), "");
  vtkActorCollection* actors = picture.renderer->renderer()->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor()) {
    actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
                                                             "gl_FragData[0] = vec4(diffuseColor, opacity);\n", false);
  }
  picture.display();
  EXPECT_THAT(picture.renderer->error(), HasSubstr(std::string("VTK ") + vtkVersion::GetVTKVersion()));
  EXPECT_THAT(picture.renderer->error(), HasSubstr("physically based shading"));
}

}  // namespace
