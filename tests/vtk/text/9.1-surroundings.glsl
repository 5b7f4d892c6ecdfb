//--- vertex
//VTK::System::Dec

/*=========================================================================

  Program:   Visualization Toolkit
  Module:    vtkPolyDataVS.glsl

  Copyright (c) Ken Martin, Will Schroeder, Bill Lorensen
  All rights reserved.
  See Copyright.txt or http://www.kitware.com/Copyright.htm for details.

     This software is distributed WITHOUT ANY WARRANTY; without even
     the implied warranty of MERCHANTABILITY or FITNESS FOR A PARTICULAR
     PURPOSE.  See the above copyright notice for more information.

=========================================================================*/

in vec4 vertexMC;



// frag position in VC
out vec4 vertexVCVSOutput;

// optional normal declaration
//VTK::Normal::Dec
in vec3 normalMC;
uniform mat3 normalMatrix;
out vec3 normalVCVSOutput;

// extra lighting parameters
//VTK::Light::Dec

// Texture coordinates
//VTK::TCoord::Dec

// material property values
in vec4 scalarColor;
out vec4 vertexColorVSOutput;

// clipping plane vars
//VTK::Clip::Dec

// camera and actor matrix values
uniform mat4 MCDCMatrix;
uniform mat4 MCVCMatrix;

// Apple Bug
//VTK::PrimID::Dec

// Value raster
//VTK::ValuePass::Dec

// picking support
//VTK::Picking::Dec

void main()
{
  //VTK::CustomBegin::Impl

  vertexColorVSOutput = scalarColor;

  normalVCVSOutput = normalMatrix * normalMC;
//VTK::Normal::Impl

  //VTK::TCoord::Impl

  //VTK::Clip::Impl

  //VTK::PrimID::Impl

  vertexVCVSOutput = MCVCMatrix * vertexMC;
  gl_Position = MCDCMatrix * vertexMC;


  //VTK::ValuePass::Impl

  //VTK::Light::Impl

  //VTK::Picking::Impl

  //VTK::CustomEnd::Impl
}

//--- fragment
//VTK::System::Dec

/*=========================================================================

  Program:   Visualization Toolkit
  Module:    vtkPolyDataFS.glsl

  Copyright (c) Ken Martin, Will Schroeder, Bill Lorensen
  All rights reserved.
  See Copyright.txt or http://www.kitware.com/Copyright.htm for details.

     This software is distributed WITHOUT ANY WARRANTY; without even
     the implied warranty of MERCHANTABILITY or FITNESS FOR A PARTICULAR
     PURPOSE.  See the above copyright notice for more information.

=========================================================================*/
// Template for the polydata mappers fragment shader

uniform int PrimitiveIDOffset;



// VC position of this fragment
in vec4 vertexVCVSOutput;

// Camera prop
uniform int cameraParallel;


// optional color passed in from the vertex shader, vertexColor
uniform float ambientIntensity; // the material ambient
uniform float diffuseIntensity; // the material diffuse
uniform float opacityUniform; // the fragment opacity
uniform vec3 ambientColorUniform; // ambient color
uniform vec3 diffuseColorUniform; // diffuse color
uniform float specularIntensity; // the material specular intensity
uniform vec3 specularColorUniform; // intensity weighted color
uniform float specularPowerUniform;
in vec4 vertexColorVSOutput;


// optional surface normal declaration
//VTK::Normal::Dec
uniform mat3 normalMatrix;
in vec3 normalVCVSOutput;

// extra lighting parameters
//VTK::Define::Dec
uniform vec3 lightColor0;

uniform mat3 envMatrix;uniform sampler2D brdfTex;
uniform samplerCube prefilterTex;
uniform samplerCube irradianceTex;

