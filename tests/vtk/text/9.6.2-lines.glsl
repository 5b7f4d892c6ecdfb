//--- vertex
//VTK::System::Dec

// SPDX-FileCopyrightText: Copyright (c) Ken Martin, Will Schroeder, Bill Lorensen
// SPDX-License-Identifier: BSD-3-Clause

in vec4 vertexMC;



// frag position in VC
//VTK::PositionVC::Dec

// optional normal declaration
//VTK::Normal::Dec

// extra lighting parameters
//VTK::Light::Dec

// Texture coordinates
//VTK::TCoord::Dec

// material property values
//VTK::Color::Dec

// clipping plane vars
//VTK::Clip::Dec

// camera and actor matrix values
uniform mat4 MCDCMatrix;

// Apple Bug
//VTK::PrimID::Dec

// Value raster
//VTK::ValuePass::Dec

// picking support
//VTK::Picking::Dec

// Surface with edges on GLES 3.0
//VTK::EdgesGLES30::Dec

// PointSize on GLES 3.0
//VTK::PointSizeGLES30::Dec

// LineWidth on GLES 3.0
//VTK::LineWidthGLES30::Dec

void main()
{
  //VTK::CustomBegin::Impl

  //VTK::PointSizeGLES30::Impl

  //VTK::Color::Impl

  //VTK::Normal::Impl

  //VTK::TCoord::Impl

  //VTK::Clip::Impl

  //VTK::PrimID::Impl

    gl_Position = MCDCMatrix * vertexMC;


  //VTK::LineWidthGLES30::Impl

  //VTK::ValuePass::Impl

  //VTK::Light::Impl

  //VTK::Picking::Impl

  //VTK::CustomEnd::Impl

  //VTK::EdgesGLES30::Impl
}

//--- fragment
//VTK::System::Dec

// SPDX-FileCopyrightText: Copyright (c) Ken Martin, Will Schroeder, Bill Lorensen
// SPDX-License-Identifier: BSD-3-Clause
// Template for the polydata mappers fragment shader

uniform int PrimitiveIDOffset;



// VC position of this fragment
//VTK::PositionVC::Dec

// Camera prop
uniform int cameraParallel;


// optional color passed in from the vertex shader, vertexColor
uniform float ambientIntensity; // the material ambient
uniform float diffuseIntensity; // the material diffuse
uniform float opacityUniform; // the fragment opacity
uniform vec3 ambientColorUniform; // ambient color
uniform vec3 diffuseColorUniform; // diffuse color


// optional surface normal declaration
//VTK::Normal::Dec

// extra lighting parameters
uniform vec3 lightColor0;
  uniform vec3 lightDirectionVC0; // normalized


// Texture maps
//VTK::TMap::Dec

// Texture coordinates
//VTK::TCoord::Dec

// picking support
//VTK::Picking::Dec

// Depth Peeling Support
//VTK::DepthPeeling::Dec

// clipping plane vars
//VTK::Clip::Dec

// the output of this shader
//VTK::Output::Dec

// Apple Bug
//VTK::PrimID::Dec

// handle coincident offsets
//VTK::Coincident::Dec

// Value raster
//VTK::ValuePass::Dec

// surface with edges
//VTK::Edges::Dec

void main()
{
  // VC position of this fragment. This should not branch/return/discard.
  //VTK::PositionVC::Impl

  // Place any calls that require uniform flow (e.g. dFdx) here.
  //VTK::UniformFlow::Impl

  // Set gl_FragDepth here (gl_FragCoord.z by default)
  //VTK::Depth::Impl

  // Early depth peeling abort:
  //VTK::DepthPeeling::PreColor

  // Apple Bug
  //VTK::PrimID::Impl

  //VTK::Clip::Impl

  //VTK::ValuePass::Impl

    vec3 ambientColor = ambientIntensity * ambientColorUniform;
  vec3 diffuseColor = diffuseIntensity * diffuseColorUniform;
  float opacity = opacityUniform;


  //VTK::Edges::Impl

  // Generate the normal if we are not passed in one
  //VTK::Normal::Impl

  //VTK::PBR::Impl

    gl_FragData[0] = vec4(ambientColor + diffuseColor, opacity);
    gl_FragData[0].rgb = pow(gl_FragData[0].rgb, vec3(1.0/2.2));
  //VTK::Light::Impl



  

  if (gl_FragData[0].a <= 0.0)
    {
    discard;
    }

  //VTK::DepthPeeling::Impl

  //VTK::Picking::Impl

  // handle coincident offsets
  //VTK::Coincident::Impl
}