const float PI = 3.14159265359;
const float recPI = 0.31830988618;
uniform float metallicUniform;
uniform float roughnessUniform;
uniform vec3 emissiveFactorUniform;
uniform float aoStrengthUniform;
uniform float baseF0Uniform;
uniform vec3 edgeTintUniform;
#ifdef ANISOTROPY
uniform float anisotropyUniform;
#endif
#ifdef CLEAR_COAT
uniform float coatF0Uniform;
uniform float coatStrengthUniform;
uniform float coatRoughnessUniform;
uniform vec3 coatColorUniform;
#endif
float D_GGX(float NdH, float roughness)
{
  float a = roughness * roughness;
  float a2 = a * a;
  float d = (NdH * a2 - NdH) * NdH + 1.0;
  return a2 / (PI * d * d);
}
float V_SmithCorrelated(float NdV, float NdL, float roughness)
{
  float a2 = roughness * roughness;
  float ggxV = NdL * sqrt(a2 + NdV * (NdV - a2 * NdV));
  float ggxL = NdV * sqrt(a2 + NdL * (NdL - a2 * NdL));
  return 0.5 / (ggxV + ggxL);
}
vec3 F_Schlick(vec3 F0, vec3 F90, float HdL)
{
  return F0 + (F90 - F0) * pow(1.0 - HdL, 5.0);
}
vec3 DiffuseLambert(vec3 albedo)
{
  return albedo * recPI;
}
vec3 SpecularIsotropic(float NdH, float NdV, float NdL, float HdL, float roughness,
  vec3 F0, vec3 F90, out vec3 F)
{
  float D = D_GGX(NdH, roughness);
  float V = V_SmithCorrelated(NdV, NdL, roughness);
  F = F_Schlick(F0, F90, HdL);
  return (D * V) * F;
}
#ifdef ANISOTROPY
// Anisotropy functions
float D_GGX_Anisotropic(float at, float ab, float TdH, float BdH, float NdH)
{
  float a2 = at * ab;
  vec3 d = vec3(ab * TdH, at * BdH, a2 * NdH);
  float d2 = dot(d, d);
  float b2 = a2 / d2;
  return a2 * b2 * b2 * recPI;
}
float V_SmithGGXCorrelated_Anisotropic(float at, float ab, float TdV, float BdV,
  float TdL, float BdL, float NdV, float NdL)
{
  float lambdaV = NdL * length(vec3(at * TdV, ab * BdV, NdV));
  float lambdaL = NdV * length(vec3(at * TdL, ab * BdL, NdL));
  return 0.5 / (lambdaV + lambdaL);
}
vec3 SpecularAnisotropic(float at, float ab, vec3 l, vec3 t, vec3 b, vec3 h, float TdV,
  float BdV, float NdH, float NdV, float NdL, float HdL, float roughness, float anisotropy,
  vec3 F0, vec3 F90, out vec3 F)
{
  float TdL = dot(t, l);
  float BdL = dot(b, l);
  float TdH = dot(t, h);
  float BdH = dot(b, h);
  // specular anisotropic BRDF
  float D = D_GGX_Anisotropic(at, ab, TdH, BdH, NdH);
  float V = V_SmithGGXCorrelated_Anisotropic(at, ab, TdV, BdV, TdL, BdL, NdV, NdL);
  F = F_Schlick(F0, F90, HdL);
  return (D * V) * F;
}
#endif


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
  vec4 vertexVC = vertexVCVSOutput;

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

    vec3 specularColor = specularIntensity * specularColorUniform;
  float specularPower = specularPowerUniform;
  vec3 ambientColor = ambientIntensity * vertexColorVSOutput.rgb;
  vec3 diffuseColor = diffuseIntensity * vertexColorVSOutput.rgb;
  float opacity = opacityUniform * vertexColorVSOutput.a;

  //VTK::Edges::Impl

  // Generate the normal if we are not passed in one
  vec3 normalVCVSOutput = normalize(normalVCVSOutput);
  if (gl_FrontFacing == false) { normalVCVSOutput = -normalVCVSOutput; }
//VTK::Normal::Impl

    const float prefilterMaxLevel = float(4);
vec3 albedo = diffuseColor;
  float roughness = roughnessUniform;
  float metallic = metallicUniform;
  float ao = 1.0;
  vec3 emissiveColor = vec3(0.0);
  vec3 N = normalVCVSOutput;
  vec3 V = normalize(-vertexVC.xyz);
  float NdV = clamp(dot(N, V), 1e-5, 1.0);
  vec3 irradiance = texture(irradianceTex, envMatrix*N).rgb;
  vec3 worldReflect = normalize(envMatrix*reflect(-V, N));
  vec3 prefilteredSpecularColor = textureLod(prefilterTex, worldReflect, roughness * prefilterMaxLevel).rgb;
  vec2 brdf = texture(brdfTex, vec2(NdV, roughness)).rg;
  vec3 Lo = vec3(0.0);
  vec3 F0 = mix(vec3(baseF0Uniform), albedo, metallic);
  float f90 = clamp(dot(F0, vec3(50.0 * 0.33)), 0.0, 1.0);
  vec3 F90 = mix(vec3(f90), edgeTintUniform, metallic);
  vec3 L, H, radiance, F, specular, diffuse;
  float NdL, NdH, HdL, distanceVC, attenuation, D, Vis;

specular = SpecularIsotropic(NdV, NdV, NdV, 1.0, roughness, F0, F90, F);
  diffuse = (1.0 - metallic) * (1.0 - F) * DiffuseLambert(albedo);
  radiance = lightColor0;
  Lo += radiance * (diffuse + specular) * NdV;

  // In IBL, we assume that v=n, so the amount of light reflected is
  // the reflectance F0
  vec3 specularBrdf = F0 * brdf.r + F90 * brdf.g;
  vec3 iblSpecular = prefilteredSpecularColor * specularBrdf;
  vec3 iblDiffuse = (1.0 - F0) * (1.0 - metallic) * irradiance * albedo;
  vec3 color = iblDiffuse + iblSpecular;

  color += Lo;
  color = mix(color, color * ao, aoStrengthUniform);
  color += emissiveColor;
  color = pow(color, vec3(1.0/2.2));
  gl_FragData[0] = vec4(color, opacity);
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

